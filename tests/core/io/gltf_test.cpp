#include "preshape/io/gltf.h"

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "preshape/geometry/solid_mesh.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;
using nlohmann::json;

TEST_SUITE_BEGIN("core/io");

namespace {

constexpr double kFloat = 1e-6;  // of numbers of the order of one, stored in single precision

/// A glTF binary read by the specification alone (glTF 2.0, sec. 3.6 and 4.4).
struct Glb {
  json tree;
  std::string bytes;

  explicit Glb(const std::string& file) {
    REQUIRE(file.size() > 28);
    CHECK(file.substr(0, 4) == "glTF");
    CHECK(word(file, 4) == 2);
    CHECK(word(file, 8) == file.size());
    const std::size_t length = word(file, 12);
    CHECK(file.substr(16, 4) == "JSON");
    CHECK(length % 4 == 0);
    tree = json::parse(file.substr(20, length));
    const std::size_t rest = word(file, 20 + length);
    CHECK(file.substr(24 + length, 4) == std::string("BIN\0", 4));
    CHECK(rest % 4 == 0);
    REQUIRE(28 + length + rest == file.size());
    bytes = file.substr(28 + length);
    CHECK(rest - tree["buffers"][0]["byteLength"].get<std::size_t>() < 4);
  }

  static std::uint32_t word(const std::string& text, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, text.data() + at, 4);
    return value;
  }

  /// The elements of an accessor, which must lie in its view, and that in the buffer.
  std::vector<std::vector<double>> elements(std::size_t index) const {
    static const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const json& accessor = tree["accessors"][index];
    const json& view = tree["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const bool floats = accessor["componentType"] == 5126;
    REQUIRE((floats || accessor["componentType"] == 5125));
    const std::size_t width = widths.at(accessor["type"]), count = accessor["count"];
    const std::size_t offset = accessor.value("byteOffset", 0u),
                      begin = view.value("byteOffset", 0u) + offset;
    CHECK(begin % 4 == 0);
    CHECK_FALSE(view.contains("byteStride"));
    REQUIRE(offset + 4 * width * count <= view["byteLength"].get<std::size_t>());
    REQUIRE(begin + 4 * width * count <= tree["buffers"][0]["byteLength"].get<std::size_t>());
    std::vector<std::vector<double>> rows(count, std::vector<double>(width));
    for (std::size_t i = 0; i < count * width; ++i) {
      const std::uint32_t bits = word(bytes, begin + 4 * i);
      float number = 0;
      std::memcpy(&number, &bits, 4);
      rows[i / width][i % width] = floats ? static_cast<double>(number) : bits;
    }
    return rows;
  }

  const json& node(const std::string& name) const {
    for (const json& one : tree["nodes"]) {
      if (one["name"] == name) return one;
    }
    FAIL("no node '", name, "'");
    return tree;
  }

  std::set<std::string> names_below(const json& parent) const {
    std::set<std::string> names;
    for (const std::size_t child : parent.value("children", std::vector<std::size_t>{}))
      names.insert(tree["nodes"][child]["name"]);
    return names;
  }

  /// The keys of a node's channel: times and outputs; empty where it has none.
  std::pair<std::vector<std::vector<double>>, std::vector<std::vector<double>>> keys(const std::string& name,
                                                                                     const char* path) const {
    if (!tree.contains("animations")) return {};
    const json& animation = tree["animations"][0];
    for (const json& channel : animation["channels"]) {
      if (tree["nodes"][channel["target"]["node"].get<std::size_t>()]["name"] != name ||
          channel["target"]["path"] != path)
        continue;
      const json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      return {elements(sampler["input"]), elements(sampler["output"])};
    }
    return {};
  }
};

Pose turned(double angle, const Eigen::Vector3d& axis, const Eigen::Vector3d& p) {
  return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), p};
}

