// What the kinematic simulator says of random scenes with every shipped hand, against an oracle of its own: forward
// kinematics, limits, couplings and the brute collision backend asked about every solid in every place.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "preshape/hand/inverse_kinematics.h"
#include "support/hands.h"
#include "support/near.h"
#include "support/sample.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;
using Eigen::Vector3d;
using Status = Simulation::Status;

TEST_SUITE_BEGIN("plugins/simulator");

namespace {

constexpr double kWay = 0.1, kWayStep = 0.005;  // [m] that the simulator looks at unless told
constexpr int kSides = 12;  // of a prism that stands for a cylinder

/// A prism about z with facets across +-y, `apothem` from its axis.
TriangleMesh prism(double apothem, double length) {
  TriangleMesh mesh;
  const double half = std::numbers::pi / kSides, radius = apothem / std::cos(half);
  for (const double z : {-0.5 * length, 0.5 * length}) {
    for (int k = 0; k < kSides; ++k) mesh.vertices.emplace_back(radius * std::cos((2 * k + 1) * half), radius * std::sin((2 * k + 1) * half), z);
    mesh.vertices.emplace_back(0, 0, z);
  }
  const int top = kSides + 1;
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    mesh.triangles.emplace_back(k, next, top + k);
    mesh.triangles.emplace_back(next, top + next, top + k);
    mesh.triangles.emplace_back(kSides, next, k);
    mesh.triangles.emplace_back(top + kSides, top + k, top + next);
  }
  return mesh;
}

/// An object to be grasped from -x by a thumb on +y and forefingers on -y, as drawn, then put anywhere.
struct Drawn {
  Drawn(const HandModel& drawn_hand, Random& random, bool cluttered, const std::optional<Pose>& elsewhere = {}) : hand(drawn_hand), backend(registry().create<CollisionBackend>("brute")) {
    const int most = static_cast<int>(std::min<std::ptrdiff_t>(3, std::ssize(hand.fingers()) - 1));
    const int forefingers = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(most)));
    const double spacing = hand.dimensions().finger_spacing_m * random.uniform(0.8, 1.2);
    extents = {random.uniform(0.02, 0.06), random.uniform(0.03, 0.07), random.uniform(0.06, 0.14)};
    std::vector<TriangleMesh> parts;
    round = random.below(2) == 0;
    if (round) extents.x() = extents.y();
    parts = {round ? prism(0.5 * extents.y(), extents.z()) : centred_box(extents)};
    add({0, 0.5 * extents.y(), 0}, {0, -1, 0}, FingerRole::kThumb);
    const FingerRole roles[] = {FingerRole::kIndex, FingerRole::kMiddle, FingerRole::kRing};
    for (int i = 0; i < forefingers; ++i) add({0, -0.5 * extents.y(), spacing * (i - 0.5 * (forefingers - 1))}, {0, 1, 0}, roles[i]);
    for (int i = 0; cluttered && i < 8; ++i) {
      Vector3d at = 0.12 * random_vector(random);
      at.x() -= 0.08;
      if ((at.array().abs() < 0.5 * extents.array() + 0.02).all()) continue;
      const Vector3d half = Vector3d::Constant(random.uniform(0.002, 0.006));
      parts.push_back(box_between(at - half, at + half));
    }
    if (random.below(3) == 0) support = SupportPlane{Vector3d::UnitZ(), -0.5 * extents.z() - random.uniform(0.0, 0.03)};
    clearance_m = random.uniform(0.004, 0.015);
    X_OB = {random_rotation(random), random_vector(random)};
    if (elsewhere) X_OB = *elsewhere;
    place(joined(parts));
  }

  /// With a small block more.
  Drawn with_block(const Vector3d& at_O) const {
    Drawn other(*this);
    TriangleMesh block = box_between(-Vector3d::Constant(0.001), Vector3d::Constant(0.001));
    for (auto& vertex : block.vertices) vertex += at_O;
    other.mesh = joined({mesh, block});
    other.object = build_scene(backend, other.mesh);
    return other;
  }

  void add(const Vector3d& p, const Vector3d& n, FingerRole role) {
    contacts.push_back(ContactFrame::at(p, n, Vector3d::UnitX()));
    fingers.push_back(role);
  }

  void place(TriangleMesh mesh_B) {
    for (auto& vertex : mesh_B.vertices) vertex = X_OB * vertex;
    object = build_scene(backend, mesh_B);
    mesh = std::move(mesh_B);
    for (auto& C : contacts) C = ContactFrame::at(X_OB * C.p_OC, X_OB.R * C.n, X_OB.R * C.a);
    if (!support) return;
    support->normal_O = X_OB.R.col(2);
    support->height_m += support->normal_O.dot(X_OB.p);
  }

  Simulation run(const Value& parameters = {}) const {
    const SimulationTask task{hand, *backend, *object, contacts, fingers, X_OB.R.col(0), X_OB.R.col(1), clearance_m, support ? &*support : nullptr};
    return registry().create<GraspSimulator>("kinematic", parameters)->simulate(task, 1, nullptr);
  }

  /// How far a point is beneath the object's surface, at least.
  double depth_m(const Vector3d& p_O) const {
    const Vector3d p = (X_OB.inverse() * p_O).cwiseAbs(), in = 0.5 * extents - p;
    return round ? std::min(in.z(), in.x() + p.x() - p.head<2>().norm()) : in.minCoeff();
  }

  const HandModel& hand;
  std::shared_ptr<const CollisionBackend> backend;
  std::shared_ptr<const CollisionScene> object;
  TriangleMesh mesh;
  Vector3d extents = Vector3d::Zero();
  bool round = false;
  Pose X_OB;
  std::vector<ContactFrame> contacts;
  std::vector<FingerRole> fingers;
  std::optional<SupportPlane> support;
  double clearance_m = 0.0;
};

