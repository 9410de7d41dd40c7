#include "mesh_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <Eigen/Geometry>
#include <assimp/Importer.hpp>

namespace preshape::urdf_hand {

namespace {

constexpr double kThinnest = 1e-4;  // [m] half of a flat mesh's thickness

/// A capsule along one of the axes: as thin as the points let it be, then as short.
Bounds capsule_along(int axis, const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
  Bounds bounds;
  bounds.solid.kind = Solid::Kind::kCapsule;
  bounds.solid.radius = kThinnest;
  for (const auto& p : points)
    bounds.solid.radius = std::max(bounds.solid.radius, along.cross(p - centre).norm());
  for (const auto& p : points) {
    const double aside = along.cross(p - centre).norm();
    const double cap = std::sqrt(std::max(0.0, bounds.solid.radius * bounds.solid.radius - aside * aside));
    bounds.solid.half_length = std::max(bounds.solid.half_length, std::abs(along.dot(p - centre)) - cap);
  }
  bounds.X = {Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix(), centre};
  return bounds;
}

double volume(const Solid& solid) {
  if (solid.kind == Solid::Kind::kBox) return 8.0 * solid.half_extents.prod();
  const double r = solid.radius;
  return std::numbers::pi * r * r * (2.0 * solid.half_length + 4.0 / 3.0 * r);
}

}  // namespace

std::optional<std::vector<Eigen::Vector3d>> read_vertices(const std::filesystem::path& file) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_MATERIALS | aiComponent_TEXTURES | aiComponent_NORMALS);
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFile(file.string(), aiProcess_RemoveComponent | aiProcess_PreTransformVertices);
  } catch (const std::exception&) {
    return std::nullopt;  // some readers throw on a damaged file
  }
  if (!scene) return std::nullopt;
  std::vector<Eigen::Vector3d> points;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      points.emplace_back(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
  }
  const bool finite = std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
  if (points.empty() || !finite) return std::nullopt;
  return points;
}

Bounds bounds_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d lower = points.front(), upper = points.front();
  for (const auto& p : points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  const Eigen::Vector3d centre = 0.5 * (lower + upper);
  Bounds best;
  best.solid.kind = Solid::Kind::kBox;
  best.solid.half_extents = (0.5 * (upper - lower)).cwiseMax(kThinnest);
  best.X.p = centre;
  for (int axis = 0; axis < 3; ++axis) {
    Bounds capsule = capsule_along(axis, centre, points);
    if (volume(capsule.solid) < volume(best.solid)) best = std::move(capsule);
  }
  return best;
}

}  // namespace preshape::urdf_hand
