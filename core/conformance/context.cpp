#include "context.h"

#include <algorithm>

#include "fresh_process.h"
#include "preshape/base/error.h"
#include "preshape/workbench/catalogue.h"
#include "preshape/script/script.h"

namespace preshape::conformance {

namespace {

/// The description of the first shipped hand that a hand model is for; nil when there is none.
Value hand_description(const std::string& model) {
  const Catalogue catalogue = Catalogue::standard();
  for (const auto& name : catalogue.hands()) {
    const Value hand = read_description(catalogue.hand(name));
    const Value* of = hand.find("model");
    if ((of && of->is_string() ? of->string() : "dh") == model) return hand;
  }
  return {};
}

}  // namespace

Value named_description(const std::string& name) {
  const bool path = name.find_first_of("./") != std::string::npos;
  return read_description(path ? std::filesystem::path(name) : Catalogue::standard().hand(name));
}

Context::Context(const Check& check, Subject subject, Settings settings, RunningCase* running)
    : check_(check), subject_(std::move(subject)), settings_(std::move(settings)), running_(running) {}

const Registry& Context::registry() {
  if (!registry_) registry_ = registry_of(subject_.file);
  return *registry_;
}

bool Context::declares(std::string_view capability) {
  const auto& declared = record().capabilities;
  return std::find(declared.begin(), declared.end(), capability) != declared.end();
}

Value Context::parameters() {
  Value parameters = settings_.parameters;
  const ParameterDeclaration* description = record().schema.find("description");
  if (subject_.kind == "hand" && description && description->default_value.is_nil()) {
    const Value* given = parameters.find("description");
    if (hand_description_.is_nil() && !given) hand_description_ = hand_description(subject_.name);
    if (hand_description_.is_nil() && given && given->is_string()) hand_description_ = named_description(given->string());
    if (!hand_description_.is_nil()) parameters.set("description", hand_description_);
  }
  for (const auto& declaration : record().schema.declarations()) {
    if (!declaration.default_value.is_nil() || parameters.find(declaration.name)) continue;
    skip(fmt::format("it cannot be made without '{}'; give that with --set", declaration.name));
  }
  return parameters;
}

int Context::cases(int quick) const {
  return settings_.tier == Tier::kQuick ? quick : settings_.tier == Tier::kFull ? 10 * quick : 100 * quick;
}

Random Context::random(std::string_view purpose) const {
  return Random(settings_.seed).stream(fmt::format("{} {}", check_.id, purpose));
}

std::string Context::in_fresh_process(std::string_view input) {
  return ask_fresh_process(check_, subject_, settings_, input);
}

}  // namespace preshape::conformance
