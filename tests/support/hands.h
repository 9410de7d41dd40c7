#pragma once

#include <map>
#include <memory>
#include <string>

#include "preshape/base/random.h"
#include "preshape/hand/posture.h"
#include "preshape/script/script.h"
#include "preshape/workbench/catalogue.h"
#include "support/data.h"
#include "support/registry.h"

namespace preshape::test {

/// A hand by its description file.
inline std::shared_ptr<const HandModel> hand_of(const std::filesystem::path& file) {
  ScriptOptions options;
  options.module_roots = {source_file("scripts")};
  const Value description = Script(file, options).run();
  return registry().create<HandModel>(description.find("model")->string(), Value::table({{"description", description}}));
}

/// Every hand in hands/, by its name.
inline const std::map<std::string, std::shared_ptr<const HandModel>>& shipped_hands() {
  static const auto hands = [] {
    std::map<std::string, std::shared_ptr<const HandModel>> all;
    for (const auto& name : Catalogue({source_file(".")}).hands()) all[name] = hand_of(source_file("hands") / name / "hand.lua");
    return all;
  }();
  return hands;
}

/// Every drive anywhere in its range, followers with their leaders.
inline Posture random_posture(const HandModel& hand, Random& random) {
  Posture posture(hand.joints().size(), 0.0);
  for (const int joint : driven_joints(hand)) {
    const DriveRange range = drive_range(hand, joint);
    posture[static_cast<std::size_t>(joint)] = random.uniform(range.lower, range.upper);
  }
  apply_couplings(hand, posture);
  return posture;
}

/// Where a fingertip is in H.
inline Eigen::Vector3d tip(const HandModel& hand, int finger, const Posture& posture) {
  return finger_poses(hand, finger, posture).back().p;
}

}  // namespace preshape::test
