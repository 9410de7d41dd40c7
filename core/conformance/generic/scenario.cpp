// A component in its place: a whole run with everything else as shipped.
#include <algorithm>

#include "generic.h"
#include "preshape/base/error.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/workbench/components.h"
#include "preshape/workbench/session.h"

namespace preshape::conformance {

namespace {

/// Thresholds for a similarity with a scale of its own.
Value thresholds_for(const Similarity& measure) {
  const SimilarityScale scale = measure.scale(7);
  const double share = scale.farthest + 0.7 * (scale.nearest - scale.farthest);
  return Value::table({{"estimation", share}, {"recognition", share}});
}

bool has(const Registry& registry, std::string_view kind, std::string_view name) {
  const auto keys = registry.components();
  return std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return key.kind == kind && key.name == name; });
}

Value description_of(Context& context, const Registry& registry) {
  const Subject& subject = context.subject();
  Value chosen = context.parameters();
  if (chosen.is_nil()) chosen = Value::table({});
  chosen.set("name", subject.name);
  Value description = Value::table({{"object", "cube"}, {"task", "T1_2"}, {"memory", ":memory:"}});
  if (subject.kind == "hand") {
    chosen.set("model", subject.name);
    chosen.erase("name");
  }
  // The classifier reads what sta_manu gives.
  if (subject.kind == "quality") chosen = subject.name == "sta_manu" ? Value::list({chosen}) : Value::list({"sta_manu", chosen});
  // A measure may ask what a contact can bear, which the default model does not say.
  if (subject.kind == "quality" && has(registry, "contact", "hard_finger")) description.set("contact", "hard_finger");
  description.set(subject.kind, chosen);
  if (subject.kind == "similarity") description.set("thresholds", thresholds_for(*context.create<Similarity>()));
  return description;
}

}  // namespace

void g28_scenario(Context& context) {
  const Subject& subject = context.subject();
  if (subject.kind == "hand" && context.parameters().find("description")) context.skip("a scenario takes its hand by description");
  const Catalogue catalogue = Catalogue::standard();
  if (catalogue.objects().empty()) context.skip("no shipped objects were found to run a scenario with");
  const auto registry = open_registry(catalogue, {&subject.file, 1});
  auto reading = read_scenario(description_of(context, *registry), "conformance.lua", ScenarioUse::kRun, *registry, catalogue);
  if (!reading.mistakes.empty()) context.fail("a scenario with it is refused: {}", reading.mistakes.front().text());
  Session session(std::move(reading.scenario), *registry, catalogue, {":memory:", nullptr, nullptr});
  session.pretrain_if_empty();
  const RunRecord record = session.run();
  context.require(subject.kind != "simulator" || record.simulation || !record.report.result,
                  "the report does not tell what became of the grasp");
}

}  // namespace preshape::conformance
