// The plugin hand/urdf on small files: chains, couplings, geometry, and what it refuses.
#include <cmath>
#include <fstream>
#include <numbers>

#include <Eigen/Geometry>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name='" + name + "'>" + inside + "</link>\n";
}

std::string collision(const std::string& geometry) {
  return "<collision><origin xyz='1 2 3'/><geometry>" + geometry + "</geometry></collision>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child,
                  const std::string& inside =
                      "<axis xyz='0 0 1'/><limit lower='-1' upper='1.5' effort='2' velocity='1'/>") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
         child + "'/><origin xyz='1 0 0'/>" + inside + "</joint>\n";
}

/// A URDF and its table in a folder of their own.
class Files {
 public:
  explicit Files(const std::string& urdf) {
    write("hand.urdf", "<?xml version='1.0'?>\n<robot name='r'>\n" + urdf + "</robot>\n");
  }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }

  /// Fingers by their tips' links; the first is the thumb.
  Value table(const std::vector<std::string>& tips, const std::string& base = "palm") const {
    static const char* const kRoles[] = {"thumb", "index", "middle"};
    Value::List fingers;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      fingers.push_back(Value::table(
          {{"name", kRoles[i]}, {"role", kRoles[i]}, {"tip", Value::table({{"link", tips[i]}})}}));
    }
    Value description = Value::table({{"model", "urdf"},
                                      {"file", "hand.urdf"},
                                      {"base", Value::table({{"link", base}})},
                                      {"unit_length", 0.03},
                                      {"finger_spacing", 0.03},
                                      {"maximum_opening", 0.1},
                                      {"base_width", 0.1},
                                      {"fingers", Value::list(std::move(fingers))}});
    description.at({(folder_ / "hand.lua").string(), 1});
    return description;
  }

  std::shared_ptr<HandModel> hand(const std::vector<std::string>& tips,
                                  const std::string& base = "palm") const {
    return load(table(tips, base));
  }
  static std::shared_ptr<HandModel> load(const Value& description) {
    return registry().create<HandModel>("urdf", Value::table({{"description", description}}));
  }

 private:
  TemporaryDirectory folder_;
};

/// A palm with two fingers of two joints: a1, a2 and b1, b2.
std::string two_fingers(
    const std::string& a2 = "<axis xyz='0 0 1'/><limit lower='-1' upper='1.5' effort='2' velocity='1'/>",
    const std::string& b2 = "<axis xyz='0 0 1'/><limit lower='-1' upper='1.5' effort='2' velocity='1'/>") {
  return link("palm") + link("la1") + link("la2") + link("lb1") + link("lb2") +
         joint("a1", "revolute", "palm", "la1") + joint("a2", "revolute", "la1", "la2", a2) +
         joint("b1", "revolute", "palm", "lb1") + joint("b2", "revolute", "lb1", "lb2", b2);
}

std::string mimic(const std::string& leader, const std::string& numbers = "") {
  return "<axis xyz='0 0 1'/><limit lower='-1' upper='1.5' effort='0' velocity='1'/><mimic joint='" + leader +
         "' " + numbers + "/>";
}

const std::vector<std::string>& notes_of(const HandModel& hand) {
  return *static_cast<const std::vector<std::string>*>(hand.extension("hand/urdf/notes"));
}

}  // namespace

TEST_CASE("URDF: fixed joints are folded in, a continuous one turns once about, a prismatic one slides") {
  const Files files(link("world") + link("palm") + link("l0") + link("l1") + link("l2") + link("tip") +
                    joint("w", "fixed", "world", "palm", "") + joint("f", "fixed", "palm", "l0", "") +
                    joint("c", "continuous", "l0", "l1", "<axis xyz='0 0 2'/>") +
                    joint("p", "prismatic", "l1", "l2",
                          "<axis xyz='0 3 0'/><limit lower='0' upper='0.5' effort='7' velocity='1'/>") +
                    joint("t", "fixed", "l2", "tip", ""));
  const auto hand = files.hand({"tip"});
  const auto joints = hand->joints();
  REQUIRE(joints.size() == 2);
  CHECK(joints[0].lower == -std::numbers::pi);
  CHECK(joints[0].upper == std::numbers::pi);
  CHECK(std::isnan(joints[0].torque_limit));
  CHECK(joints[1].prismatic);
  CHECK(joints[1].upper == 0.5);
  CHECK(joints[1].torque_limit == 7.0);
  const auto poses = forward(*hand, 0, {0.5, 0.25});
  const double c = std::cos(0.5), s = std::sin(0.5);
  CHECK_NEAR(poses[0].p, Eigen::Vector3d(2, 0, 0), kEps);
  CHECK_NEAR(poses[2].p, Eigen::Vector3d(2 + c - 0.25 * s, s + 0.25 * c, 0), 4 * kEps);
  CHECK_NEAR(poses[3].p, Eigen::Vector3d(2 + 2 * c - 0.25 * s, 2 * s + 0.25 * c, 0), 4 * kEps);
}

