#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "preshape/script/script.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

constexpr double kU = 0.03;
constexpr int kThumb = 0, kIndex = 1, kMiddle = 2, kRing = 3;

const HandModel& utah_mit() {
  static const auto hand = make_hand(read_description(source_file("hands/utah_mit/hand.lua")));
  return *hand;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The finger's base in the transverse and the opposition direction [U].
Eigen::Vector2d base_of(int finger) {
  static const Eigen::Vector2d kBases[] = {{0, -1}, {1, 1}, {0, 1}, {-1, 1}};
  return kBases[finger];
}

/// Joint values that bring a fingertip to a point, the distal joint straight: abduction turns the finger's plane
/// through the point, and in that plane two links of 1.7U and 1.8U remain. NaN where no values do.
/// @param target_U in H [U]
std::vector<double> reach(int finger, const Eigen::Vector3d& target_U) {
  const double side = finger == kThumb ? -1.0 : 1.0;
  const Eigen::Vector2d base = base_of(finger);
  const double sideways = side * (target_U.x() - base.x());
  const double outward = side * (target_U.y() - base.y());
  const double away = std::hypot(sideways, target_U.z()) - 0.5;
  const double first = 1.7, second = 1.8;
  const double cosine = (outward * outward + away * away - first * first - second * second) / (2 * first * second);
  const double bend = std::acos(cosine);
  const double lean = std::atan2(outward, away) + std::atan2(second * std::sin(bend), first + second * std::cos(bend));
  return {std::atan2(sideways, target_U.z()), -lean, bend, 0.0};
}

/// The fingertip comes to the point within the joints' limits.
void check_reached(int finger, const Eigen::Vector3d& target_U) {
  INFO("finger ", finger, " at ", target_U.x(), " ", target_U.y(), " ", target_U.z(), " U");
  const auto q = reach(finger, target_U);
  CHECK_NEAR(forward(utah_mit(), finger, q).back().p, Eigen::Vector3d(kU * target_U), 1e-12);
  for (int k = 0; k < 4; ++k) {
    const Joint& joint = utah_mit().joints()[static_cast<std::size_t>(4 * finger + k)];
    INFO(joint.name, " = ", q[static_cast<std::size_t>(k)]);
    CHECK(q[static_cast<std::size_t>(k)] >= joint.lower);
    CHECK(q[static_cast<std::size_t>(k)] <= joint.upper);
  }
}

/// A solid in H at a posture, the same for every finger.
PosedSolid posed(const LinkSolid& link, const std::vector<double>& q) {
  if (link.finger < 0) return {link.solid, link.X_LS};
  return {link.solid, forward(utah_mit(), link.finger, q)[static_cast<std::size_t>(link.link)] * link.X_LS};
}

Eigen::Vector3d along_axis(const PosedSolid& capsule, double share) {
  return capsule.X_OS * Eigen::Vector3d(0, 0, share * capsule.solid.half_length);
}

double distance_to_box(const Eigen::Vector3d& p_H, const PosedSolid& box) {
  const Eigen::Vector3d p = box.X_OS.inverse() * p_H;
  return (p.cwiseAbs() - box.solid.half_extents).cwiseMax(0.0).norm();
}

/// Clearance of two capsules, or of a box and a capsule, by points along their axes.
double clearance(const PosedSolid& a, const PosedSolid& b) {
  if (b.solid.kind == Solid::Kind::kBox) return clearance(b, a);
  constexpr int kPoints = 60;
  double least = INFINITY;
  for (int i = -kPoints; i <= kPoints; ++i) {
    const Eigen::Vector3d p = along_axis(b, double(i) / kPoints);
    if (a.solid.kind == Solid::Kind::kBox) {
      least = std::min(least, distance_to_box(p, a));
      continue;
    }
    for (int k = -kPoints; k <= kPoints; ++k) least = std::min(least, (p - along_axis(a, double(k) / kPoints)).norm());
  }
  return least - a.solid.radius - b.solid.radius;
}

/// Links that meet in a joint, and the knuckles that stand on the palm.
bool neighbours(const LinkSolid& a, const LinkSolid& b) {
  if (a.finger < 0) return b.link == 1;
  return a.finger == b.finger && std::abs(a.link - b.link) <= 1;
}

}  // namespace

TEST_CASE("Utah/MIT hand: four fingers of four joints, with the thesis's sizes") {
  const HandModel& hand = utah_mit();
  CHECK(hand.dimensions().unit_length_m == kU);
  CHECK(hand.dimensions().finger_spacing_m == kU);
  CHECK(hand.dimensions().maximum_opening_m == 4 * kU);
  CHECK(hand.dimensions().base_width_m == 5 * kU);
  REQUIRE(hand.fingers().size() == 4);
  CHECK(hand.joints().size() == 16);
  const FingerRole roles[] = {FingerRole::kThumb, FingerRole::kIndex, FingerRole::kMiddle, FingerRole::kRing};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(hand.fingers()[i].role == roles[i]);
    CHECK(hand.fingers()[i].joint_count == 4);
    CHECK(hand.fingers()[i].first_joint == static_cast<int>(4 * i));
  }
  for (const Joint& joint : hand.joints()) {
    INFO(joint.name);
    CHECK(joint.lower < joint.upper);
    CHECK(joint.lower <= 0.0);
    CHECK(joint.upper >= 0.0);
  }
}

TEST_CASE("Utah/MIT hand: at q = 0 every fingertip stands 4U in front of its base") {
  for (const int finger : {kThumb, kIndex, kMiddle, kRing}) {
    const auto poses_H = forward(utah_mit(), finger, {0, 0, 0, 0});
    const Eigen::Vector2d base = base_of(finger);
    CHECK_NEAR(poses_H.front().p, Eigen::Vector3d(kU * base.x(), kU * base.y(), 0), kEps);
    CHECK_NEAR(poses_H.back().p, Eigen::Vector3d(kU * base.x(), kU * base.y(), 4 * kU), kEps);
  }
}

