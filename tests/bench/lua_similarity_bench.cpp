// What a similarity in Lua costs: a whole exploration with tfvadi_lua against the same with its C++ twin tfvadi, in one
// process, in pairs, so that a machine's moods fall on both. Prints the ratio of each pair's times.
#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "preshape/plugin/fingerprint.h"
#include "preshape/script/script.h"
#include "preshape/version.h"
#include "preshape/workbench/components.h"
#include "preshape/workbench/session.h"

using namespace preshape;

namespace {

constexpr int kPairs = 15;
constexpr std::uint64_t kSeed = 1;

const Catalogue& catalogue() {
  static const Catalogue catalogue({PRESHAPE_SOURCE_DIR});
  return catalogue;
}

const Registry& registry() {
  static const std::vector<std::filesystem::path> build = {PRESHAPE_BINARY_DIR "/lib/preshape/plugins"};
  static const auto registry = open_registry(catalogue(), build);
  return *registry;
}

/// A session that explores one object for one task, all stations included.
Session session_of(const std::string& object, const std::string& similarity) {
  const std::string text = fmt::format(
      "return {{ object = '{}', task = 'T1_5', similarity = '{}', pretrain = 'none', memory = ':memory:', seed = {} }}", object,
      similarity, kSeed);
  auto reading = read_scenario(Script::from_text(text, "bench.lua").run(), "bench.lua", ScenarioUse::kRun, registry(), catalogue());
  if (!reading.mistakes.empty()) throw InputError(reading.mistakes.front().text());
  return Session(std::move(reading.scenario), registry(), catalogue(), {":memory:", nullptr, nullptr});
}

/// Seconds that one exploration takes, and what it found.
struct Run {
  double seconds = 0.0, score = 0.0;
  std::int64_t evaluations = 0;
};

Run explore(const Session& session) {
  const auto begin = std::chrono::steady_clock::now();
  const auto exploration = session.best();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  return {passed.count(), exploration.best ? exploration.best->criticism.first : 0.0, exploration.evaluations};
}

void compare(const std::string& object) {
  const Session compiled = session_of(object, "tfvadi"), scripted = session_of(object, "tfvadi_lua");
  std::vector<double> ratios, seconds;
  Run first, second;
  for (int i = 0; i <= kPairs; ++i) {
    first = explore(compiled);
    second = explore(scripted);
    if (first.score != second.score) throw InputError("the twins do not agree");
    if (i == 0) continue;  // caches are cold
    ratios.push_back(second.seconds / first.seconds);
    seconds.push_back(first.seconds);
  }
  std::sort(ratios.begin(), ratios.end());
  std::sort(seconds.begin(), seconds.end());
  fmt::print("{:<10} {:>5} stations   C++ {:8.3f} ms   ratio Lua/C++ median {:.2f}, least {:.2f}, most {:.2f}\n", object,
             first.evaluations, 1e3 * seconds[seconds.size() / 2], ratios[ratios.size() / 2], ratios.front(), ratios.back());
}

}  // namespace

int main() {
  fmt::print("exploration with similarity tfvadi_lua against tfvadi: preshape {}, {}, {} build, seed {}, {} pairs\n",
             PRESHAPE_VERSION_STRING, fingerprint_text(host_fingerprint()), PRESHAPE_BUILD_TYPE, kSeed, kPairs);
  try {
    for (const char* object : {"cube", "mug", "dolphin"}) compare(object);
  } catch (const Error& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 1;
  }
}