bool fixed(const LinkSolid& solid) { return solid.finger < 0 || solid.link == 0; }

std::vector<PosedSolid> solids_of(const HandModel& hand, const Pose& X_OH, const Posture& posture, double thinner_m = 0.0) {
  std::vector<std::vector<Pose>> poses_H;
  for (int finger = 0; finger < std::ssize(hand.fingers()); ++finger) poses_H.push_back(finger_poses(hand, finger, posture));
  std::vector<PosedSolid> all;
  for (const LinkSolid& link : hand.solids()) {
    const Pose X_HL = link.finger < 0 ? Pose{} : poses_H[static_cast<std::size_t>(link.finger)][static_cast<std::size_t>(link.link)];
    Solid solid = link.solid;
    solid.radius = std::max(0.0, solid.radius - thinner_m);
    solid.half_extents = (solid.half_extents.array() - thinner_m).max(0.0);
    all.push_back({solid, X_OH * X_HL * link.X_LS});
  }
  return all;
}

std::vector<double> apart(const CollisionBackend& backend, const std::vector<PosedSolid>& solids, const std::vector<std::pair<int, int>>& pairs) {
  std::vector<PosedSolid> first, second;
  for (const auto& [a, b] : pairs) first.push_back(solids[static_cast<std::size_t>(a)]), second.push_back(solids[static_cast<std::size_t>(b)]);
  std::vector<double> distances(pairs.size());
  backend.distance(first, second, distances);
  return distances;
}

/// Pairs of solids that are not built into one another: neither next to each other nor overlapping in each of many postures.
std::vector<std::pair<int, int>> separable(const HandModel& hand, const CollisionBackend& backend) {
  std::vector<std::pair<int, int>> pairs;
  const auto solids = hand.solids();
  for (int a = 0; a < static_cast<int>(solids.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(solids.size()); ++b) {
      const LinkSolid &s = solids[static_cast<std::size_t>(a)], &t = solids[static_cast<std::size_t>(b)];
      const bool next = s.finger == t.finger && std::abs(s.link - t.link) <= 1;
      const bool at_the_palm = (s.finger < 0 && t.link <= 1) || (t.finger < 0 && s.link <= 1);
      if (!(fixed(s) && fixed(t)) && !next && !at_the_palm) pairs.emplace_back(a, b);
    }
  }
  Random random(77);
  std::vector<bool> seen_apart(pairs.size(), false);
  for (int i = 0; i < 40; ++i) {
    Posture posture(hand.joints().size(), 0.0);
    for (const int joint : driven_joints(hand)) {
      const DriveRange range = drive_range(hand, joint);
      posture[static_cast<std::size_t>(joint)] = random.uniform(range.lower, range.upper);
    }
    apply_couplings(hand, posture);
    const auto distances = apart(backend, solids_of(hand, {}, posture), pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) seen_apart[k] = seen_apart[k] || distances[k] > 0.0;
  }
  std::vector<std::pair<int, int>> found;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (seen_apart[k]) found.push_back(pairs[k]);
  }
  return found;
}