TEST_CASE("Utah/MIT hand: flexion closes the thumb and the forefingers towards each other") {
  for (int joint = 1; joint < 4; ++joint) {
    std::vector<double> q(4, 0.0);
    q[static_cast<std::size_t>(joint)] = 0.2;
    CHECK(forward(utah_mit(), kThumb, q).back().p.y() > -kU);
    for (const int finger : {kIndex, kMiddle, kRing}) {
      const Eigen::Vector3d p = forward(utah_mit(), finger, q).back().p;
      CHECK(p.y() < kU);
      CHECK_NEAR(p.x(), kU * base_of(finger).x(), kEps);
    }
  }
  CHECK(forward(utah_mit(), kMiddle, {0.2, 0, 0, 0}).back().p.x() > 0);
  CHECK(forward(utah_mit(), kThumb, {0.2, 0, 0, 0}).back().p.x() < 0);
}

TEST_CASE("Utah/MIT hand: opposed fingertips reach both sides of everything from a sheet to 6U across") {
  for (double half_width = 0.05; half_width <= 3.0; half_width += 0.05) {
    check_reached(kThumb, {0, -half_width, 3});
    for (const int finger : {kIndex, kMiddle, kRing}) check_reached(finger, {base_of(finger).x(), half_width, 3});
  }
}

TEST_CASE("Utah/MIT hand: at its maximum opening every fingertip is 4U from the middle") {
  check_reached(kThumb, {0, -4, 2.25});
  for (const int finger : {kIndex, kMiddle, kRing}) check_reached(finger, {base_of(finger).x(), 4, 2.25});
}

TEST_CASE("Utah/MIT hand: the thumb comes between two forefingers and meets one alone half-way") {
  for (double half_width = 0.25; half_width <= 2.0; half_width += 0.25) {
    for (const double between : {0.5, -0.5}) check_reached(kThumb, {between, -half_width, 2.5});
    check_reached(kIndex, {0.5, half_width, 2.5});
    check_reached(kRing, {-0.5, half_width, 2.5});
  }
}

TEST_CASE("Utah/MIT hand: at rest its solids fill the base's width, end at the fingertips and stay inside both") {
  Eigen::Vector3d lower(INFINITY, INFINITY, INFINITY), upper = -lower;
  for (const LinkSolid& link : utah_mit().solids()) {
    const PosedSolid solid = posed(link, {0, 0, 0, 0});
    const bool box = solid.solid.kind == Solid::Kind::kBox;
    const Eigen::Vector3d reach = box ? Eigen::Vector3d(solid.X_OS.R.cwiseAbs() * solid.solid.half_extents)
                                      : Eigen::Vector3d(solid.X_OS.R.col(2).cwiseAbs() * solid.solid.half_length +
                                                        Eigen::Vector3d::Constant(solid.solid.radius));
    lower = lower.cwiseMin(solid.X_OS.p - reach);
    upper = upper.cwiseMax(solid.X_OS.p + reach);
  }
  CHECK_NEAR(lower, Eigen::Vector3d(-2.5 * kU, -1.5 * kU, -0.8 * kU), 8 * kEps);
  CHECK_NEAR(upper, Eigen::Vector3d(2.5 * kU, 1.5 * kU, 4 * kU), 8 * kEps);
}

TEST_CASE("Utah/MIT hand: its parts stay apart at rest and wide open") {
  const auto solids = utah_mit().solids();
  CHECK(solids.size() == 17);
  for (const std::vector<double>& q : {std::vector<double>{0, 0, 0, 0}, {0, -1.05, 0, 0}, {0, -1.5, 0.8, 0.3}}) {
    int pairs = 0;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      for (std::size_t k = i + 1; k < solids.size(); ++k) {
        if (neighbours(solids[i], solids[k])) continue;
        INFO("solids ", i, " and ", k, ", proximal flexion ", q[1]);
        CHECK(clearance(posed(solids[i], q), posed(solids[k], q)) > 0.05 * kU);
        ++pairs;
      }
    }
    CHECK(pairs == 120);  // 136 pairs, 12 of them joints of a finger and 4 knuckles on the palm
  }
}

TEST_CASE("Utah/MIT hand: a mistake in its file is told with file and line") {
  const TemporaryDirectory folder;
  std::string text = read_text(source_file("hands/utah_mit/hand.lua"));
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("alpha = math.rad(alpha)", "alpah = math.rad(alpha)");
  std::ofstream(folder / "hand.lua") << text;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("alpah")), '\n');
  const auto load = [&] { return make_hand(read_description(folder / "hand.lua")); };
  CHECK_THROWS_SAYING(load(), InputError,
                      fmt::format("hand.lua:{}: finger 1 'thumb', joint 1 'thumb_abduction': unknown key 'alpah'; did "
                                  "you mean 'alpha'?",
                                  line));
}

TEST_CASE("DH description: the example of the plugin's page is a hand") {
  const std::string page = read_text(source_file("plugins/hand/dh/README.md"));
  const auto begin = page.find("```lua\n") + 7, end = page.find("```\n", begin);
  REQUIRE(end != std::string::npos);
  const auto hand = make_hand(Script::from_text(page.substr(begin, end - begin), "README.md").run());
  CHECK_NEAR(forward(*hand, 0, {0, 0}).back().p, Eigen::Vector3d(2.7 * kU, kU, 0), kEps);
}

TEST_SUITE_END();