/// A box between two fingertips of a hand of two links, which turns by more than a half.
GraspScene example() {
  GraspScene scene;
  scene.title = "box, T1_2";
  Solid box{Solid::Kind::kBox, 0, 0, {0.03, 0.02, 0.05}};
  scene.object_O = transformed(solid_mesh(box), {Eigen::Matrix3d::Identity(), {0.01, 0, 0}});
  scene.links = {{"palm", box, {}}, {"thumb link 1", {Solid::Kind::kCapsule, 0.01, 0.02, {}}, {}}};
  scene.frames = 5;
  for (int i = 0; i < scene.frames; ++i) {
    scene.links[0].X_OS.push_back(turned(0.4, {1, 2, 3}, {-0.2, 0, 0}));
    scene.links[1].X_OS.push_back(turned(1.1 * i, {0, 1, 0.2}, {-0.1, 0.01 * i, 0.02}));
  }
  scene.contacts = {ContactFrame::at({0.01, -0.02, 0.004}, {0, 1, 0}, {1, 0, 0}),
                    ContactFrame::at({0.01, 0.02, 0.004}, {0, -1, 0}, {1, 0, 0})};
  scene.fingers = {"thumb", "index"};
  scene.F_C_O = {Wrench({0.2, 1, 0}, {0, 0.5, 0}), Wrench({0, -1, 0}, {0, 0, 0})};
  scene.resultant_O = Wrench({0.2, 0, 0}, {0, 0.5, 0.1});
  scene.approach_m = 0.01;
  return scene;
}

/// Every point of the named node's mesh, where the node stands below its parents.
Box box_of(const aiScene& scene, const char* name) {
  const aiNode* node = scene.mRootNode->FindNode(name);
  REQUIRE(node);
  REQUIRE(node->mNumMeshes == 1);
  aiMatrix4x4 placed;
  for (const aiNode* up = node; up; up = up->mParent) placed = up->mTransformation * placed;
  const aiMesh* mesh = scene.mMeshes[node->mMeshes[0]];
  Eigen::AlignedBox3d box;
  for (unsigned i = 0; i < mesh->mNumVertices; ++i) {
    const aiVector3D p = placed * mesh->mVertices[i];
    box.extend(Eigen::Vector3d(p.x, p.y, p.z));
  }
  return {box.min(), box.max()};
}

}  // namespace

TEST_CASE("glTF: every part is a node of its name below its group, and what is nothing is left out") {
  const Glb glb(gltf_binary(example()));
  using Names = std::set<std::string>;
  CHECK(glb.tree["scenes"].size() == 1);
  const json& root = glb.tree["nodes"][glb.tree["scenes"][0]["nodes"][0].get<std::size_t>()];
  CHECK(root["name"] == "box, T1_2");
  CHECK(glb.names_below(root) == Names{"object", "hand", "contacts", "normals", "wrenches", "plane"});
  CHECK(glb.names_below(glb.node("hand")) == Names{"palm", "thumb link 1"});
  CHECK(glb.names_below(glb.node("contacts")) == Names{"contact thumb", "contact index"});
  CHECK(glb.names_below(glb.node("normals")) == Names{"normal thumb", "normal index"});
  CHECK(glb.names_below(glb.node("wrenches")) ==
        Names{"force thumb", "moment thumb", "force index", "resultant force", "resultant moment"});
  CHECK(glb.names_below(glb.node("plane")) == Names{"approach plane", "approach axis", "opposition axis"});
  GraspScene bare;
  bare.object_O = example().object_O;
  const Glb alone(gltf_binary(bare));
  CHECK(alone.tree["nodes"].size() == 2);
  CHECK_FALSE(alone.tree.contains("animations"));
}

TEST_CASE(
    "glTF: bounds of the accessors are those of the data, indices are of vertices, normals of unit length") {
  const Glb glb(gltf_binary(example()));
  std::size_t meshes = 0;
  for (const json& mesh : glb.tree["meshes"]) {
    const json& primitive = mesh["primitives"][0];
    const std::size_t at = primitive["attributes"]["POSITION"];
    const auto points = glb.elements(at);
    for (std::size_t k = 0; k < 3; ++k) {
      double least = INFINITY, most = -INFINITY;
      for (const auto& p : points) least = std::min(least, p[k]), most = std::max(most, p[k]);
      CHECK(glb.tree["accessors"][at]["min"][k] == least);
      CHECK(glb.tree["accessors"][at]["max"][k] == most);
    }
    for (const auto& index : glb.elements(primitive["indices"]))
      CHECK(index[0] < static_cast<double>(points.size()));
    CHECK(primitive.value("mode", 4) == 4);
    if (primitive["attributes"].contains("NORMAL")) {
      const auto normals = glb.elements(primitive["attributes"]["NORMAL"]);
      CHECK(normals.size() == points.size());
      for (const auto& n : normals) CHECK_NEAR(std::hypot(n[0], n[1], n[2]), 1.0, kFloat);
    }
    const json& material = glb.tree["materials"][primitive["material"].get<std::size_t>()];
    CHECK(material["pbrMetallicRoughness"]["baseColorFactor"].size() == 4);
    CHECK((material.value("alphaMode", "OPAQUE") == "BLEND") ==
          (material["pbrMetallicRoughness"]["baseColorFactor"][3] < 1.0));
    ++meshes;
  }
  CHECK(meshes == 15);
  CHECK_FALSE(glb.tree.contains("extensionsUsed"));
}

