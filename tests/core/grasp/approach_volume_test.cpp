#include "preshape/grasp/approach_volume.h"

#include <numbers>

#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/grasp");

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// A hand whose fingers stand where they are put: approach +X, opposition +Y, across the hand Z.
class StandingHand final : public HandModel {
 public:
  StandingHand(std::vector<Points> centre_lines_H, double radius) : lines_H_(std::move(centre_lines_H)) {
    for (std::size_t k = 0; k < lines_H_.size(); ++k) {
      const int links = static_cast<int>(lines_H_[k].size()) - 2, first = static_cast<int>(joints_.size());
      fingers_.push_back({"finger", k == 0 ? FingerRole::kThumb : FingerRole::kIndex, first, links});
      joints_.resize(joints_.size() + static_cast<std::size_t>(links));
      if (links > 0)
        solids_.push_back({static_cast<int>(k), 0, {Solid::Kind::kSphere, 1.0, 0.0, {}}, {}});  // not its tip
      solids_.push_back({static_cast<int>(k), links, {Solid::Kind::kCapsule, radius, 0.01, {}}, {}});
      solids_.push_back(
          {static_cast<int>(k), links, {Solid::Kind::kBox, 0.0, 0.0, {0.5 * radius, 1.0, 1.0}}, {}});
      if (links > 0)
        solids_.push_back({static_cast<int>(k), links - 1, {Solid::Kind::kSphere, 2.0, 0.0, {}}, {}});  // nor this one
    }
  }
  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return fingers_; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return solids_; }
  void forward(int finger, std::span<const double>, std::span<Pose> poses_H) const override {
    for (std::size_t i = 0; i < poses_H.size(); ++i)
      poses_H[i].p = lines_H_[static_cast<std::size_t>(finger)][i];
  }
  void jacobian(int, std::span<const double>,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> J) const override {
    J.setZero();
  }

 private:
  std::vector<Points> lines_H_;
  HandDimensions dimensions_;
  std::vector<Finger> fingers_;
  std::vector<Joint> joints_;
  std::vector<LinkSolid> solids_;
};

/// Carried to O by a pose, its axes with it.
std::optional<ApproachVolume> volume_of(const HandModel& hand, const Pose& X_OH = {},
                                        std::vector<int> fingers = {}) {
  if (fingers.empty()) {
    for (int k = 0; k < static_cast<int>(hand.fingers().size()); ++k) fingers.push_back(k);
  }
  const std::vector<double> posture(hand.joints().size(), 0.0);
  return approach_volume({hand, X_OH, posture, fingers, X_OH.R.col(0), X_OH.R.col(1)});
}

/// Three straight fingers and a thumb, none like another.
StandingHand uneven_hand() {
  return StandingHand({{{0, -0.04, 0.01}, {0.05, -0.06, 0.01}, {0.11, -0.05, 0.005}},
                       {{0, 0.03, -0.02}, {0.06, 0.05, -0.03}, {0.12, 0.05, -0.03}},
                       {{0, 0.03, 0.0}, {0.07, 0.06, 0.0}, {0.14, 0.06, 0.002}},
                       {{0, 0.03, 0.02}, {0.06, 0.04, 0.03}, {0.10, 0.05, 0.03}}},
                      0.01);
}

Pose a_pose(int i) {
  const Eigen::Vector3d axis(0.3 * i - 1.0, 1.0, 0.2 * i);
  return {Eigen::AngleAxisd(0.7 * i, axis.normalized()).toRotationMatrix(), {0.1 * i, -0.2, 0.05 * i}};
}

/// Volume of the hull of points in general position: a triangle is a facet when all others are on one side.
double hull_volume_by_facets(const Points& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  double volume = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Eigen::Vector3d n = (points[j] - points[i]).cross(points[k] - points[i]);
        std::size_t above = 0, below = 0;
        for (std::size_t l = 0; l < points.size(); ++l) {
          if (l == i || l == j || l == k) continue;
          (n.dot(points[l] - points[i]) > 0 ? above : below) += 1;
        }
        if (above == 0 || below == 0) volume += std::abs(n.dot(mean - points[i])) / 6.0;
      }
    }
  }
  return volume;
}

}  // namespace