TEST_CASE(
    "URDF: the base's pose puts H into the palm's link, and the tip's position the fingertip into the last "
    "one") {
  const Files files(two_fingers());
  Value table = files.table({"la2"});
  table.find("base")->set("position", Value::numbers({0, 0, 0.5}));
  table.find("base")->set("rotation", Value::numbers({0, 0, std::numbers::pi / 2}));
  table.find("fingers")->items()[0].find("tip")->set("position", Value::numbers({0.25, 0, 0}));
  CHECK_NEAR(forward(*Files::load(table), 0, {0, 0}).back().p, Eigen::Vector3d(0, -2.25, -0.5), 4 * kEps);
}

TEST_CASE("URDF: sizes in millimetres, and solids without a size, are refused with the number") {
  const Files files(two_fingers() + link("big", collision("<sphere radius='-0.5'/>")) +
                    joint("b", "fixed", "palm", "big", ""));
  CHECK_THROWS_SAYING(files.hand({"la2"}), InputError,
                      "link 'big', <collision>: its sizes must be positive numbers, got -0.5");
  Value table = files.table({"la2"});
  table.set("unit_length", 30.0);
  CHECK_THROWS_SAYING(Files::load(table), InputError, "'unit_length' must be in 1e-06 .. 1, got 30");
}

TEST_CASE("URDF: a joint that mimics one of another finger follows it") {
  const auto hand = Files(two_fingers(mimic("b1", "multiplier='-0.5' offset='0.25'"))).hand({"la2", "lb2"});
  CHECK(hand->joints()[1].leader == 2);
  CHECK(hand->joints()[1].ratio == -0.5);
  CHECK(hand->joints()[1].offset == 0.25);
  CHECK(driven_joints(*hand) == std::vector<int>{0, 2, 3});
}

TEST_CASE("URDF: a joint that mimics a follower follows that one's leader, and a plain mimic is one to one") {
  const auto hand =
      Files(two_fingers(mimic("b2", "multiplier='0.5' offset='0.1'"), mimic("b1", "offset='0.2'")))
          .hand({"la2", "lb2"});
  CHECK(hand->joints()[3].leader == 2);
  CHECK(hand->joints()[3].ratio == 1.0);
  CHECK(hand->joints()[1].leader == 2);
  CHECK(hand->joints()[1].ratio == 0.5);
  CHECK_NEAR(hand->joints()[1].offset, 0.5 * 0.2 + 0.1, kEps);
  CHECK(hand->joints()[3].offset == 0.2);
}

TEST_CASE("URDF: an axis that is nearly against z loses no digits") {
  const Files files(
      link("palm") + link("l") +
      joint("j", "revolute", "palm", "l",
            "<axis xyz='0 -0.00001 -1'/><limit lower='-1' upper='1' effort='1' velocity='1'/>"));
  const Eigen::Vector3d axis = Eigen::Vector3d(0, -1e-5, -1).normalized();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, axis).toRotationMatrix();
  CHECK_NEAR(forward(*files.hand({"l"}), 0, {0.7})[1].R, turn, 1e-14);
}

TEST_CASE("URDF: where the leader moves no finger, the first follower leads within the leader's limits") {
  const auto crank =
      link("crank") + joint("drive", "revolute", "palm", "crank",
                            "<axis xyz='0 0 1'/><limit lower='0' upper='0.5' effort='1' velocity='1'/>");
  const auto hand = Files(crank + two_fingers(mimic("drive", "multiplier='2' offset='0.1'"),
                                              mimic("drive", "multiplier='-1'")))
                        .hand({"la2", "lb2"});
  const auto joints = hand->joints();
  CHECK(joints[1].leader == -1);
  CHECK(joints[1].lower == 0.1);
  CHECK(joints[1].upper == 1.1);
  CHECK(joints[3].leader == 1);
  // drive = 0.3: a2 = 0.7, b2 = -0.3
  CHECK_NEAR(joints[3].ratio * 0.7 + joints[3].offset, -0.3, 4 * kEps);
  const auto backwards = Files(crank + two_fingers(mimic("drive", "multiplier='-1' offset='0.1'"), mimic("drive"))).hand({"la2", "lb2"});
  CHECK(backwards->joints()[1].lower == -0.4);
  CHECK(backwards->joints()[1].upper == 0.1);
}

