#include "io/scene_mesh.h"

#include <cmath>

#include <assimp/scene.h>
#include <fmt/format.h>
#include <Eigen/LU>

#include "preshape/base/error.h"
#include "preshape/geometry/mesh_repair.h"
#include "preshape/geometry/weld.h"

namespace preshape {

namespace {

constexpr unsigned kMostCorners = 4096;  // cutting up a polygon costs their square

/// One use of a mesh.
struct Placed {
  const aiMesh* mesh;
  Eigen::Matrix4d X_FM;
};

/// In double: assimp's own transforms would round every coordinate once more.
Eigen::Matrix4d matrix_of(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  for (unsigned row = 0; row < 4; ++row) {
    for (unsigned column = 0; column < 4; ++column) matrix(row, column) = static_cast<double>(m[row][column]);
  }
  return matrix;
}

std::vector<Placed> placed_meshes(const aiScene& scene) {
  std::vector<Placed> placed;
  std::vector<std::pair<const aiNode*, Eigen::Matrix4d>> open;
  if (scene.mRootNode) open.emplace_back(scene.mRootNode, Eigen::Matrix4d::Identity());
  while (!open.empty()) {
    const auto [node, X_FP] = open.back();
    open.pop_back();
    const Eigen::Matrix4d X_FN = X_FP * matrix_of(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) placed.push_back({scene.mMeshes[node->mMeshes[i]], X_FN});
    for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], X_FN);
  }
  return placed;
}

void check_polygon(const aiMesh& mesh, unsigned f) {
  const aiFace& face = mesh.mFaces[f];
  if (face.mNumIndices > kMostCorners) {
    throw InputError(fmt::format("its face {} has {} corners, more than {}; split the face", f + 1,
                                 face.mNumIndices, kMostCorners));
  }
  for (unsigned k = 0; k < face.mNumIndices; ++k) {
    if (face.mIndices[k] < mesh.mNumVertices) continue;
    throw InputError(fmt::format("its face {} names vertex {}, but there are only {}; mend the mesh", f + 1,
                                 std::uint64_t{face.mIndices[k]} + 1, mesh.mNumVertices));
  }
}

std::int64_t polygons_of(const aiMesh& mesh) {
  std::int64_t count = 0;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) count += mesh.mFaces[f].mNumIndices >= 3;
  return count;
}

/// Adds a placed mesh; one that is mirrored gets its corners in the other order, else it would point inwards.
void append(TriangleMesh& mesh, const Placed& placed) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  const Eigen::Matrix3d A = placed.X_FM.topLeftCorner<3, 3>();
  const Eigen::Vector3d p = placed.X_FM.topRightCorner<3, 1>();
  for (unsigned v = 0; v < placed.mesh->mNumVertices; ++v) {
    const aiVector3D& vertex = placed.mesh->mVertices[v];
    mesh.vertices.push_back(A * Eigen::Vector3f(vertex.x, vertex.y, vertex.z).cast<double>() + p);
  }
  const bool mirrored = A.determinant() < 0.0;
  for (unsigned f = 0; f < placed.mesh->mNumFaces; ++f) {
    const aiFace& face = placed.mesh->mFaces[f];
    if (face.mNumIndices != 3) continue;
    Triangle triangle;
    for (unsigned k = 0; k < 3; ++k) triangle[k] = first + static_cast<std::int32_t>(face.mIndices[k]);
    if (mirrored) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
  }
}

}  // namespace

std::int64_t count_polygons(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f) check_polygon(*scene.mMeshes[m], f);
  }
  std::int64_t polygons = 0, vertices = 0;
  for (const Placed& placed : placed_meshes(scene)) {
    polygons += polygons_of(*placed.mesh);
    vertices += placed.mesh->mNumVertices;
  }
  if (polygons > static_cast<std::int64_t>(kMostTriangles) ||
      vertices > 3 * static_cast<std::int64_t>(kMostTriangles)) {
    throw InputError(
        fmt::format("it has {} faces and {} vertices, more than {} faces or {} vertices; reduce the mesh",
                    polygons, vertices, kMostTriangles, 3 * kMostTriangles));
  }
  return polygons;
}

std::int64_t count_vertex_normals(const aiScene& scene) {
  std::vector<Eigen::Vector3d> normals;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    if (!mesh.HasNormals()) continue;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector3f normal(mesh.mNormals[v].x, mesh.mNormals[v].y, mesh.mNormals[v].z);
      // Files without normals worth the name fill them with zeros; the readers fill gaps with NaN.
      if (normal.allFinite() && !normal.isZero(0.0f)) normals.push_back(normal.cast<double>());
    }
  }
  return count_distinct(normals, 0.0);
}

TriangleMesh scene_mesh(const aiScene& scene) {
  TriangleMesh mesh;
  for (const Placed& placed : placed_meshes(scene)) append(mesh, placed);
  return mesh;
}

}  // namespace preshape
