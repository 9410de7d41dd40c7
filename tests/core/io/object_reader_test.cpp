#include <fstream>

#include "core/geometry/shapes.h"
#include "preshape/base/error.h"
#include "preshape/io/object_reader.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

class Files {
 public:
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const auto file = directory_ / name;
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  std::filesystem::path operator/(const std::string& name) const { return directory_ / name; }

 private:
  TemporaryDirectory directory_;
};

const std::string kSquareObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

std::string gltf_of(const std::string& nodes) {
  // One triangle in a data buffer: float 0 0 0, 1 0 0, 0 1 0 and the indices 0 1 2.
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","max":[1,1,0],"min":[0,0,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

}  // namespace

TEST_CASE("Reader: a quad is one face of the file and two triangles, without normals it has one") {
  const Files files;
  const RawObject object = read_object(files.write("square.obj", kSquareObj));
  CHECK(object.name == "square");
  CHECK(object.file == (files / "square.obj").string());
  CHECK(object.file_faces == 1);
  CHECK(object.file_normals == 1);
  CHECK(object.mesh.triangles.size() == 2);
  CHECK(object.mesh.vertices.size() == 4);
  CHECK_FALSE(object.unit_known);
}

TEST_CASE("Reader: a concave polygon is cut up inside its outline") {
  const Files files;
  // An arrow head: the fan from corner 1 would leave the outline.
  const RawObject object =
      read_object(files.write("arrow.obj", "v 1 0.2 0\nv 2 1 0\nv 1 -1 0\nv 0 1 0\nf 2 1 4 3\n"));
  double area = 0;
  for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t)
    area += object.mesh.area_vector(t).norm() / 2;
  CHECK_NEAR(area, 1.2, 1e-6);  // shoelace: two triangles of 0.6
}

TEST_CASE("Reader: normals are counted as the file has them, exactly and each once") {
  const Files files;
  const std::string normals = "vn 0 0 1\nvn 0 0.001 1\nvn -0.0 0 1\nvn 0 0 1\n";
  const std::string object =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + normals + "f 1//1 2//2 3//3\nf 1//1 3//4 4//1\n";
  CHECK(read_object(files.write("normals.obj", object)).file_normals == 2);
}

TEST_CASE("Reader: normals of zero length are none, so facets are counted") {
  const Files files;
  std::string stl = "solid s\n";
  const TriangleMesh box = box_mesh({0, 0, 0}, {1, 2, 3});
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      stl +=
          fmt::format("vertex {} {} {}\n", box.corner(t, k).x(), box.corner(t, k).y(), box.corner(t, k).z());
    }
    stl += "endloop\nendfacet\n";
  }
  const RawObject object = read_object(files.write("box.stl", stl + "endsolid s\n"));
  CHECK(object.file_normals == 6);
  CHECK(object.file_faces == 12);
  CHECK(object.topology.watertight());
}

TEST_CASE("Reader: placements of the scene are applied, every use of a mesh counts") {
  const Files files;
  const std::string nodes =
      R"({"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[5,0,0],"scale":[2,2,2]})";
  const RawObject object = read_object(files.write("two.gltf", gltf_of(nodes)));
  CHECK(object.unit_known);
  CHECK(object.file_faces == 2);
  REQUIRE(object.mesh.triangles.size() == 2);
  CHECK_NEAR(bounding_box(object.mesh).upper, Eigen::Vector3d(7, 2, 0), 0);
}

TEST_CASE("Reader: a placement within a placement is carried out first") {
  const Files files;
  const std::string nodes = R"({"children":[1],"scale":[2,2,2]},{"mesh":0,"translation":[5,0,0]})";
  const RawObject object = read_object(files.write("nested.gltf", gltf_of(nodes)));
  CHECK_NEAR(bounding_box(object.mesh).upper, Eigen::Vector3d(12, 2, 0), 0);
}

TEST_CASE("Reader: a mirrored placement does not turn the faces inwards") {
  const Files files;
  const RawObject plain = read_object(files.write("plain.gltf", gltf_of(R"({"mesh":0})")));
  const RawObject mirrored =
      read_object(files.write("mirrored.gltf", gltf_of(R"({"mesh":0,"scale":[-1,1,1]})")));
  CHECK(plain.mesh.area_vector(0).z() == 1.0);
  CHECK(mirrored.mesh.area_vector(0).z() == 1.0);
  CHECK(bounding_box(mirrored.mesh).lower.x() == -1.0);
}

