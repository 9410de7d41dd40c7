// The hands of the test data through hand/urdf, and the published hands in hands/ against the same figures.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include <Eigen/Geometry>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "preshape/script/script.h"
#include "support/data.h"
#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

/// A hand of the test data by its table in tests/plugins/hand/urdf; nothing where there is no test data.
std::shared_ptr<const HandModel> urdf_hand(const std::string& name) {
  const auto data = test_data("hands");
  if (data.empty()) return nullptr;
  Value description = read_description(source_file("tests/plugins/hand/urdf") / (name + ".lua"));
  description.set("file", (data / description.find("file")->string()).string());
  return registry().create<HandModel>("urdf", Value::table({{"description", description}}));
}

std::vector<std::string> notes_of(const HandModel& hand) {
  const auto* notes = static_cast<const std::vector<std::string>*>(hand.extension("hand/urdf/notes"));
  REQUIRE(notes);
  return *notes;
}

struct Expected {
  const char* name;
  std::size_t fingers, joints, drives, solids, notes;
};

/// Values of one finger within its limits, without its couplings.
std::vector<double> random_values(const HandModel& hand, int finger, Random& random) {
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  std::vector<double> q;
  for (int k = 0; k < about.joint_count; ++k) {
    const Joint& joint = hand.joints()[static_cast<std::size_t>(about.first_joint + k)];
    q.push_back(random.uniform(joint.lower, joint.upper));
  }
  return q;
}

int finger_count(const HandModel& hand) {
  return static_cast<int>(hand.fingers().size());
}

using Numbers = std::vector<double>;

Numbers numbers_in(const std::string& text) {
  Numbers numbers;
  static const std::regex number("[-+0-9.eE]+");
  for (std::sregex_iterator match(text.begin(), text.end(), number), end; match != end; ++match)
    numbers.push_back(std::stod(match->str()));
  return numbers;
}

std::string attribute(const std::string& element, const std::string& key) {
  std::smatch match;
  return std::regex_search(element, match, std::regex("\\b" + key + "\\s*=\\s*\"([^\"]*)\"")) ? match[1].str()
                                                                                              : "";
}

/// The text of a URDF's joint, from its tag to its end.
std::string joint_text(const std::string& urdf, const std::string& name) {
  const auto begin = urdf.find("<joint name=\"" + name + "\"");
  REQUIRE(begin != std::string::npos);
  return urdf.substr(begin, urdf.find("</joint>", begin) - begin);
}

std::string tag_in(const std::string& text, const std::string& tag) {
  const auto begin = text.find("<" + tag);
  return begin == std::string::npos ? "" : text.substr(begin, text.find('>', begin) - begin);
}

Eigen::Matrix4d translation(double x, double y, double z) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topRightCorner<3, 1>() << x, y, z;
  return T;
}

/// Rodrigues' formula.
Eigen::Matrix4d turn(const Eigen::Vector3d& axis, double angle) {
  Eigen::Matrix3d K;
  K << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() += std::sin(angle) * K + (1 - std::cos(angle)) * K * K;
  return T;
}

/// A joint's transform by the numbers in the file's text alone.
Eigen::Matrix4d transform(const std::string& joint, double q) {
  const std::string origin = tag_in(joint, "origin");
  Numbers xyz = numbers_in(attribute(origin, "xyz")), rpy = numbers_in(attribute(origin, "rpy")),
          axis = numbers_in(attribute(tag_in(joint, "axis"), "xyz"));
  if (xyz.empty()) xyz = {0, 0, 0};
  if (rpy.empty()) rpy = {0, 0, 0};
  Eigen::Matrix4d T = translation(xyz[0], xyz[1], xyz[2]) * turn(Eigen::Vector3d::UnitZ(), rpy[2]) *
                      turn(Eigen::Vector3d::UnitY(), rpy[1]) * turn(Eigen::Vector3d::UnitX(), rpy[0]);
  if (!axis.empty()) T = T * turn(Eigen::Vector3d(axis[0], axis[1], axis[2]).normalized(), q);
  return T;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("URDF hands: the hands of the test data load with their fingers, joints and geometry") {
  const Expected expected[] = {
      {"allegro", 4, 16, 16, 23, 0}, {"leap", 4, 16, 16, 71, 0}, {"barrett", 3, 8, 8, 32, 0},
      {"dclaw", 3, 9, 9, 31, 0},     {"dg3f", 3, 12, 12, 16, 2}, {"orca", 5, 21, 17, 0, 31},
  };
  for (const Expected& e : expected) {
    const auto hand = urdf_hand(e.name);
    if (!hand) return;
    INFO(std::string(e.name));
    CHECK(hand->fingers().size() == e.fingers);
    CHECK(hand->joints().size() == e.joints);
    CHECK(driven_joints(*hand).size() == e.drives);
    CHECK(hand->solids().size() == e.solids);
    CHECK(notes_of(*hand).size() == e.notes);
    for (const LinkSolid& solid : hand->solids()) CHECK(solid.X_LS.p.norm() < 0.2);
  }
}

TEST_CASE("URDF hands: what urdfdom leaves out of a file is noted, as is every mesh that is not there") {
  const auto dg3f = urdf_hand("dg3f"), orca = urdf_hand("orca");
  if (!dg3f) return;
  CHECK(notes_of(*dg3f)[1] == "Could not parse inertial element for Link [l_dg_mount]");
  for (const auto& note : notes_of(*orca)) CHECK(note.ends_with(" is not there and is left out"));
}

TEST_CASE("URDF hands: a MuJoCo model is refused as what it is") {
  if (test_data("hands").empty()) return;
  CHECK_THROWS_SAYING(urdf_hand("shadow"), InputError,
                      "right_hand.xml: is no URDF but a MuJoCo model: its first element, in line 1, is <mujoco>, not "
                      "<robot>; give a URDF of the hand");
}

TEST_CASE("URDF hands: a wrist that all fingers share is the first one's joint, and the others' follow it") {
  const auto hand = urdf_hand("orca");
  if (!hand) return;
  const auto joints = hand->joints();
  CHECK(joints[0].name == "right_wrist");
  CHECK(joints[0].leader == -1);
  int followers = 0;
  for (const Joint& joint : joints) {
    if (joint.leader != 0) continue;
    ++followers;
    CHECK(joint.ratio == 1.0);
    CHECK(joint.offset == 0.0);
  }
  CHECK(followers == 4);
  CHECK(joints[static_cast<std::size_t>(hand->fingers()[1].first_joint)].name == "right_wrist (index)");
  // The wrist turns the whole hand: distances between fingertips stay.
  Posture rest = middle_posture(*hand), bent = rest;
  bent[0] += 0.3;
  apply_couplings(*hand, bent);
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < a; ++b) {
      const auto apart = [&](const Posture& q) {
        return (finger_poses(*hand, a, q).back().p - finger_poses(*hand, b, q).back().p).norm();
      };
      CHECK_NEAR(apart(rest), apart(bent), 1e-14);
    }
  }
}