double lowest(const PosedSolid& posed, const Vector3d& up) {
  double least = INFINITY;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d sign((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
    const Vector3d at = posed.solid.kind == Solid::Kind::kBox       ? Vector3d(sign.cwiseProduct(posed.solid.half_extents))
                        : posed.solid.kind == Solid::Kind::kCapsule ? Vector3d(0, 0, sign.z() * posed.solid.half_length)
                                                                    : Vector3d::Zero();
    least = std::min(least, up.dot(posed.X_OS * at));
  }
  return posed.solid.kind == Solid::Kind::kBox ? least : least - posed.solid.radius;
}

/// Everything that a simulation's hand meets, by asking about all of it.
struct Oracle {
  const Drawn& scene;
  const Simulation& simulation;
  const std::vector<std::pair<int, int>>& pairs;
  double way_m;  // that the hand was to come

  bool holds(int finger) const {
    return std::any_of(simulation.fingers.begin(), simulation.fingers.end(), [&](const auto& outcome) { return outcome.finger == finger; });
  }

  /// Of a hand that is `back_m` before its place; `closing`: its holding fingers' last links may be at the object.
  std::string met(const Posture& posture, double back_m, bool closing, double thinner_m = 0.0) const {
    const Pose X_OH{simulation.X_OH.R, simulation.X_OH.p - back_m * simulation.X_OH.R.col(2)};
    const auto solids = solids_of(scene.hand, X_OH, posture, thinner_m);
    std::vector<double> distances(solids.size());
    scene.object->distance(solids, distances);
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const LinkSolid& link = scene.hand.solids()[i];
      const bool last = link.finger >= 0 && link.link == scene.hand.fingers()[static_cast<std::size_t>(link.finger)].joint_count;
      if (distances[i] <= 0.0 && !(closing && last && holds(link.finger))) return fmt::format("solid {} is at the object", i);
      if (scene.support && lowest(solids[i], scene.support->normal_O) <= scene.support->height_m) return fmt::format("solid {} is in the support", i);
    }
    if (back_m > 0.0) return "";  // the hand's own solids keep their places
    const auto between = apart(*scene.backend, solids, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (between[k] <= 0.0) return fmt::format("solids {} and {} meet", pairs[k].first, pairs[k].second);
    }
    return "";
  }

  /// No solid's middle is inside of the object, which surfaces do not tell.
  bool outside(const Posture& posture) const {
    const auto solids = solids_of(scene.hand, simulation.X_OH, posture);
    return std::all_of(solids.begin(), solids.end(), [&](const PosedSolid& solid) { return scene.depth_m(solid.X_OS.p) < 0.003; });
  }

  std::string posture_is_wrong(const Posture& posture) const {
    const auto joints = scene.hand.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (posture[j] < joints[j].lower - 1e-9 || posture[j] > joints[j].upper + 1e-9) return "limits of " + joints[j].name;
      const auto leader = static_cast<std::size_t>(std::max(0, joints[j].leader));
      if (joints[j].leader >= 0 && std::abs(posture[j] - joints[j].ratio * posture[leader] - joints[j].offset) > 1e-9) return "coupling of " + joints[j].name;
    }
    return "";
  }

  /// Last links come to their contacts from the outside, all but along the surface.
  bool from_outside() const {
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const Vector3d pointing_O = simulation.X_OH.R * pointing_of(scene.hand, simulation.fingers[i].finger, simulation.path.back());
      if (pointing_O.dot(scene.contacts[i].n) < -0.05 - 1e-6) return false;
    }
    return true;
  }

  Vector3d tip(std::size_t contact, const Posture& posture) const {
    return simulation.X_OH * finger_poses(scene.hand, simulation.fingers[contact].finger, posture).back().p;
  }

  /// Between the postures of the path, and between the places of the way: a little may be met there.
  std::string met_between() const {
    constexpr double kBetweenPostures = 0.001, kBetweenPlaces = 0.0025;  // arcs of a step of 0.08 rad; corners past corners, 5 mm apart
    const auto& path = simulation.path;
    for (std::size_t k = 1; k < path.size(); ++k) {
      Posture posture = path[k];
      for (std::size_t j = 0; j < posture.size(); ++j) posture[j] = std::midpoint(path[k - 1][j], path[k][j]);
      if (const auto told = met(posture, 0.0, true, kBetweenPostures); !told.empty()) return fmt::format("{} between postures {} and {}", told, k - 1, k);
    }
    for (double back = 0.5 * kWayStep; back <= simulation.way_m; back += 3 * kWayStep) {
      if (const auto told = met(path.front(), back, false, kBetweenPlaces); !told.empty()) return fmt::format("{} {} m before", told, back);
    }
    return "";
  }
};

