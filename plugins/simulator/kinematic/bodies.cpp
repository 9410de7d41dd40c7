#include "bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preshape::kinematic {

namespace {

/// Lowest point of a solid along a direction.
double lowest_along(const PosedSolid& posed, const Eigen::Vector3d& direction) {
  const double middle = direction.dot(posed.X_OS.p);
  switch (posed.solid.kind) {
    case Solid::Kind::kSphere: return middle - posed.solid.radius;
    case Solid::Kind::kCapsule: return middle - posed.solid.radius - std::abs(direction.dot(posed.X_OS.R.col(2))) * posed.solid.half_length;
    case Solid::Kind::kBox: return middle - (posed.X_OS.R.transpose() * direction).cwiseAbs().dot(posed.solid.half_extents);
  }
  return middle;
}

/// Bound of the way that any point of a solid went from one pose to its present one: its frame's way, and its farthest
/// point's about it, 2 sin(angle / 2) rho with |R - R'|_F = 2 sqrt(2) sin(angle / 2).
double way_between(const PosedSolid& now, const Pose& before) {
  const Solid& solid = now.solid;
  const double farthest = solid.kind == Solid::Kind::kBox ? solid.half_extents.norm() : solid.radius + solid.half_length;
  return (now.X_OS.p - before.p).norm() + (now.X_OS.R - before.R).norm() / std::numbers::sqrt2 * farthest;
}

}  // namespace

Bodies::Bodies(const SimulationTask& task) : task_(task) {
  // A pair that overlaps in the middle posture and in every drawn one is built so: neighbours that share a joint's housing.
  Random random(1);
  std::vector<std::vector<PosedSolid>> postures = {posed({}, middle_posture(task.hand))};
  for (int i = 0; i < 8; ++i) {
    Posture drawn(task.hand.joints().size());
    for (const int joint : driven_joints(task.hand)) {
      const DriveRange range = drive_range(task.hand, joint);
      drawn[static_cast<std::size_t>(joint)] = random.uniform(range.lower, range.upper);
    }
    apply_couplings(task.hand, drawn);
    postures.push_back(posed({}, drawn));
  }
  for (const auto& pair : candidate_pairs()) {
    const bool always = std::all_of(postures.begin(), postures.end(), [&](const auto& solids) { return distance(solids, pair) <= 0.0; });
    if (!always) pairs_.push_back(pair);
  }
  const auto solids = task.hand.solids();
  for (int finger = 0; finger < static_cast<int>(task.hand.fingers().size()); ++finger) {
    const auto of = [&](int solid) { return solids[static_cast<std::size_t>(solid)].finger == finger; };
    auto& own = solids_of_.emplace_back();
    for (int i = 0; i < static_cast<int>(solids.size()); ++i) {
      if (of(i)) own.push_back(i);
    }
    auto& pairs = pairs_of_.emplace_back();
    for (const auto& pair : pairs_) {
      if (of(pair.first) || of(pair.second)) pairs.push_back(pair);
    }
  }
}

bool Bodies::finger_is_free(const Pose& X_OH, const Posture& posture, int finger) const {
  const auto solids_O = posed(X_OH, posture);
  std::vector<PosedSolid> own;
  for (const int solid : solids_of_[static_cast<std::size_t>(finger)]) own.push_back(solids_O[static_cast<std::size_t>(solid)]);
  if (with_support(own)) return false;
  std::vector<double> distances(own.size());
  task_.object_O.distance(own, distances);
  if (std::any_of(distances.begin(), distances.end(), [](double d) { return d <= 0.0; })) return false;
  return !with_itself(solids_O, pairs_of_[static_cast<std::size_t>(finger)]);
}

double Bodies::distance(const std::vector<PosedSolid>& solids, std::pair<int, int> pair) const {
  const PosedSolid a = solids[static_cast<std::size_t>(pair.first)], b = solids[static_cast<std::size_t>(pair.second)];
  double distance = 0.0;
  task_.collision.distance({&a, 1}, {&b, 1}, {&distance, 1});
  return distance;
}

std::vector<std::pair<int, int>> Bodies::candidate_pairs() const {
  const auto solids = task_.hand.solids();
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < solids.size(); ++a) {
    for (std::size_t b = a + 1; b < solids.size(); ++b) {
      const bool fixed = (solids[a].finger < 0 || solids[a].link == 0) && (solids[b].finger < 0 || solids[b].link == 0);
      const bool neighbours = solids[a].finger == solids[b].finger && std::abs(solids[a].link - solids[b].link) <= 1;
      const bool root = (solids[a].finger < 0 && solids[b].link <= 1) || (solids[b].finger < 0 && solids[a].link <= 1);
      if (!fixed && !neighbours && !root) pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  }
  return pairs;
}

