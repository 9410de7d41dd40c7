// The Shadow hand against the numbers of its MuJoCo model, by plain products; couplings and roles of the
// published hands.
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include <Eigen/Geometry>

#include "dh_samples.h"
#include "preshape/hand/posture.h"
#include "support/data.h"
#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

std::vector<double> numbers_of(const std::string& element, const std::string& key) {
  std::smatch match;
  std::vector<double> numbers;
  if (!std::regex_search(element, match, std::regex("\\b" + key + "=\"([^\"]*)\""))) return numbers;
  const std::string text = match[1];
  static const std::regex number("[-+0-9.e]+");
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
    numbers.push_back(std::stod(at->str()));
  return numbers;
}

std::string word_of(const std::string& element, const std::string& key) {
  std::smatch match;
  return std::regex_search(element, match, std::regex("\\b" + key + "=\"([^\"]*)\"")) ? match[1].str() : "";
}

std::string element_from(const std::string& text, std::size_t begin) {
  return text.substr(begin, text.find('>', begin) - begin);
}

/// A body of the model with its joint, by the numbers in the text.
struct Body {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double lower = 0.0, upper = 0.0;
};

Body body_of(const std::string& model, const std::string& name) {
  const auto begin = model.find("<body name=\"" + name + "\"");
  REQUIRE(begin != std::string::npos);
  const std::string element = element_from(model, begin);
  const std::string joint = element_from(model, model.find("<joint ", begin));
  const std::string standard = element_from(
      model, model.find("<joint ", model.find("<default class=\"" + word_of(joint, "class") + "\">")));
  Body body;
  if (const auto p = numbers_of(element, "pos"); !p.empty()) body.X.translation() << p[0], p[1], p[2];
  if (const auto q = numbers_of(element, "quat"); !q.empty())
    body.X.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  for (const auto& source : {standard, joint}) {
    if (const auto a = numbers_of(source, "axis"); !a.empty())
      body.axis = Eigen::Vector3d(a[0], a[1], a[2]).normalized();
    if (const auto r = numbers_of(source, "range"); !r.empty()) body.lower = r[0], body.upper = r[1];
  }
  return body;
}

const std::vector<std::string> kShadow[] = {
    {"rh_thbase", "rh_thproximal", "rh_thhub", "rh_thmiddle", "rh_thdistal"},
    {"rh_ffknuckle", "rh_ffproximal", "rh_ffmiddle", "rh_ffdistal"},
    {"rh_mfknuckle", "rh_mfproximal", "rh_mfmiddle", "rh_mfdistal"},
    {"rh_rfknuckle", "rh_rfproximal", "rh_rfmiddle", "rh_rfdistal"},
    {"rh_lfmetacarpal", "rh_lfknuckle", "rh_lfproximal", "rh_lfmiddle", "rh_lfdistal"},
};

/// H in the palm's frame, as hands/shadow/README.md has it: thirty degrees from the palm's normal to the
/// fingers.
Eigen::Isometry3d shadow_base() {
  const double lean = 30 * M_PI / 180;
  Eigen::Isometry3d X_PH = Eigen::Isometry3d::Identity();
  X_PH.linear().col(0) << 1, 0, 0;
  X_PH.linear().col(1) << 0, std::sin(lean), std::cos(lean);
  X_PH.linear().col(2) << 0, -std::cos(lean), std::sin(lean);
  X_PH.translation() << 0, -0.012, 0.045;
  return X_PH;
}

const Joint& joint_named(const HandModel& hand, const std::string& name) {
  for (const Joint& joint : hand.joints()) {
    if (joint.name == name) return joint;
  }
  FAIL("no joint ", name);
  return hand.joints()[0];
}

}  // namespace

