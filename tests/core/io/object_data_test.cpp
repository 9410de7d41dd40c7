// The external test meshes, one by one: what their table says of them must come out.
#include "preshape/base/error.h"
#include "preshape/io/object_reader.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

std::string joined(const std::vector<std::string>& warnings) {
  std::string text;
  for (const auto& warning : warnings) text += (text.empty() ? "" : " | ") + warning;
  return text;
}

struct Solid {
  std::string file;
  std::size_t vertices, triangles;
  std::int64_t faces, normals;
  Eigen::Vector3d lower, upper;
  bool unit_known;
};

// Boxes are printed to four digits in the table.
constexpr double kPrinted = 5.1e-4;

double printed_error(const Eigen::Vector3d& value, const Eigen::Vector3d& printed) {
  const double scale = std::max(1e-6, printed.cwiseAbs().maxCoeff());
  return (value - printed).cwiseAbs().maxCoeff() / scale;
}

}  // namespace

TEST_CASE("Primitives: vertices, triangles, faces, normals and boxes are the table's, and all are closed") {
  const std::vector<Solid> solids = {
      {"cube.obj", 8, 12, 6, 6, {-1, -1, -1}, {1, 1, 1}, false},
      {"cube.off", 8, 12, 6, 6, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, false},
      {"cube.ply", 8, 12, 6, 6, {0, 0, 0}, {1, 1, 1}, false},
      {"brick.glb", 8, 12, 12, 6, {-0.1075, -0.0325, -0.05125}, {0.1075, 0.0325, 0.05125}, true},
      {"sphere.obj", 1082, 2160, 2160, 2160, {-0.9988, -1, -1}, {0.9988, 1, 1}, false},
      {"sphere_2cm.dae", 382, 760, 400, 382, {-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}, true},
      {"cylinder.stl", 210, 416, 416, 66, {-1, -1, 0}, {1, 1, 8}, false},
      {"cylinder_elliptic.obj",
       64,
       124,
       124,
       34,
       {-0.2912, -0.01206, 0.1655},
       {-0.2142, 0.1034, 0.2233},
       false},
      {"disc_pill.glb",
       90,
       176,
       176,
       119,
       {-0.007527, -0.001917, -0.007527},
       {0.007527, 0.002692, 0.007527},
       true},
      {"disc_cd.glb", 288, 576, 576, 341, {-0.06, -0.0006, -0.06}, {0.06, 0.0006, 0.06}, true},
      {"prism.obj", 8, 12, 12, 6, {-0.2336, -0.1036, -0.05706}, {-0.1494, -0.03922, 0.0609}, false},
      {"torus.obj", 288, 576, 576, 264, {-4, -4, -1}, {4, 4, 1}, false},
      {"dodecahedron_poly.obj", 20, 36, 12, 12, {-0.9342, -0.9342, -0.9342}, {0.9342, 0.9342, 0.9342}, false},
      {"cube_cup.obj", 16, 28, 28, 6, {-0.05, -0.05, 0}, {0.05, 0.05, 0.1}, false},
  };
  for (const Solid& solid : solids) {
    const auto file = test_data("objects/primitives/" + solid.file);
    if (file.empty()) return;
    INFO("file: ", solid.file);
    const RawObject object = read_object(file);
    CHECK(object.mesh.vertices.size() == solid.vertices);
    CHECK(object.mesh.triangles.size() == solid.triangles);
    CHECK(object.file_faces == solid.faces);
    CHECK(object.file_normals == solid.normals);
    CHECK(object.unit_known == solid.unit_known);
    CHECK(object.topology.watertight());
    CHECK(object.topology.bounds_volume());
    CHECK(object.topology.pieces == 1);
    CHECK(joined(object.warnings) == std::string());
    CHECK(printed_error(bounding_box(object.mesh).lower, solid.lower) <= kPrinted);
    CHECK(printed_error(bounding_box(object.mesh).upper, solid.upper) <= kPrinted);
    CHECK(volume_properties(object.mesh).volume > 0.0);
  }
}

