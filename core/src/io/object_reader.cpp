#include "preshape/io/object_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <assimp/Importer.hpp>

#include "io/file_guard.h"
#include "io/scene_mesh.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{2} << 30;

const std::array<std::string, 8> kEndings = {"dae", "glb", "gltf", "obj", "off", "ply", "stl", "x"};

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

void check_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError("there is no such file; check the path");
  if (error) throw InputError(fmt::format("it cannot be reached: {}; check the path", error.message()));
  if (status.type() == fs::file_type::directory)
    throw InputError("it is a directory; name the mesh file in it");
  if (status.type() != fs::file_type::regular) throw InputError("it is not a regular file; name a mesh file");
  if (!std::binary_search(kEndings.begin(), kEndings.end(), ending_of(file))) {
    throw InputError(fmt::format("the ending '{}' is of no known mesh format; known: {}",
                                 file.extension().string(), fmt::join(kEndings, ", ")));
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size == 0) throw InputError("it is empty; give a mesh with faces");
  if (!error && size > kMostBytes) {
    throw InputError(fmt::format("it has {} bytes, more than {}; reduce the mesh", size, kMostBytes));
  }
}

std::string content_of(const fs::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(fmt::format("it cannot be read: {}; check its permissions", std::strerror(errno)));
  std::string content(fs::file_size(file), '\0');
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

const aiScene& load(Assimp::Importer& importer, const fs::path& file, const std::string& ending) {
  // The object keeps the axes in which its numbers are written.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (scene) return *scene;
  std::string reason = importer.GetErrorString();
  while (!reason.empty() && (reason.back() == '.' || std::isspace(static_cast<unsigned char>(reason.back()))))
    reason.pop_back();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw InputError(
      fmt::format("it cannot be read as {}; mend or export it again (assimp: {})", ending, reason));
}

/// Distinct directions of the triangles. Facets of one plane differ by rounding of the corners only.
std::int64_t count_facet_normals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) normals.push_back(mesh.area_vector(t).normalized());
  return count_distinct(normals, 1e-4);
}

RawObject read_checked(const fs::path& file, double weld_tolerance) {
  if (!(weld_tolerance >= 0.0 && weld_tolerance <= 0.01)) {
    throw InputError(
        fmt::format("the weld tolerance must be in 0 .. 0.01 of the diagonal, got {}", weld_tolerance));
  }
  check_file(file);
  const std::string ending = ending_of(file);
  guard_file(ending, content_of(file));
  Assimp::Importer importer;
  const aiScene& scene = load(importer, file, ending);
  RawObject object;
  object.name = file.stem().string();
  object.file = file.string();
  object.unit_known = ending == "gltf" || ending == "glb" || ending == "dae";
  object.file_faces = count_polygons(scene);
  object.file_normals = count_vertex_normals(scene);
  if (object.file_faces == 0)
    throw InputError("it has no faces; give a mesh with faces, not points or lines");
  importer.ApplyPostProcessing(aiProcess_Triangulate);
  object.mesh = scene_mesh(scene);
  MeshRepair repair = repair_mesh(object.mesh, weld_tolerance);
  object.topology = repair.topology;
  object.warnings = std::move(repair.warnings);
  if (object.file_normals == 0) object.file_normals = count_facet_normals(object.mesh);
  return object;
}

}  // namespace

std::span<const std::string> object_file_endings() {
  return kEndings;
}

RawObject read_object(const fs::path& file, double weld_tolerance) {
  try {
    return read_checked(file, weld_tolerance);
  } catch (const InputError& error) {
    throw InputError(fmt::format("object file '{}': {}", file.string(), error.what()));
  } catch (const std::exception& error) {  // memory that a damaged header asks for
    throw InputError(fmt::format("object file '{}': it cannot be read; mend or export it again ({})",
                                 file.string(), error.what()));
  }
}

}  // namespace preshape