TEST_CASE(
    "Published hands: the Shadow hand moves as its MuJoCo model does, to 1e-9 m, within the same limits") {
  const auto data = test_data("hands");
  if (data.empty()) return;
  std::ifstream stream(data / "shadow_hand_right/right_hand.xml");
  const std::string model{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const HandModel& hand = *shipped_hands().at("shadow");
  const Eigen::Isometry3d X_HP = shadow_base().inverse();
  Random random(31);
  double worst = 0.0, turned = 0.0;
  for (int finger = 0; finger < 5; ++finger) {
    std::vector<Body> bodies;
    for (const auto& name : kShadow[finger]) bodies.push_back(body_of(model, name));
    const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
    REQUIRE(about.joint_count == static_cast<int>(bodies.size()));
    for (int i = 0; i < 1000; ++i) {
      std::vector<double> q;
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Joint& joint = hand.joints()[static_cast<std::size_t>(about.first_joint) + k];
        if (i == 0) CHECK(joint.lower == bodies[k].lower);
        if (i == 0) CHECK(joint.upper == bodies[k].upper);
        q.push_back(random.uniform(joint.lower, joint.upper));
      }
      const auto poses = forward(hand, finger, q);
      Eigen::Isometry3d X = X_HP;
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        X = X * bodies[k].X * Eigen::AngleAxisd(q[k], bodies[k].axis);
        worst = std::max(worst, (poses[k + 1].p - X.translation()).norm());
        turned = std::max(turned, (poses[k + 1].R - X.linear()).norm());
      }
    }
  }
  CHECK(worst < 1e-9);
  CHECK(turned < 1e-7);
}

TEST_CASE(
    "Published hands: Shadow's distal joints follow the middle ones, Barrett's spread is mirrored and its "
    "tips follow") {
  const HandModel& shadow = *shipped_hands().at("shadow");
  CHECK(shadow.joints().size() == 22);
  CHECK(driven_joints(shadow).size() == 18);
  for (const char* finger : {"index", "middle", "ring", "little"}) {
    const Joint& distal = joint_named(shadow, std::string(finger) + "_J1");
    REQUIRE(distal.leader >= 0);
    CHECK(shadow.joints()[static_cast<std::size_t>(distal.leader)].name == std::string(finger) + "_J2");
    CHECK(distal.ratio == 1.0);
  }
  const HandModel& barrett = *shipped_hands().at("barrett");
  CHECK(barrett.joints().size() == 8);
  CHECK(driven_joints(barrett).size() == 4);
  // Mirrored: the forefingers' tips stand at opposite x and the same y and z, whatever the drives do.
  Random random(32);
  for (int i = 0; i < 100; ++i) {
    Posture q(8, 0.0);
    const double inner = random.uniform(-2.3, 0), spread = random.uniform(-3.1, 0);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::string& name = barrett.joints()[k].name;
      if (name.ends_with("_inner")) q[k] = inner;
      if (name == "index_spread") q[k] = spread;
    }
    apply_couplings(barrett, q);
    const Eigen::Vector3d index = finger_poses(barrett, 1, q).back().p,
                          middle = finger_poses(barrett, 2, q).back().p;
    CHECK_NEAR(middle, Eigen::Vector3d(-index.x(), index.y(), index.z()),
               1e-3);  // the figures of the two differ by 0.4 mm
  }
}

TEST_CASE(
    "Published hands: the index stands at +X, the thumb at -Y of the forefingers, and flexed fingertips are "
    "in front of the palm") {
  for (const char* name : {"allegro", "leap", "shadow", "barrett"}) {
    const HandModel& hand = *shipped_hands().at(name);
    INFO(std::string(name));
    const Posture q = middle_posture(hand);
    double last = INFINITY;
    CHECK(hand.fingers()[0].role == FingerRole::kThumb);
    const Eigen::Vector3d thumb = finger_poses(hand, 0, q).back().p;
    CHECK(thumb.z() > 0);
    for (int finger = 1; finger < static_cast<int>(hand.fingers().size()); ++finger) {
      const auto poses = finger_poses(hand, finger, q);
      CHECK(poses.front().p.x() < last);
      last = poses.front().p.x();
      CHECK(poses.back().p.z() > 0);
      if (finger == 1) CHECK(finger_poses(hand, 0, q).front().p.y() < poses.front().p.y());
    }
  }
}

TEST_SUITE_END();