void check_reached(const Oracle& oracle) {
  const auto& [scene, simulation, pairs, way_m] = oracle;
  REQUIRE(simulation.fingers.size() == scene.contacts.size());
  CHECK(scene.hand.fingers()[static_cast<std::size_t>(simulation.fingers[0].finger)].role == FingerRole::kThumb);
  double farthest = 0.0;
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactFrame& C = scene.contacts[i];
    const double off = (oracle.tip(i, simulation.path.back()) - C.p_OC).norm();
    farthest = std::max(farthest, off);
    CHECK(off <= 1e-4);
    CHECK_NEAR(off, simulation.fingers[i].error_m, 1e-9);
    CHECK(C.n.dot(C.p_OC - oracle.tip(i, simulation.path.front())) >= scene.clearance_m - 1.1e-4);
    for (std::size_t k = 0; k < i; ++k) CHECK(simulation.fingers[i].finger != simulation.fingers[k].finger);
  }
  CHECK_NEAR(farthest, simulation.contact_error_m, 1e-8);
  CHECK(oracle.from_outside());
  for (const auto& posture : simulation.path) CHECK(oracle.posture_is_wrong(posture) == "");
  for (const auto& posture : simulation.path) CHECK(oracle.outside(posture));
  for (std::size_t k = 1; k < simulation.path.size(); ++k) {
    for (std::size_t j = 0; j < simulation.path[k].size(); ++j) {
      const double step = simulation.path[k][j] - simulation.path[k - 1][j];
      CHECK(std::abs(step) <= 0.08 + 1e-9);
      CHECK_NEAR(step, simulation.path[1][j] - simulation.path[0][j], 1e-9);  // evenly
    }
  }
  for (const auto& outcome : simulation.fingers) {
    const Finger& finger = scene.hand.fingers()[static_cast<std::size_t>(outcome.finger)];
    for (const int joint : outcome.at_limit) CHECK((joint >= finger.first_joint && joint < finger.first_joint + finger.joint_count));
  }
  for (std::size_t k = 0; k < simulation.path.size(); ++k) CHECK(oracle.met(simulation.path[k], 0.0, k > 0) == "");
  for (double back = kWayStep; back < way_m + 1e-9; back += kWayStep) CHECK(oracle.met(simulation.path.front(), back, false) == "");
  CHECK(simulation.way_m == doctest::Approx(way_m));
  CHECK(oracle.met_between() == "");
}

/// A collision is there where it is told, and nothing before it as the motion is gone through, from its end.
void check_collision(const Oracle& oracle) {
  const auto& [scene, simulation, pairs, way_m] = oracle;
  REQUIRE(simulation.collisions.size() == 1);
  const Collision& told = simulation.collisions.front();
  const auto free = [&](std::size_t k) { return oracle.met(simulation.path[k], 0.0, k > 0).empty(); };
  const auto place = static_cast<std::size_t>(told.posture);
  for (std::size_t k = simulation.path.size(); k-- > place + 1;) CHECK(oracle.met(simulation.path[k], 0.0, true) == "");
  if (simulation.way_m == way_m) {
    CHECK_FALSE(free(place));
    return;
  }
  for (double back = kWayStep; back < simulation.way_m + 1e-9; back += kWayStep) CHECK(oracle.met(simulation.path.front(), back, false) == "");
  CHECK(free(0));
  CHECK(oracle.met(simulation.path.front(), simulation.way_m + kWayStep, false) != "");
}

