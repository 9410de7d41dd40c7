#pragma once

#include <string>

#include "preshape/agent/memory.h"
#include "preshape/base/random.h"

namespace preshape::test {

/// 64 hex digits that end in `number`.
inline std::string example_hash(int number) {
  return fmt::format("{:064x}", number);
}

inline MemoryObject example_object(int number) {
  MemoryObject object;
  object.hash = example_hash(number);
  object.name = fmt::format("object {}", number);
  object.file = fmt::format("objects/{}.obj", number);
  object.extents_m = {0.1 / 3.0, 0.25, 0.04 + number};
  object.attributes = {1.0 / 3.0, 0.683, 0.339, 2.0 / 3.0, 0.5, 1.0, 0.012};
  object.first_seen_utc = "2026-11-22T03:04:05Z";
  return object;
}

/// Every number is drawn, so that a column stored in another one's place shows.
inline Sample example_sample(int object, std::uint64_t seed) {
  Random random(seed);
  Sample sample;
  sample.object = example_hash(object);
  sample.provenance = static_cast<Provenance>(random.below(3));
  for (double& input : sample.inputs) input = random.uniform(-2, 2);
  sample.plane = 1 + static_cast<int>(random.below(12));
  sample.symbol = 1 + static_cast<int>(random.below(7));
  sample.virtual_fingers = 1 + static_cast<int>(random.below(3));
  sample.approach_m = random.uniform(-1, 1);
  sample.approach_ratio = random.uniform(-1, 1);
  for (double& component : sample.wrench) component = random.uniform(-2, 2);
  sample.score = random.uniform(0, 6);
  sample.task = fmt::format("T{}_{}", 1 + random.below(4), 1 + random.below(6));
  return sample;
}

inline ClassifierState example_state(std::int64_t last_sample) {
  ClassifierState state;
  state.component = "mlp";
  state.parameters_json = R"({"hidden": 45})";
  state.bytes = std::string("\0\xff state \n", 10) + std::to_string(last_sample);
  state.last_sample = last_sample;
  state.outcome = {TrainingOutcome::Status::kArrived, 35, 2, 9.5e-4, 1};
  state.seed = 0xfedcba9876543210u;
  return state;
}

inline bool same(const Sample& a, const Sample& b) {
  return a.object == b.object && a.provenance == b.provenance && a.inputs == b.inputs && a.plane == b.plane &&
         a.symbol == b.symbol && a.virtual_fingers == b.virtual_fingers && a.approach_m == b.approach_m &&
         a.approach_ratio == b.approach_ratio && a.wrench == b.wrench && a.score == b.score &&
         a.task == b.task;
}

}  // namespace preshape::test