TEST_CASE("glTF: the motion's keys are the links' poses, by the shorter way, and end where the nodes rest") {
  const GraspScene scene = example();
  const Glb glb(gltf_binary(scene));
  REQUIRE(glb.tree["animations"].size() == 1);
  for (const json& channel : glb.tree["animations"][0]["channels"]) {
    CHECK_FALSE(glb.tree["nodes"][channel["target"]["node"].get<std::size_t>()].contains(
        "matrix"));  // not allowed with TRS keys
  }
  for (const SceneLink& link : scene.links) {
    const auto [times, places] = glb.keys(link.name, "translation");
    const auto [turn_times, turns] = glb.keys(link.name, "rotation");
    REQUIRE(places.size() == link.X_OS.size());
    REQUIRE(turns.size() == link.X_OS.size());
    CHECK(times == turn_times);
    CHECK(times.front()[0] == 0.0);
    CHECK_NEAR(times.back()[0], 1.5, kFloat);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Eigen::Quaterniond q(turns[i][3], turns[i][0], turns[i][1], turns[i][2]);
      CHECK((q.toRotationMatrix() - link.X_OS[i].R).norm() < 10 * kFloat);
      CHECK((Eigen::Vector3d(places[i][0], places[i][1], places[i][2]) - link.X_OS[i].p).norm() < kFloat);
      if (i > 0) CHECK(times[i][0] > times[i - 1][0]);
      if (i > 0)
        CHECK(q.dot(Eigen::Quaterniond(turns[i - 1][3], turns[i - 1][0], turns[i - 1][1], turns[i - 1][2])) >
              0);
    }
    const json& rest = glb.node(link.name);
    const auto p = rest["translation"].get<std::vector<double>>(),
               r = rest["rotation"].get<std::vector<double>>();
    CHECK((Eigen::Vector3d(p[0], p[1], p[2]) - link.X_OS.back().p).norm() < kFloat);
    CHECK((Eigen::Quaterniond(r[3], r[0], r[1], r[2]).toRotationMatrix() - link.X_OS.back().R).norm() <
          10 * kFloat);
  }
  CHECK(glb.keys("hand", "translation").first.empty());
}

TEST_CASE("glTF: with a free way the hand comes that way first, by a diagonal at most") {
  GraspScene scene = example();
  const double diagonal = bounding_box(scene.object_O).extents().norm();
  for (const double way : {0.05, 10.0}) {
    scene.way_O = {way, 0, 0};
    const Glb glb(gltf_binary(scene));
    const auto [times, places] = glb.keys("hand", "translation");
    REQUIRE(places.size() == 3);
    CHECK_NEAR(places[0][0], -std::min(way, diagonal), kFloat);
    CHECK(places[1] == std::vector<double>{0, 0, 0});
    CHECK(glb.keys("palm", "translation").first.front() == times[1]);
    CHECK(glb.keys("palm", "translation").first.back() == times[2]);
  }
}

TEST_CASE(
    "glTF: read again, the scene has its names, its object where it was, and arrows that meet their "
    "contacts") {
  const GraspScene scene = example();
  const std::string file = gltf_binary(scene);
  Assimp::Importer importer;
  const aiScene* ai = importer.ReadFileFromMemory(file.data(), file.size(), 0, "glb");
  REQUIRE(ai);
  const Glb glb(file);
  for (const json& node : glb.tree.at("nodes"))
    CHECK(ai->mRootNode->FindNode(node["name"].get<std::string>().c_str()));
  const auto same_box = [&](const Box& box, const Box& other) {
    CHECK((box.lower - other.lower).norm() < kFloat);
    CHECK((box.upper - other.upper).norm() < kFloat);
  };
  same_box(box_of(*ai, "object"), bounding_box(scene.object_O));
  for (const SceneLink& link : scene.links) {
    same_box(box_of(*ai, link.name.c_str()),
             bounding_box(transformed(solid_mesh(link.solid, 16), link.X_OS.back())));
  }
  const double unit = bounding_box(scene.object_O).extents().norm() / 5;
  CHECK_NEAR(box_of(*ai, "force index").lower.y(), 0.02,
             kFloat);  // pushes down on the upper side, from above
  CHECK_NEAR(box_of(*ai, "force index").upper.y(), 0.02 + unit, kFloat);
  CHECK_NEAR(box_of(*ai, "moment thumb").upper.y(), -0.02, kFloat);
  CHECK_NEAR(box_of(*ai, "moment thumb").lower.y(), -0.02 - 0.5 * unit, kFloat);
  CHECK_NEAR(box_of(*ai, "contact thumb").centre().y(), -0.02, kFloat);
  CHECK_NEAR(box_of(*ai, "approach plane").extents().z(), 0.0, kFloat);
  CHECK_NEAR(box_of(*ai, "approach plane").centre().z(), 0.004, kFloat);  // where the fingers stand
  CHECK_NEAR(box_of(*ai, "opposition axis").centre().x(), 0.01, kFloat);
  CHECK_NEAR(box_of(*ai, "opposition axis").centre().z(), 0.004, kFloat);
  REQUIRE(ai->mNumAnimations == 1);
  CHECK_NEAR(ai->mAnimations[0]->mDuration / ai->mAnimations[0]->mTicksPerSecond, 1.5, kFloat);
}

