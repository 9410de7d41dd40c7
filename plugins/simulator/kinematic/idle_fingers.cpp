#include "idle_fingers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace preshape::kinematic {

namespace {

/// The drives that move any joint of a finger.
std::set<int> drives_of(const HandModel& hand, int finger) {
  const preshape::Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  std::set<int> drives;
  for (int joint = about.first_joint; joint < about.first_joint + about.joint_count; ++joint) {
    const int leader = hand.joints()[static_cast<std::size_t>(joint)].leader;
    drives.insert(leader < 0 ? joint : leader);
  }
  return drives;
}

/// How far a finger is opened: away from the other side of the hand and back to the palm, and straight on as seen from the
/// palm, so that it does not run into its neighbours.
double openness(const HandModel& hand, int finger, const Posture& posture) {
  const bool thumb = hand.fingers()[static_cast<std::size_t>(finger)].role == FingerRole::kThumb;
  const Eigen::Vector3d away(0.0, thumb ? -1.0 : 1.0, -1.0);
  const auto poses = finger_poses(hand, finger, posture);
  double opened = 0.0;
  for (const Pose& pose : poses) opened += away.dot(pose.p);
  return opened - 2.0 * std::abs(poses.back().p.x() - poses.front().p.x());
}

}  // namespace

IdleFingers::IdleFingers(const SimulationTask& task, const Bodies& bodies, const Assignment& assignment, std::uint64_t seed)
    : task_(task), bodies_(bodies) {
  Random random(seed);
  std::set<int> taken;
  for (const int finger : assignment) taken.merge(drives_of(task.hand, finger));
  for (int index = 0; index < static_cast<int>(task.hand.fingers().size()); ++index) {
    if (std::find(assignment.begin(), assignment.end(), index) != assignment.end()) continue;
    Finger finger{index, {}, {}};
    for (const int drive : drives_of(task.hand, index)) {
      if (!taken.contains(drive)) finger.drives.push_back(drive);
    }
    draw(finger, random);
    fingers_.push_back(std::move(finger));
  }
}

/// Many postures are drawn; the most opened of them and some from all over the ranges are kept.
void IdleFingers::draw(Finger& finger, Random& random) const {
  constexpr std::size_t kDraws = 400, kKept = 12;
  std::vector<std::pair<double, std::vector<double>>> drawn;
  Posture posture = middle_posture(task_.hand);
  for (std::size_t i = 0; i < kDraws; ++i) {
    std::vector<double> values;
    for (const int drive : finger.drives) {
      const DriveRange range = drive_range(task_.hand, drive);
      values.push_back(random.uniform(range.lower, range.upper));
    }
    set(finger, values, posture);
    drawn.emplace_back(-openness(task_.hand, finger.index, posture), std::move(values));
  }
  std::sort(drawn.begin(), drawn.end());
  for (std::size_t i = 0; i < kKept; ++i) finger.aside.push_back(drawn[i].second);
  for (std::size_t i = 1; i < kKept; ++i) finger.aside.push_back(drawn[i * kDraws / kKept].second);
}

void IdleFingers::set(const Finger& finger, const std::vector<double>& values, Posture& posture) const {
  for (std::size_t i = 0; i < values.size(); ++i) posture[static_cast<std::size_t>(finger.drives[i])] = values[i];
  apply_couplings(task_.hand, posture);
}

void IdleFingers::set(const Finger& finger, const std::vector<double>& values, Hold& hold) const {
  set(finger, values, hold.open);
  set(finger, values, hold.grasp);
}

void IdleFingers::open(Hold& hold) const {
  for (const Finger& finger : fingers_) set(finger, finger.aside.front(), hold);
}

bool IdleFingers::have(const Collision& collision) const {
  const auto of_idle = [&](int solid) {
    return solid >= 0 && std::any_of(fingers_.begin(), fingers_.end(), [&](const Finger& finger) {
             return task_.hand.solids()[static_cast<std::size_t>(solid)].finger == finger.index;
           });
  };
  return of_idle(collision.solid) || of_idle(collision.other);
}

bool IdleFingers::put_aside(Hold& hold) const {
  return std::all_of(fingers_.begin(), fingers_.end(), [&](const Finger& finger) {
    return std::any_of(finger.aside.begin(), finger.aside.end(), [&](const std::vector<double>& values) {
      set(finger, values, hold);
      return bodies_.finger_is_free(hold.X_OH, hold.grasp, finger.index) && bodies_.finger_is_free(hold.X_OH, hold.open, finger.index);
    });
  });
}

}  // namespace preshape::kinematic