TEST_CASE("Models: pieces, holes and units are told as they are") {
  struct Model {
    std::string file;
    std::size_t triangles;
    int open_edges;
    bool bounds_volume, unit_known;
    std::string warnings;
  };
  const std::vector<Model> models = {
      {"dolphins.obj", 1683, 27, false, false,
       "the surface is not closed: 27 open edges | the mesh is in 3 pieces"},
      {"CesiumMilkTruck.gltf", 3624, 8, false, true,
       "the surface is not closed: 8 open edges | the mesh is in 14 pieces"},
      {"duck.dae", 4212, 0, true, true, ""},
      {"spot.ply", 5856, 0, true, false, ""},
      {"ballA.off", 3796, 0, true, false, ""},
      {"featuretype.STL", 3476, 0, true, false, ""},
      {"teapot.stl", 894, 64, false, false,
       "the surface is not closed: 64 open edges | the mesh is in 4 pieces"},
      {"wine_glass.glb", 992, 0, true, true, ""},
      {"pliers.glb", 1134, 38, false, true,
       "54 triangles are there more than once | the surface is not closed: 38 open edges | 115 edges belong "
       "to three "
       "or more triangles | the mesh is in 3 pieces"},
  };
  for (const Model& model : models) {
    const auto file = test_data("objects/models/" + model.file);
    if (file.empty()) return;
    INFO("file: ", model.file);
    const RawObject object = read_object(file);
    CHECK(object.mesh.triangles.size() == model.triangles);
    CHECK(object.topology.open_edges == model.open_edges);
    CHECK(object.topology.bounds_volume() == model.bounds_volume);
    CHECK(object.unit_known == model.unit_known);
    CHECK(joined(object.warnings) == model.warnings);
  }
}

TEST_CASE("Models: the truck's wheels are put at both axles and its size is the real one") {
  const auto file = test_data("objects/models/CesiumMilkTruck.gltf");
  if (file.empty()) return;
  const RawObject truck = read_object(file);
  CHECK(printed_error(bounding_box(truck.mesh).lower, {-2.431, -0.2578, -1.396}) <= kPrinted);
  CHECK(printed_error(bounding_box(truck.mesh).upper, {2.438, 2.584, 1.396}) <= kPrinted);
  CHECK(truck.file_faces == 3624);  // 2856 in the file, of which 768 belong to the wheels, used twice
}

TEST_CASE("Welding: the machined part closes at the default tolerance and not at none") {
  const auto file = test_data("objects/models/featuretype.STL");
  if (file.empty()) return;
  CHECK(read_object(file).topology.watertight());
  CHECK(read_object(file, 0.0).topology.open_edges == 576);
}

TEST_CASE("Household: every scan loads in metres' numbers and bounds a volume") {
  for (const char* name : {"mug", "power_drill", "phillips_screwdriver", "hammer", "banana", "cracker_box",
                           "mustard_bottle", "scissors", "tennis_ball", "a_toy_airplane"}) {
    const auto file = test_data(std::string("objects/household/ycb_") + name + ".obj");
    if (file.empty()) return;
    INFO("file: ", name);
    const RawObject object = read_object(file);
    CHECK(object.name == std::string("ycb_") + name);
    CHECK(object.file_faces == 16384);
    CHECK(object.mesh.triangles.size() >= 16378);
    CHECK(object.file_normals > 8000);
    CHECK(object.topology.open_edges == 0);
    CHECK(object.topology.bounds_volume());
    CHECK(volume_properties(object.mesh).volume > 0.0);
    CHECK(bounding_box(object.mesh).extents().maxCoeff() < 0.4);
  }
}

TEST_CASE("Household: the tennis ball has a tennis ball's diameter and a smallest box of about that") {
  const auto file = test_data("objects/household/ycb_tennis_ball.obj");
  if (file.empty()) return;
  const RawObject ball = read_object(file);
  // 67 mm, scanned to about a millimetre: (6 V / pi)^(1/3)
  CHECK_NEAR(std::cbrt(6 * volume_properties(ball.mesh).volume / M_PI), 0.067, 0.001);
  CHECK(smallest_box_axes(ball.mesh) == Eigen::Matrix3d::Identity());
}