TEST_CASE(
    "URDF: mimics in a circle, of unknown joints or without room are refused by the file and the joint") {
  const auto refused = [](const std::string& a2, const std::string& b2, const char* sentence) {
    const Files files(two_fingers(a2, b2));
    CHECK_THROWS_SAYING(files.hand({"la2", "lb2"}), InputError, sentence);
  };
  refused(mimic("b2"), mimic("a2"), "hand.urdf: joint 'a2' mimics itself in a circle");
  refused(mimic("b11"), mimic("b1"),
          "hand.urdf: joint 'a2' mimics 'b11', which is no joint; did you mean 'b1'?");
  refused(mimic("b1", "offset='5'"), mimic("b1"), "hand.urdf: joint 'b1' cannot move");
  refused(mimic("b1", "multiplier='nan'"), mimic("b1"), "hand.urdf");
}

TEST_CASE("URDF: a joint that cannot be a finger's is refused, one of a single value is fixed there") {
  const Files planar(link("palm") + link("l") + joint("j", "planar", "palm", "l", "<axis xyz='0 0 1'/>"));
  CHECK_THROWS_SAYING(planar.hand({"l"}), InputError, "hand.urdf: joint 'j' is planar");
  const Files upside(link("palm") + link("l") +
                     joint("j", "revolute", "palm", "l",
                           "<axis xyz='0 0 1'/><limit lower='1' upper='-1' effort='1' velocity='1'/>"));
  CHECK_THROWS_SAYING(upside.hand({"l"}), InputError,
                      "joint 'j': <limit> must have finite lower <= upper, got 1 and -1");
  const Files flat(link("palm") + link("l") +
                   joint("j", "revolute", "palm", "l",
                         "<axis xyz='0 0 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/>"));
  CHECK_THROWS_SAYING(flat.hand({"l"}), InputError, "joint 'j': <axis> must have a direction");
  const Files single(link("palm") + link("l") + link("m") +
                     joint("j", "revolute", "palm", "l",
                           "<axis xyz='0 0 1'/><limit lower='0.5' upper='0.5' effort='1' velocity='1'/>") +
                     joint("k", "revolute", "l", "m"));
  const auto hand = single.hand({"m"});
  CHECK(hand->joints().size() == 1);
  CHECK_NEAR(forward(*hand, 0, {0}).back().p, Eigen::Vector3d(1 + std::cos(0.5), std::sin(0.5), 0), 2 * kEps);
}

TEST_CASE(
    "URDF: geometry stands on the link that carries it, and what moves by no finger's joint is left out") {
  const Files files(link("palm", collision("<box size='2 4 6'/>")) +
                    link("l", collision("<sphere radius='0.5'/>")) +
                    link("tip", collision("<cylinder radius='0.5' length='3'/>") +
                                    collision("<cylinder radius='2' length='1'/>")) +
                    link("other", collision("<sphere radius='1'/>")) + joint("j", "revolute", "palm", "l") +
                    joint("t", "fixed", "l", "tip", "") + joint("o", "revolute", "palm", "other"));
  const auto hand = files.hand({"tip"});
  const auto solids = hand->solids();
  REQUIRE(solids.size() == 4);
  CHECK(solids[0].finger == -1);
  CHECK(solids[0].solid.half_extents == Eigen::Vector3d(1, 2, 3));
  CHECK(solids[1].finger == 0);
  CHECK(solids[1].link == 1);
  CHECK(solids[1].solid.radius == 0.5);
  CHECK_NEAR(solids[1].X_LS.p, Eigen::Vector3d(1, 2, 3), 0);
  CHECK(solids[2].link == 1);
  CHECK(solids[2].solid.kind == Solid::Kind::kCapsule);
  CHECK(solids[2].solid.half_length == 1.0);
  CHECK_NEAR(solids[2].X_LS.p, Eigen::Vector3d(2, 2, 3), 0);
  CHECK(solids[3].solid.half_extents == Eigen::Vector3d(2, 2, 0.5));
  REQUIRE(notes_of(*hand).size() == 1);
  CHECK(notes_of(*hand)[0] == "joint 'o' moves no finger: what is behind it is left out");
}