TEST_CASE(
    "glTF: the approach volume stands where the open hand had it, its normal an arrow from the entrance's "
    "middle") {
  GraspScene scene = example();
  ApproachVolume volume;
  volume.mesh_O = transformed(solid_mesh({Solid::Kind::kBox, 0, 0, {0.04, 0.05, 0.01}}),
                              turned(0.0, {0, 0, 1}, {-0.06, 0, 0.004}));
  volume.entrance_O = {
      {-0.02, -0.05, -0.006}, {-0.02, 0.05, -0.006}, {-0.02, 0.05, 0.014}, {-0.02, -0.05, 0.014}};
  volume.centroid_O = {-0.02, 0, 0.004};
  scene.approach_volume = volume;
  const std::string file = gltf_binary(scene);
  const Glb glb(file);
  CHECK(glb.names_below(glb.node("approach")) ==
        std::set<std::string>{"approach volume", "entrance", "entrance normal"});
  Assimp::Importer importer;
  const aiScene* ai = importer.ReadFileFromMemory(file.data(), file.size(), 0, "glb");
  REQUIRE(ai);
  const Box box = box_of(*ai, "approach volume"), wanted = bounding_box(volume.mesh_O);
  CHECK_NEAR(box.lower, wanted.lower, kFloat);
  CHECK_NEAR(box.upper, wanted.upper, kFloat);
  const double size = bounding_box(scene.object_O).extents().norm();
  const Box outline = box_of(*ai, "entrance");
  CHECK_NEAR(outline.centre(), volume.centroid_O, kFloat);
  CHECK_NEAR(outline.extents(), Eigen::Vector3d(0, 0.1, 0.02) + Eigen::Vector3d::Constant(0.012 * size),
             0.001 * size);
  const Box normal = box_of(*ai, "entrance normal");
  CHECK_NEAR(normal.lower.x(), volume.centroid_O.x(), kFloat);
  CHECK_NEAR(normal.upper.x(), volume.centroid_O.x() + 0.3 * size, kFloat);
}

TEST_CASE(
    "glTF: links that collide have a material of their own; the asset tells the verdict and which try is "
    "shown") {
  GraspScene scene = example();
  const auto material = [](const Glb& glb, const char* name) {
    const json& mesh = glb.tree["meshes"][glb.node(name)["mesh"].get<std::size_t>()];
    return glb.tree["materials"][mesh["primitives"][0]["material"].get<std::size_t>()]["name"]
        .get<std::string>();
  };
  const Glb before(gltf_binary(scene));
  CHECK(material(before, "palm") == "palm");
  CHECK(material(before, "thumb link 1") == "link");
  CHECK(before.tree["asset"]["extras"] == json{{"verdict", ""}, {"try", 1}, {"shown", ""}});
  scene.links[1].collides = true;
  scene.verdict = "It \"serves\".", scene.shown_try = 2, scene.shown = "second try: plane 9";
  const Glb after(gltf_binary(scene));
  CHECK(material(after, "palm") == "palm");
  CHECK(material(after, "thumb link 1") == "collision");
  CHECK(after.tree["asset"]["extras"] ==
        json{{"verdict", scene.verdict}, {"try", 2}, {"shown", scene.shown}});
}

TEST_CASE("glTF: the same scene gives the same bytes") {
  CHECK(gltf_binary(example()) == gltf_binary(example()));
}

TEST_SUITE_END();
