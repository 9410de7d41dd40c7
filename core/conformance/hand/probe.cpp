#include "../probe.h"

#include <cmath>

#include "kinematics.h"

namespace preshape::conformance {

namespace {

const HandModel& hand_at(void* component) {
  return *static_cast<const HandModel*>(component);
}

void add(std::vector<double>& numbers, const Pose& X) {
  numbers.insert(numbers.end(), X.R.data(), X.R.data() + 9);
  numbers.insert(numbers.end(), X.p.data(), X.p.data() + 3);
}

/// Poses and Jacobian of one finger.
std::vector<double> moved(const HandModel& hand, int finger, std::span<const double> q) {
  std::vector<Pose> poses(q.size() + 2);
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, static_cast<Eigen::Index>(q.size()));
  hand.forward(finger, q, poses);
  hand.jacobian(finger, q, jacobian);
  std::vector<double> numbers(jacobian.data(), jacobian.data() + jacobian.size());
  for (const Pose& X : poses) add(numbers, X);
  return numbers;
}

void append(std::vector<double>& numbers, const std::vector<double>& more) {
  numbers.insert(numbers.end(), more.begin(), more.end());
}

class HandProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name,
                               const Value& given) const override {
    return registry.create<HandModel>(name, given);
  }
  const void* extension(void* component, const char* id) const override {
    return hand_at(component).extension(id);
  }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    const HandModel& hand = hand_at(component);
    const HandDimensions& d = hand.dimensions();
    std::vector<double> numbers = {d.unit_length_m, d.finger_spacing_m, d.maximum_opening_m, d.base_width_m};
    for (const Joint& j : hand.joints()) {  // an unknown torque is rightly NaN; -1 stands for it
      numbers.insert(numbers.end(), {j.lower, j.upper, std::isnan(j.torque_limit) ? -1.0 : j.torque_limit});
    }
    for (const LinkSolid& s : hand.solids()) {
      numbers.insert(numbers.end(), {s.solid.radius, s.solid.half_length, s.solid.half_extents.x(),
                                     s.solid.half_extents.y(), s.solid.half_extents.z()});
      add(numbers, s.X_LS);
    }
    Random random(seed);
    for (int finger = 0; finger < std::ssize(hand.fingers()); ++finger)
      append(numbers, moved(hand, finger, posture(hand, finger, random)));
    return numbers;
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    const HandModel& hand = hand_at(component);
    Random random(seed);
    std::vector<std::span<const double>> postures;
    for (int finger = 0; finger < std::ssize(hand.fingers()); ++finger) {
      const auto q = posture(hand, finger, random);
      postures.push_back(arena.keep(std::span<const double>(q)));
    }
    arena.seal();
    std::vector<double> numbers;
    for (std::size_t finger = 0; finger < postures.size(); ++finger)
      append(numbers, moved(hand, static_cast<int>(finger), postures[finger]));
    return numbers;
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    const HandModel& hand = hand_at(component);
    const std::size_t n = joints_of(hand, 0).size();
    // One call with some joint values, poses and columns, of which one number is wrong.
    const auto attempt = [&hand](std::size_t values, std::size_t poses, std::size_t columns, const char* what,
                                 std::size_t wrong, std::size_t right) {
      return Attempt{fmt::format("finger 0 with {} {} for {}", wrong, what, right),
                     [&hand, values, poses, columns] {
                       const std::vector<double> q(
                           values + 4, 0.1);  // longer, so that a plugin that does not look breaks nothing
                       std::vector<Pose> room(poses + 8);
                       Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
                           6, static_cast<Eigen::Index>(columns + 8));
                       if (columns == 0)
                         hand.forward(0, std::span(q).first(values), std::span(room).first(poses));
                       else
                         hand.jacobian(0, std::span(q).first(values),
                                       jacobian.leftCols(static_cast<Eigen::Index>(columns)));
                       return std::vector<double>{room.front().p.x()};
                     },
                     {fmt::format("{}", wrong), fmt::format("{}", right)}};
    };
    return {attempt(n + 1, n + 2, 0, "joint values", n + 1, n),
            attempt(n - 1, n + 2, 0, "joint values", n - 1, n),
            attempt(n, n + 1, 0, "poses", n + 1, n + 2),
            attempt(n, n + 3, 0, "poses", n + 3, n + 2),
            attempt(n, 0, n + 1, "columns", n + 1, n),
            attempt(n + 1, 0, n, "joint values", n + 1, n)};
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    const HandModel& hand = hand_at(component);
    std::vector<Attempt> attempts;
    for (std::size_t i = 0; i < joints_of(hand, 0).size(); ++i) {
      attempts.push_back({fmt::format("finger 0 with {} for its joint {}", number, i),
                          [&hand, i, number] {
                            std::vector<double> q(joints_of(hand, 0).size(), 0.1);
                            q[i] = number;
                            std::vector<double> numbers;
                            add(numbers, poses_at(hand, 0, q)[i + 1]);
                            return numbers;
                          },
                          {}});
    }
    return attempts;
  }
};

}  // namespace

const Probe& hand_probe() {
  static const HandProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
