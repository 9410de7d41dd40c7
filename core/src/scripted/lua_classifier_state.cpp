#include "lua_classifier_state.h"

#include <charconv>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "preshape/script/script.h"
#include "preshape/script/setting.h"

namespace preshape::scripted {

namespace {

constexpr std::string_view kFormat = "preshape-lua-classifier/1";
constexpr std::size_t kDigest = 64;

[[noreturn]] void refuse_state(const std::string& component, std::string_view what) {
  throw InputError(
      fmt::format("these bytes are no state of classifier '{}' ({}); train it anew, or give the bytes that "
                  "save gave",
                  component, what));
}

/// Takes the text up to the next `end` off the front.
std::string_view taken(std::string_view& text, char end) {
  const std::size_t length = std::min(text.find(end), text.size());
  const std::string_view head = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return head;
}

int count_of(const std::string& component, std::string_view digits) {
  int count = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (error != std::errc{} || end != digits.data() + digits.size() || count < 1)
    refuse_state(component, "a size out of bounds");
  return count;
}

}  // namespace

std::string model_text(const std::string& component, const LearnedModel& learned) {
  const std::string body = fmt::format("{} {} {} {}\n{}\n", kFormat, component, learned.features,
                                       learned.bits, lua_source(learned.model));
  return body + sha256_hex(body);
}

LearnedModel model_from(const std::string& component, std::string_view text) {
  if (!text.starts_with(kFormat)) refuse_state(component, "another beginning");
  if (text.size() < kFormat.size() + kDigest) refuse_state(component, "cut off");
  std::string_view body = text.substr(0, text.size() - kDigest);
  if (sha256_hex(body) != text.substr(body.size()))
    refuse_state(component, "the check sum does not fit: cut off or changed");
  std::string_view head = taken(body, '\n');
  taken(head, ' ');
  if (const auto owner = taken(head, ' '); owner != component)
    refuse_state(component, fmt::format("it is one of '{}'", owner));
  LearnedModel learned;
  learned.features = count_of(component, taken(head, ' '));
  learned.bits = count_of(component, head);
  ScriptOptions options;
  options.limits.memory_bytes = std::size_t{1} << 30;
  try {
    learned.model = Script::from_text("return " + std::string(body), "state.lua", std::move(options)).run();
  } catch (const ScriptError& error) {
    refuse_state(component, error.what());
  }
  return learned;
}

}  // namespace preshape::scripted