TEST_CASE("Household: the cracker box stands askew in its file, and its smallest box is the box") {
  const auto file = test_data("objects/household/ycb_cracker_box.obj");
  if (file.empty()) return;
  const Object box = place_object(read_object(file), {.frame = "smallest_box"}, 0.04);
  // 210 x 158 x 60 mm by the set's own table; the scan is rounded and bulges by a few millimetres.
  CHECK_NEAR(box.box_O.extents(), Eigen::Vector3d(0.213, 0.163, 0.071), 0.008);
}

TEST_CASE("Hard files: each loads with the right warning or is refused in one sentence") {
  struct Hard {
    std::string file;
    std::string refusal;   // "" = it loads
    std::string warnings;  // all of them
    std::size_t triangles;
  };
  const std::vector<Hard> files = {
      {"empty.obj", "it is empty; give a mesh with faces", "", 0},
      {"empty_solid.stl", "it has no faces; give a mesh with faces, not points or lines", "", 0},
      {"malformed.obj", "it cannot be read as obj; mend or export it again (assimp: OBJ: Invalid face index)",
       "", 0},
      {"points_only.ply", "it has no faces; give a mesh with faces, not points or lines", "", 0},
      {"wireframe_only.obj", "it has no faces; give a mesh with faces, not points or lines", "", 0},
      {"box_UTF16BE.obj", "it is UTF-16 text; save it as UTF-8", "", 0},
      {"BoxWithInfinites.glb", "which is not finite; mend the mesh", "", 0},
      {"IndexOutOfRange.gltf", "", "the surface is not closed: 3 open edges", 11},
      {"sphereWithHole.stl", "", "the surface is not closed: 9 open edges", 285},
      {"soup.stl", "", "the surface is not closed: 300 open edges | the mesh is in 100 pieces", 100},
      {"wallhole.obj", "",
       "13 triangles without area were dropped | 2 triangles are there more than once | 2 edges belong to "
       "three or more "
       "triangles",
       53},
      {"Spider_ascii.stl", "",
       "56 triangles without area were dropped | the surface is not closed: 72 open edges | the faces do not "
       "all point "
       "the same way: neighbours disagree at 10 edges | the mesh is in 18 pieces",
       1312},
      {"fan3.obj", "", "the surface is not closed: 6 open edges | 1 edge belongs to three or more triangles",
       3},
      {"hourglass_ico.obj", "", "the mesh is in 2 pieces", 40},
      {"joined_tetrahedra.obj", "",
       "1 triangle is there more than once | 3 edges belong to three or more triangles", 8},
      {"bad_geometry_volume_zero.obj", "",
       "the faces do not all point the same way: neighbours disagree at 6 edges", 8},
      {"malformed_face.obj", "", "the faces do not all point the same way: neighbours disagree at 3 edges",
       4},
      {"two_inverted_faces.obj", "", "the surface is not closed: 8 open edges | the mesh is in 2 pieces", 4},
      {"multibody.stl", "",
       "the faces do not all point the same way: neighbours disagree at 12 edges | the mesh is in 2 pieces",
       32},
      {"large_block.STL", "", "", 12},
      {"counter.unitsmm.STL", "", "the mesh is in 6 pieces", 83750},
      {"inward_cube.x", "", "", 12},
  };
  CHECK(files.size() == 22);
  for (const Hard& hard : files) {
    const auto file = test_data("objects/hard/" + hard.file);
    if (file.empty()) return;
    INFO("file: ", hard.file);
    if (!hard.refusal.empty()) {
      CHECK_THROWS_SAYING(read_object(file), InputError, hard.refusal);
      CHECK_THROWS_SAYING(read_object(file), InputError, "object file '" + file.string() + "': ");
      continue;
    }
    const RawObject object = read_object(file);
    CHECK(joined(object.warnings) == hard.warnings);
    CHECK(object.mesh.triangles.size() == hard.triangles);
  }
}

TEST_CASE("Hard files: the cube that its file mirrors points outwards after loading") {
  const auto file = test_data("objects/hard/inward_cube.x");
  if (file.empty()) return;
  CHECK_NEAR(volume_properties(read_object(file).mesh).volume, 8.0, 1e-5);
}

TEST_SUITE_END();