void check_what_is_told(const Oracle& oracle) {
  if (oracle.simulation.status == Status::kReached) check_reached(oracle);
  if (oracle.simulation.status == Status::kCollision && !oracle.simulation.collisions.empty()) check_collision(oracle);
}

}  // namespace

TEST_CASE("Kinematic: with every shipped hand and boxes and cylinders anywhere, reached is a free motion of true postures to the contacts, and a collision is the first there is") {
  for (const auto& [name, hand] : shipped_hands()) {
    Random random(20);
    const auto pairs = separable(*hand, *registry().create<CollisionBackend>("brute"));
    int reached = 0, collided = 0;
    for (int i = 0; i < 5; ++i) {
      INFO(name, " scene ", i);
      const Drawn scene(*hand, random, i % 3 == 2);
      const double lean = random.uniform(-30, 30);  // of every other scene; the others are leant as the simulator likes
      const Simulation simulation = scene.run(i % 2 == 0 ? Value{} : Value::table({{"leans", Value::numbers({lean})}}));
      INFO(simulation.reason);
      const Oracle oracle{scene, simulation, pairs, kWay};
      reached += simulation.status == Status::kReached, collided += simulation.status == Status::kCollision;
      check_what_is_told(oracle);
    }
    MESSAGE(name, ": ", reached, " reached, ", collided, " collided");
    CHECK(reached >= 3);
  }
}

TEST_CASE("Kinematic: a small block where a link sweeps by, however little the link's middle moves, is not passed through") {
  for (const char* name : {"utah_mit", "shadow"}) {
    const HandModel& hand = *shipped_hands().at(name);
    Random random(41);
    const auto pairs = separable(hand, *registry().create<CollisionBackend>("brute"));
    const Value parameters = Value::table({{"way", 0.0}, {"candidates", 1}, {"leans", Value::numbers({0.0})}});
    for (int i = 0; i < 2; ++i) {
      Drawn scene(hand, random, false);
      scene.clearance_m = 0.035;  // far to go
      const Simulation simulation = scene.run(parameters);
      if (simulation.status != Status::kReached) continue;
      for (int block = 0; block < 5; ++block) {
        const auto& posture = simulation.path[1 + random.below(simulation.path.size() - 2)];
        const Finger& finger = hand.fingers()[static_cast<std::size_t>(simulation.fingers[random.below(simulation.fingers.size())].finger)];
        std::vector<Vector3d> ends;
        const auto solids = solids_of(hand, simulation.X_OH, posture);
        for (std::size_t k = 0; k < solids.size(); ++k) {
          const LinkSolid& link = hand.solids()[k];
          if (link.finger < 0 || &hand.fingers()[static_cast<std::size_t>(link.finger)] != &finger || link.link == finger.joint_count) continue;
          const double aside = random.uniform(-1, 1);
          const Solid& solid = link.solid;
          ends.push_back(solids[k].X_OS * (solid.kind == Solid::Kind::kBox ? Vector3d(solid.half_extents * aside) : Vector3d(0, solid.radius * aside, solid.half_length)));
        }
        const Drawn blocked = scene.with_block(ends[random.below(ends.size())]);
        const Simulation told = blocked.run(parameters);
        INFO(name, " scene ", i, " block ", block, ": ", told.reason);
        check_what_is_told({blocked, told, pairs, 0.0});
      }
    }
  }
}

TEST_CASE("Kinematic: the same scene in another place is grasped by the same postures to the last bit, the hand in that place") {
  for (const char* name : {"utah_mit", "barrett"}) {
    const HandModel& hand = *shipped_hands().at(name);
    Random random(31), places(32);
    for (int i = 0; i < 3; ++i) {
      INFO(name, " scene ", i);
      Random again = random;
      const Pose X{random_rotation(places), random_vector(places)};
      const Drawn here(hand, random, false), there(hand, again, false, X);
      const Simulation a = here.run(), b = there.run();
      CHECK(a.status == b.status);
      CHECK(a.path == b.path);
      const Pose moved = X * here.X_OB.inverse() * a.X_OH;
      CHECK_NEAR(moved.R, b.X_OH.R, 1e-8);
      CHECK_NEAR(moved.p, b.X_OH.p, 1e-8);
    }
  }
}

TEST_SUITE_END();