TEST_CASE(
    "URDF: a mesh is bounded, found in its package or beside the file; a missing or broken one is noted") {
  const std::string cube =
      "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\nf 1 2 3\nf 5 6 7\nf 1 4 8\nf "
      "2 3 7\n";
  const auto mesh = [](const std::string& name) {
    return collision("<mesh filename='" + name + "' scale='0.5 1 1'/>");
  };
  const Files files(link("palm", mesh("package://some_hand/meshes/cube.obj") + mesh("meshes/cube.obj") +
                                     mesh("package://some_hand/none.stl") + mesh("broken.obj")) +
                    link("l") + joint("j", "revolute", "palm", "l"));
  files.write("meshes/cube.obj", cube);
  files.write("broken.obj", "f 1 2 99\n");
  const auto hand = files.hand({"l"});
  REQUIRE(hand->solids().size() == 2);
  for (const LinkSolid& solid : hand->solids()) {
    CHECK(solid.solid.kind == Solid::Kind::kBox);
    CHECK_NEAR(solid.solid.half_extents, Eigen::Vector3d(0.5, 2, 3), 1e-6);
    CHECK_NEAR(solid.X_LS.p, Eigen::Vector3d(1.5, 4, 6), 1e-6);
  }
  REQUIRE(notes_of(*hand).size() == 2);
  CHECK(notes_of(*hand)[0] ==
        "link 'palm', <collision>: mesh 'package://some_hand/none.stl' is not there and is left out");
  CHECK(notes_of(*hand)[1].find("broken.obj' cannot be read and is left out") != std::string::npos);
}

TEST_CASE("URDF: what is no URDF, or none of a hand, is refused in one sentence with file and line") {
  const auto refused = [](const std::string& text, const char* sentence) {
    const Files files("");
    files.write("hand.urdf", text);
    CHECK_THROWS_SAYING(files.hand({"l"}), InputError, sentence);
  };
  refused("<robot name='r'>\n<link name='palm'>\n</robot>", "hand.urdf: is not well-formed XML: ");
  refused("", "hand.urdf: is ");
  refused("<sdf version='1'/>", "is no URDF but an SDF model: its first element, in line 1, is <sdf>, not <robot>");
  refused("solid cube", "hand.urdf: is ");
  refused(std::string("<robot\0>", 8), "hand.urdf: is not text");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  refused(deep, "nested deeper than 200");
  refused("<robot name='r'/>", "hand.urdf: is no usable URDF: ");
  refused("<robot name='r'><link name='palm'><xacro:if value='1'/></link></robot>",
          "hand.urdf: has the element <xacro:if>; expand it first");
  refused("<robot name='r'>" + link("palm") + link("l") +
              joint("j", "revolute", "palm", "l", "<axis xyz='0 0 1'/><limit lower='wide' upper='1'/>") + "</robot>",
          "lower value (wide) is not a valid float: Could not parse limit element for joint [j]");
  refused("<robot name='r'><link name='palm'/><link name='l'/></robot>", "hand.urdf: is no usable URDF: ");
  refused("<robot name='r'>" + link("palm") + link("l") + link("m") + joint("a", "fixed", "palm", "l", "") +
              joint("b", "fixed", "l", "m", "") + joint("c", "fixed", "palm", "m", "") + "</robot>",
          "is not a tree: link 'm' hangs on joint 'b' and on joint 'c'");
}

TEST_CASE(
    "URDF: links that are not there, not beyond the palm or do not move are refused at the table's place") {
  const Files files(two_fingers());
  CHECK_THROWS_SAYING(files.hand({"la3"}), InputError,
                      "hand.lua:1: finger 1 'thumb': 'tip' names the link 'la3', which is not in ");
  CHECK_THROWS_SAYING(files.hand({"la3"}), InputError, "did you mean 'la1'?");
  CHECK_THROWS_SAYING(files.hand({"la2"}, "plam"), InputError,
                      "hand.lua:1: hand description: 'base' names the link 'plam'");
  CHECK_THROWS_SAYING(files.hand({"la2"}, "lb1"), InputError,
                      "'tip' names the link 'la2', which is not beyond the base's link 'lb1'");
  CHECK_THROWS_SAYING(files.hand({"palm"}), InputError, "does not move against the base's link 'palm'");
  CHECK_THROWS_SAYING(files.hand({"la2", "la2"}), InputError,
                      "hand.lua:1: finger 2 'index': 'tip' is that of finger 'thumb'; name the link that ends this one");
  CHECK_THROWS_SAYING(Files::load(with(files.table({"la2"}), "file", "none.urdf")), InputError,
                      "hand description: 'file' names no file, got 'none.urdf'; it is looked for beside");
  CHECK_THROWS_SAYING(Files::load(with(files.table({"la2"}), "fiel", "x")), InputError,
                      "unknown key 'fiel'; did you mean 'file'?");
  Value twice = files.table({"la2", "lb2"});
  twice.find("fingers")->items()[1].set("role", "thumb");
  CHECK_THROWS_SAYING(Files::load(twice), InputError,
                      "finger 2 'index': 'role' 'thumb' is taken by finger 'thumb'");
}

TEST_SUITE_END();