TEST_CASE(
    "Approach volume: two straight fingers enclose a box as wide as their tips, its entrance the side "
    "between them") {
  const double apart = 0.08, length = 0.1, radius = 0.012;
  const StandingHand hand({{{0, -apart / 2, 0}, {0.04, -apart / 2, 0}, {length, -apart / 2, 0}},
                           {{0, apart / 2, 0}, {0.06, apart / 2, 0}, {length, apart / 2, 0}}},
                          radius);
  const auto volume = volume_of(hand);
  REQUIRE(volume);
  const double closed_form = apart * length * 2 * radius;
  CHECK_NEAR(volume->volume_m3, closed_form, 1e-9 * closed_form);
  CHECK(mesh_topology(volume->mesh_O).watertight());
  CHECK_NEAR(bounding_box(volume->mesh_O).extents(), Eigen::Vector3d(length, apart, 2 * radius), 1e-15);
  CHECK(volume->entrance_O.size() == 4);
  CHECK_NEAR(volume->centroid_O, Eigen::Vector3d(length, 0, 0), 1e-15);
  CHECK_NEAR(volume->normal_O, Eigen::Vector3d(1, 0, 0), 1e-15);
  CHECK_NEAR(volume->angle_to({1, 0, 0}), 0.0, 1e-15);
}

TEST_CASE(
    "Approach volume: a longer finger of two turns the entrance's normal in the plane of approach and "
    "opposition") {
  const double ahead = 0.03, apart = 0.08;
  // The shift across the hand must not turn it out of that plane.
  const StandingHand hand(
      {{{0, -apart / 2, 0}, {0.1, -apart / 2, 0}}, {{0, apart / 2, 0}, {0.1 + ahead, apart / 2, 0.02}}},
      0.01);
  const auto volume = volume_of(hand);
  REQUIRE(volume);
  CHECK_NEAR(volume->normal_O, Eigen::Vector3d(apart, -ahead, 0).normalized(), 1e-12);
  CHECK_NEAR(volume->angle_to({1, 0, 0}), std::atan(ahead / apart), 1e-12);
}

TEST_CASE(
    "Approach volume: four fingers in the corners of a square enclose a prism; the centroid is that of the "
    "surface") {
  const double s = 0.03, length = 0.09;
  std::vector<Points> lines;
  for (const auto& [y, z] : {std::pair{-s, -s}, {s, s}, {s, -s}, {-s, s}})  // not in turn
    lines.push_back({{0, y, z}, {length, y, z}});
  const auto volume = volume_of(StandingHand(lines, 0.0));
  REQUIRE(volume);
  CHECK_NEAR(volume->volume_m3, 4 * s * s * length, 1e-9 * 4 * s * s * length);
  CHECK_NEAR(volume->normal_O, Eigen::Vector3d(1, 0, 0), 1e-15);
  CHECK_NEAR(volume->centroid_O, Eigen::Vector3d(length, 0, 0), 1e-15);
  // A kite: the mean of its corners is not its centroid.
  const double far = 0.09;
  const auto kite = volume_of(StandingHand({{{0, -s, 0}, {length, -s, 0}},
                                            {{0, 0, s}, {length, 0, s}},
                                            {{0, far, 0}, {length, far, 0}},
                                            {{0, 0, -s}, {length, 0, -s}}},
                                           0.0));
  REQUIRE(kite);
  CHECK_NEAR(kite->centroid_O, Eigen::Vector3d(length, (far - s) / 3, 0), 1e-15);
  CHECK_NEAR(kite->volume_m3, s * (far + s) * length, 1e-9 * s * far * length);
}

TEST_CASE(
    "Approach volume: a hand that is its own mirror image across the opposition has its entrance along the "
    "approach") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const auto draw = [&] { return random.uniform(0.02, 0.08); };
    const double along = draw() + 0.05, aside = draw(), up = draw();
    const auto line = [&](double y, double z) {
      return Points{{0, 0.5 * y, z}, {0.5 * along, 1.2 * y, z}, {along, y, z}};
    };
    const auto two = volume_of(StandingHand({line(-aside, 0), line(aside, 0)}, 0.01));
    const auto four = volume_of(
        StandingHand({line(-aside, -up), line(-aside, up), line(aside, -up), line(aside, up)}, 0.01));
    REQUIRE(two);
    REQUIRE(four);
    CHECK_NEAR(two->angle_to({1, 0, 0}), 0.0, 1e-12);
    CHECK_NEAR(four->angle_to({1, 0, 0}), 0.0, 1e-12);
    CHECK_NEAR(four->centroid_O, Eigen::Vector3d(along, 0, 0), 1e-12);
  }
}

