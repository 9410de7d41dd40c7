#pragma once

#include <memory>
#include <string>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/hand/hand_model.h"
#include "support/registry.h"

namespace preshape::test {

/// A joint's table of a hand description.
inline Value joint_table(const std::string& name, double a, double alpha, double d, double theta,
                         const char* type = "revolute") {
  return Value::table({{"name", name}, {"type", type}, {"a", a}, {"alpha", alpha}, {"d", d}, {"theta", theta},
                       {"limits", Value::numbers({-1.5, 1.5})}});
}

inline Value finger_table(const std::string& role, Value::List joints) {
  return Value::table({{"name", role}, {"role", role},
                       {"base", Value::table({{"position", Value::numbers({0, 0, 0})}})},
                       {"joints", Value::list(std::move(joints))}});
}

inline Value hand_table(Value::List fingers) {
  return Value::table({{"model", "dh"}, {"summary", "a hand for a test"}, {"unit_length", 0.03},
                       {"finger_spacing", 0.03}, {"maximum_opening", 0.12}, {"base_width", 0.15},
                       {"fingers", Value::list(std::move(fingers))}});
}

/// A thumb and an index, each of two parallel joints and two links of length 1.
inline Value planar_hand() {
  const auto finger = [](const std::string& role) {
    return finger_table(role, {joint_table(role + "_1", 1, 0, 0, 0), joint_table(role + "_2", 1, 0, 0, 0)});
  };
  return hand_table({finger("thumb"), finger("index")});
}

inline std::shared_ptr<HandModel> make_hand(const Value& description, const SourcePlace& place = {}) {
  return registry().create<HandModel>("dh", Value::table({{"description", description}}), place);
}

/// One finger's poses in H: base, links, tip.
inline std::vector<Pose> forward(const HandModel& hand, int finger, const std::vector<double>& q) {
  std::vector<Pose> poses_H(q.size() + 2);
  hand.forward(finger, q, poses_H);
  return poses_H;
}

/// A copy of a description with fingers[index][key] replaced.
inline Value with_finger(Value description, std::size_t index, const std::string& key, Value value) {
  description.find("fingers")->items()[index].set(key, std::move(value));
  return description;
}

/// A copy of a description with fingers[0].joints[0][key] replaced.
inline Value with_joint(Value description, const std::string& key, Value value) {
  description.find("fingers")->items()[0].find("joints")->items()[0].set(key, std::move(value));
  return description;
}

inline Value with(Value description, const std::string& key, Value value) {
  description.set(key, std::move(value));
  return description;
}

}  // namespace preshape::test