TEST_CASE(
    "Published hands: Allegro, LEAP and Barrett move as their URDF does, to 1e-9 m, within the same limits") {
  for (const char* name : {"allegro", "leap", "barrett"}) {
    const auto urdf = urdf_hand(name);
    if (!urdf) return;
    const HandModel& hand = *shipped_hands().at(name);
    INFO(std::string(name));
    REQUIRE(hand.fingers().size() == urdf->fingers().size());
    REQUIRE(hand.joints().size() == urdf->joints().size());
    for (std::size_t i = 0; i < hand.joints().size(); ++i) {
      INFO(hand.joints()[i].name, " and ", urdf->joints()[i].name);
      CHECK(hand.joints()[i].lower == urdf->joints()[i].lower);
      CHECK(hand.joints()[i].upper == urdf->joints()[i].upper);
    }
    Random random(21);
    double worst = 0.0, turned = 0.0;
    for (int i = 0; i < 1000; ++i) {
      for (int finger = 0; finger < finger_count(hand); ++finger) {
        const auto q = random_values(hand, finger, random);
        const auto ours = forward(hand, finger, q), theirs = forward(*urdf, finger, q);
        for (std::size_t k = 1; k < ours.size(); ++k) {  // the frame 0 of a chain is its own matter
          worst = std::max(worst, (ours[k].p - theirs[k].p).norm());
          turned = std::max(turned, (ours[k].R - theirs[k].R).norm());
        }
      }
    }
    CHECK(worst < 1e-9);
    CHECK(turned < 1e-7);
  }
}

TEST_CASE("Published hands: Allegro's fingertips are where plain products of its URDF's numbers put them") {
  const auto data = test_data("hands");
  if (data.empty()) return;
  const std::string urdf = read_text(data / "allegro_hand_right/allegro_hand_right.urdf");
  const HandModel& hand = *shipped_hands().at("allegro");
  const int first_of_finger[] = {12, 0, 4, 8};
  // H in base_link: +X = y, +Z ten degrees from x towards z, origin on the palm.
  const double lean = 10 * M_PI / 180;
  Eigen::Matrix4d T_PH = Eigen::Matrix4d::Identity();
  T_PH.col(0).head<3>() << 0, 1, 0;
  T_PH.col(1).head<3>() << -std::sin(lean), 0, std::cos(lean);
  T_PH.col(2).head<3>() << std::cos(lean), 0, std::sin(lean);
  T_PH.col(3).head<3>() << 0.0117, 0, -0.04;
  const Eigen::Matrix4d T_HP = T_PH.inverse();
  Random random(22);
  double worst = 0.0;
  for (int finger = 0; finger < 4; ++finger) {
    std::vector<std::string> joints;
    for (int k = 0; k < 4; ++k)
      joints.push_back(joint_text(urdf, fmt::format("joint_{}.0", first_of_finger[finger] + k)));
    joints.push_back(joint_text(urdf, fmt::format("joint_{}.0_tip", first_of_finger[finger] + 3)));
    for (int i = 0; i < 250; ++i) {
      const auto q = random_values(hand, finger, random);
      Eigen::Matrix4d T = T_HP;
      for (std::size_t k = 0; k < 5; ++k) T = T * transform(joints[k], k < 4 ? q[k] : 0.0);
      worst = std::max(worst, (forward(hand, finger, q).back().p - T.topRightCorner<3, 1>()).norm());
    }
  }
  CHECK(worst < 1e-9);
}

TEST_SUITE_END();