TEST_CASE("Reader: COLLADA's unit is honoured and its numbers keep their axes whatever direction is up") {
  const Files files;
  const auto dae = [](const std::string& up) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>)" +
           up + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 100 0 0 0 300 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
</vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  };
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    const RawObject object = read_object(files.write("t.dae", dae(up)));
    CHECK(object.unit_known);
    CHECK_NEAR(bounding_box(object.mesh).extents(), Eigen::Vector3d(1, 3, 0), 1e-6);
  }
}

TEST_CASE(
    "Reader: materials and textures that are not there do not matter, nor does the case of the ending") {
  const Files files;
  const RawObject object =
      read_object(files.write("a.OBJ", "mtllib nowhere.mtl\nusemtl gold\n" + kSquareObj));
  CHECK(object.mesh.triangles.size() == 2);
}

TEST_CASE("Reader: what cannot be a mesh file is refused with its name and the mend") {
  const Files files;
  const auto refused = [](const std::filesystem::path& file, const std::string& saying) {
    CHECK_THROWS_SAYING(read_object(file), InputError, saying);
    CHECK_THROWS_SAYING(read_object(file), InputError, file.string());
  };
  refused(files / "none.obj", "there is no such file; check the path");
  refused(files / "", "it is a directory; name the mesh file in it");
  refused("/dev/null", "it is not a regular file");
  refused(files.write("mug.step", "x"),
          "the ending '.step' is of no known mesh format; known: dae, glb, gltf, obj, off, ply, stl, x");
  refused(files.write("mug", "x"), "the ending '' is of no known mesh format");
  refused(files.write("a.obj", ""), "it is empty");
  refused(files.write("b.obj", std::string("\xff\xfe#\0 \0", 6)), "it is UTF-16 text; save it as UTF-8");
  refused(files.write("c.obj", std::string("v 0\0 1", 7)), "it is not text, as obj files are");
  refused(files.write("d.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n# nothing but vertices\n"), "it has no faces");
  refused(files.write("e.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "none of its triangles has an area");
  refused(files.write("f.ply", "ply\nformat ascii 1.0\ncomment then nothing\nend_header\n"),
          "it cannot be read as ply; mend or export it again (assimp: ");
  refused(
      files.write("g.stl", "this is no stl file, however long it may go on in this manner; it has no facet"),
      "it cannot be read as stl");
}

TEST_CASE("Reader: files that the reading library would not survive are refused before it sees them") {
  const Files files;
  const auto refused = [&](const std::string& name, const std::string& content, const std::string& saying) {
    INFO("file: ", name);
    CHECK_THROWS_SAYING(read_object(files.write(name, content)), InputError, saying);
  };
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex ";
  refused("a.ply", ply + "3\n", "its header has no end");
  refused("b.ply", ply + "4000000000\nproperty float x\nend_header\n0\n",
          "it announces 4000000000 elements but has only");
  refused("a.off", "OFF\n4000000000 1 0\n0 0 0\n", "it announces 4000000000 vertices but has only");
  refused("b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
          "its face 1 does not name 3 of the 3 vertices");
  refused("c.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "its face 2 is missing");
  refused("d.off", "OFF\nmany\n", "its header does not count vertices and faces");
  refused("a.gltf", "{\"asset\":", "its JSON is damaged");
  refused("b.gltf", "{\"extras\":" + times(1000000, "[") + times(1000000, "]") + "}",
          "it is nested more than 256 deep");
  refused("c.gltf", gltf_of(R"({"mesh":0,"children":[0]})"), "a part of its scene places itself");
  std::string chain;
  for (int i = 1; i < 1000; ++i) chain += fmt::format(R"({{"children":[{}]}},)", i);
  refused("d.gltf", gltf_of(chain + R"({"mesh":0})"), "its scene is nested more than 256 deep");
  std::string doubling;
  for (int i = 1; i < 30; ++i) doubling += fmt::format(R"({{"children":[{},{}]}},)", i, i);
  refused("e.gltf", gltf_of(doubling + R"({"mesh":0})"), "its scene has more than 1000000 placements");
  refused("a.glb", "glTF", "it is no binary glTF");
  refused("b.glb", std::string("glTF\2\0\0\0\x40\0\0\0\x30\0\0\0JSON{}", 22), "it is cut off");
  refused("a.dae", "<?xml version=\"1.0\"?><COLLADA>" + times(1000, "<node>"),
          "it is nested more than 256 deep");
  refused("b.dae",
          "<?xml version=\"1.0\"?><COLLADA><node id=\"a\"><instance_node url=\"#a\"/></node></COLLADA>",
          "a part of its scene places itself");
  refused("c.dae", "<?xml version=\"1.0\"?><COLLADA><p>0 1 x 2</p></COLLADA>",
          "something else than whole numbers");
  refused("a.x", "xof 0303bin 0032", "it is a binary or packed x file; export it as text");
  refused("b.x", "xof 0303txt 0032\n" + times(1000, "Frame A {\n"), "it is nested more than 256 deep");
  refused("c.x", "xof 0303txt 0032\nMesh a { 4000000000; 0;0;0;, 1; 3;0,1,2;; }\n",
          "it announces 4000000000 entries");
}

TEST_CASE("Reader: a file cut off anywhere, or with any byte changed, is read or refused, and nothing else") {
  const Files files;
  Random random(16);
  const std::vector<std::pair<std::string, std::string>> whole = {
      {"a.obj", kSquareObj + "vn 0 0 1\nf 1//1 2//1 3//1\n"},
      {"a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
       "0\nendloop\nendfacet\nendsolid s\n"},
      {"a.gltf", gltf_of(R"({"mesh":0})")},
  };
  int read = 0, refused = 0;
  for (const auto& [name, content] : whole) {
    for (int i = 0; i < 60; ++i) {
      std::string damaged = content;
      if (i % 2)
        damaged.resize(random.below(damaged.size()));
      else
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      try {
        read_object(files.write(name, damaged));
        ++read;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  CHECK(read > 20);
  CHECK(refused > 100);
}

TEST_CASE("Reader: a file that may not be read is refused as such") {
  const Files files;
  const auto file = files.write("secret.obj", kSquareObj);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (std::ifstream(file)) return;  // run by one who may read everything
  CHECK_THROWS_SAYING(read_object(file), InputError,
                      "it cannot be read: Permission denied; check its permissions");
}

TEST_CASE("Reader: too large a file is refused before it is read") {
  const Files files;
  const auto file = files.write("huge.obj", "v 0 0 0\n");
  std::filesystem::resize_file(file, std::uintmax_t{3} << 30);  // sparse
  CHECK_THROWS_SAYING(read_object(file), InputError,
                      "it has 3221225472 bytes, more than 2147483648; reduce the mesh");
}

TEST_CASE("Reader: a polygon with thousands of corners is refused, as cutting it up would take for ever") {
  const Files files;
  std::string vertices, face = "f";
  for (int i = 0; i < 5000; ++i) {
    vertices += fmt::format("v {} {} 0\n", std::cos(i * 2 * M_PI / 5000), std::sin(i * 2 * M_PI / 5000));
    face += fmt::format(" {}", i + 1);
  }
  CHECK_THROWS_SAYING(read_object(files.write("disc.obj", vertices + face + "\n")), InputError,
                      "its face 1 has 5000 corners, more than 4096; split the face");
}

TEST_CASE("Reader: the weld tolerance must be a small share of the diagonal") {
  const Files files;
  const auto file = files.write("square.obj", kSquareObj);
  for (const double wrong : {-1e-9, 0.1, double(NAN)}) {
    CHECK_THROWS_SAYING(read_object(file, wrong), InputError,
                        "the weld tolerance must be in 0 .. 0.01 of the diagonal");
  }
}

TEST_CASE("Reader: the same shape in any format has the same hash once it is placed") {
  const Files files;
  const auto obj = files.write("a.obj", kSquareObj);
  const auto off = files.write("b.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const auto ply = files.write(
      "c.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  const std::string hash = place_object(read_object(obj), {}, 0.04).hash;
  CHECK(place_object(read_object(off), {}, 0.04).hash == hash);
  CHECK(place_object(read_object(ply), {}, 0.04).hash == hash);
}

TEST_SUITE_END();