TEST_CASE("Approach volume: a moved hand takes it along, numbers and all") {
  const StandingHand hand = uneven_hand();
  const auto still = volume_of(hand);
  REQUIRE(still);
  for (int i = 1; i < 20; ++i) {
    const Pose X_OH = a_pose(i);
    const auto moved = volume_of(hand, X_OH);
    REQUIRE(moved);
    CHECK_NEAR(moved->volume_m3, still->volume_m3, 1e-8 * still->volume_m3);
    CHECK_NEAR(moved->normal_O, X_OH.R * still->normal_O, 1e-12);
    CHECK_NEAR(moved->centroid_O, X_OH * still->centroid_O, 1e-12);
    CHECK_NEAR(moved->angle_to(X_OH.R.col(0)), still->angle_to({1, 0, 0}), 1e-12);
    CHECK(moved->entrance_O.size() == 4);
  }
}

TEST_CASE(
    "Approach volume: it holds every centre line and the entrance, and more fingers never make it smaller") {
  const StandingHand hand = uneven_hand();
  const auto all = volume_of(hand), two = volume_of(hand, {}, {0, 2}), three = volume_of(hand, {}, {0, 1, 3});
  REQUIRE((all && two && three));
  CHECK(two->volume_m3 < all->volume_m3);
  CHECK(three->volume_m3 < all->volume_m3);
  CHECK(three->entrance_O.size() == 3);
  Points inside = all->entrance_O;
  inside.insert(
      inside.end(),
      {{0, -0.04, 0.01}, {0.05, -0.06, 0.01}, {0.07, 0.06, 0.0}, {0.14, 0.06, 0.002}, all->centroid_O});
  for (std::size_t t = 0; t < all->mesh_O.triangles.size(); ++t) {
    const Eigen::Vector3d n = all->mesh_O.area_vector(t).normalized();
    for (const auto& p : inside) CHECK(n.dot(p - all->mesh_O.corner(t, 0)) <= 1e-9);
  }
}

TEST_CASE("Approach volume: it is the hull's that every triple of points has been asked for") {
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    std::vector<Points> lines(4);
    Points all;
    for (auto& line : lines) {
      for (int k = 0; k < 5; ++k)
        line.emplace_back(random.uniform(0, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.05, 0.05));
      all.insert(all.end(), line.begin(), line.end());
    }
    const auto volume = volume_of(StandingHand(lines, 0.0));
    REQUIRE(volume);
    CHECK_NEAR(volume->volume_m3, hull_volume_by_facets(all), 1e-7 * volume->volume_m3);
  }
}

TEST_CASE(
    "Approach volume: there is none where the fingers lie in a plane, or the tips on a line as the hand sees "
    "them") {
  const Points thumb = {{0, -0.03, 0}, {0.1, -0.03, 0}}, index = {{0, 0.03, 0}, {0.1, 0.03, 0}};
  CHECK_FALSE(volume_of(StandingHand({thumb, index}, 0.0)));
  CHECK(volume_of(StandingHand({thumb, index}, 1e-4)));
  const Points ahead = {{0, 0.03, 0.01}, {0.2, -0.03, 0}};
  CHECK_FALSE(volume_of(StandingHand({thumb, ahead}, 0.01)));
  const Points middle = {{0, 0.0, 0.04}, {0.15, 0.0, 0}};
  CHECK_FALSE(volume_of(StandingHand({thumb, index, middle}, 0.01)));
}

TEST_CASE("Approach volume: wrong fingers, postures and axes are refused in a sentence") {
  const StandingHand hand = uneven_hand();
  const std::vector<double> posture(hand.joints().size(), 0.0);
  const auto with = [&](std::vector<int> fingers, const Eigen::Vector3d& a = {1, 0, 0},
                        const Eigen::Vector3d& o = {0, 1, 0}) {
    return approach_volume({hand, {}, posture, fingers, a, o});
  };
  CHECK_THROWS_SAYING(with({0}), InputError, "expected two fingers or more, got 1");
  CHECK_THROWS_SAYING(with({0, 4}), InputError, "finger 4 is not one of the hand's 4");
  CHECK_THROWS_SAYING(with({-1, 2}), InputError, "finger -1 is not one of the hand's 4");
  CHECK_THROWS_SAYING(with({0, 2, 0}), InputError, "finger 0 is given twice");
  CHECK_THROWS_SAYING(with({0, 1}, {2, 0, 0}), InputError, "must be of unit length and at a right angle");
  CHECK_THROWS_SAYING(with({0, 1}, {1, 0, 0}, {0.6, 0.8, 0}), InputError,
                      "must be of unit length and at a right angle");
  CHECK_THROWS_SAYING(with({0, 1}, {std::nan(""), 0, 0}), InputError, "must be of unit length");
  const std::vector<int> two = {0, 1};
  CHECK_THROWS_SAYING(approach_volume({hand, {}, std::span(posture).first(1), two, {1, 0, 0}, {0, 1, 0}}),
                      InputError, "posture: expected 4 entries, got 1");
}

TEST_SUITE_END();