std::vector<PosedSolid> Bodies::posed(const Pose& X_OH, const Posture& posture) const {
  std::vector<std::vector<Pose>> poses_H;
  for (int finger = 0; finger < static_cast<int>(task_.hand.fingers().size()); ++finger) {
    poses_H.push_back(finger_poses(task_.hand, finger, posture));
  }
  std::vector<PosedSolid> solids_O;
  for (const LinkSolid& solid : task_.hand.solids()) {
    const Pose X_HL = solid.finger < 0 ? Pose{} : poses_H[static_cast<std::size_t>(solid.finger)][static_cast<std::size_t>(solid.link)];
    solids_O.push_back({solid.solid, X_OH * X_HL * solid.X_LS});
  }
  return solids_O;
}

std::optional<Collision> Bodies::with_support(const std::vector<PosedSolid>& solids_O) const {
  if (!task_.support) return std::nullopt;
  for (std::size_t i = 0; i < solids_O.size(); ++i) {
    if (lowest_along(solids_O[i], task_.support->normal_O) <= task_.support->height_m) return Collision{static_cast<int>(i), Collision::kSupport, 0};
  }
  return std::nullopt;
}

/// Asks for the distances of the solids that may have come to the object since they were last looked at.
void Bodies::look(const std::vector<PosedSolid>& solids_O, LastSeen& seen) const {
  seen.places.resize(solids_O.size());
  std::vector<std::size_t> which;
  std::vector<PosedSolid> asked;
  for (std::size_t i = 0; i < solids_O.size(); ++i) {
    const auto& [X_OS, distance_m] = seen.places[i];
    if (distance_m > 0.0 && distance_m > way_between(solids_O[i], X_OS)) continue;
    which.push_back(i);
    asked.push_back(solids_O[i]);
  }
  std::vector<double> distances(asked.size());
  task_.object_O.distance(asked, distances);
  for (std::size_t k = 0; k < which.size(); ++k) seen.places[which[k]] = {asked[k].X_OS, distances[k]};
}

std::optional<Collision> Bodies::with_object(const std::vector<PosedSolid>& solids_O, const std::vector<int>& touching, LastSeen& seen) const {
  look(solids_O, seen);
  for (std::size_t i = 0; i < solids_O.size(); ++i) {
    const LinkSolid& solid = task_.hand.solids()[i];
    const bool exempt = solid.finger >= 0 && std::find(touching.begin(), touching.end(), solid.finger) != touching.end() &&
                        solid.link == task_.hand.fingers()[static_cast<std::size_t>(solid.finger)].joint_count;
    if (!exempt && seen.places[i].distance_m <= 0.0) return Collision{static_cast<int>(i), Collision::kObject, 0};
  }
  return std::nullopt;
}

std::optional<Collision> Bodies::with_itself(const std::vector<PosedSolid>& solids_O, std::span<const std::pair<int, int>> pairs) const {
  std::vector<PosedSolid> first, second;
  for (const auto& [a, b] : pairs) {
    first.push_back(solids_O[static_cast<std::size_t>(a)]);
    second.push_back(solids_O[static_cast<std::size_t>(b)]);
  }
  std::vector<double> distances(pairs.size());
  task_.collision.distance(first, second, distances);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (distances[i] <= 0.0) return Collision{pairs[i].first, pairs[i].second, 0};
  }
  return std::nullopt;
}

std::optional<Collision> Bodies::first(const Pose& X_OH, const Posture& posture, const std::vector<int>& touching, LastSeen& seen) const {
  const auto solids_O = posed(X_OH, posture);
  if (const auto found = with_support(solids_O)) return found;
  if (const auto found = with_object(solids_O, touching, seen)) return found;
  return with_itself(solids_O, pairs_);
}

std::string Bodies::name(int solid) const {
  const LinkSolid& link = task_.hand.solids()[static_cast<std::size_t>(solid)];
  if (link.finger < 0) return "the palm";
  return "link " + std::to_string(link.link) + " of the " + task_.hand.fingers()[static_cast<std::size_t>(link.finger)].name;
}

std::string Bodies::other_name(int other) const {
  return other == Collision::kObject ? "the object" : other == Collision::kSupport ? "the support" : name(other);
}

}  // namespace preshape::kinematic
