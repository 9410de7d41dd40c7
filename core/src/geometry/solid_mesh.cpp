#include "preshape/geometry/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preshape {

namespace {

/// A surface of revolution about z: rings of `segments` vertices between two poles, given as (radius, height) from the
/// lower pole to the upper one.
TriangleMesh revolved(const std::vector<std::pair<double, double>>& profile, int segments) {
  TriangleMesh mesh;
  const auto ring = [&](std::size_t i, int k) {
    return static_cast<std::int32_t>(1 + (static_cast<int>(i) - 1) * segments + (k % segments));
  };
  mesh.vertices.emplace_back(0, 0, profile.front().second);
  for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
    for (int k = 0; k < segments; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / segments;
      mesh.vertices.emplace_back(profile[i].first * std::cos(angle), profile[i].first * std::sin(angle), profile[i].second);
    }
  }
  mesh.vertices.emplace_back(0, 0, profile.back().second);
  const auto top = static_cast<std::int32_t>(mesh.vertices.size() - 1);
  const std::size_t last = profile.size() - 2;
  for (int k = 0; k < segments; ++k) {
    mesh.triangles.emplace_back(0, ring(1, k + 1), ring(1, k));
    for (std::size_t i = 1; i < last; ++i) {
      mesh.triangles.emplace_back(ring(i, k), ring(i, k + 1), ring(i + 1, k));
      mesh.triangles.emplace_back(ring(i + 1, k), ring(i, k + 1), ring(i + 1, k + 1));
    }
    mesh.triangles.emplace_back(ring(last, k), ring(last, k + 1), top);
  }
  return mesh;
}

TriangleMesh capsule_mesh(double radius, double half_length, int segments) {
  const int quarter = std::max(1, segments / 4);
  std::vector<std::pair<double, double>> profile;
  for (int i = 0; i <= quarter; ++i) {
    const double angle = -0.5 * std::numbers::pi * (1.0 - static_cast<double>(i) / quarter);
    profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle) - half_length);
  }
  for (int i = half_length > 0.0 ? 0 : 1; i <= quarter; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / quarter;
    profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle) + half_length);
  }
  return revolved(profile, segments);
}

TriangleMesh box_mesh(const Eigen::Vector3d& half_extents) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(half_extents.cwiseProduct(Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace

TriangleMesh solid_mesh(const Solid& solid, int segments) {
  const int round = std::max(3, segments);
  switch (solid.kind) {
    case Solid::Kind::kSphere: return capsule_mesh(solid.radius, 0.0, round);
    case Solid::Kind::kCapsule: return capsule_mesh(solid.radius, solid.half_length, round);
    case Solid::Kind::kBox: return box_mesh(solid.half_extents);
  }
  return {};
}

TriangleMesh arrow_mesh(double length, double radius, int heads, int segments) {
  const double head = std::min(6.0 * radius, length / heads), wide = 2.4 * radius;
  std::vector<std::pair<double, double>> profile = {{0.0, 0.0}};
  double at = length - heads * head;
  if (at > 0.0) profile.insert(profile.end(), {{radius, 0.0}, {radius, at}});
  for (int i = 0; i < heads; ++i, at += head) {
    profile.emplace_back(wide, at);
    profile.emplace_back(i + 1 < heads ? radius : 0.0, i + 1 < heads ? at + head : length);
  }
  return revolved(profile, std::max(3, segments));
}

TriangleMesh transformed(TriangleMesh mesh_B, const Pose& X_AB) {
  for (auto& vertex : mesh_B.vertices) vertex = X_AB * vertex;
  return mesh_B;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& triangle : other.triangles) mesh.triangles.emplace_back(triangle.array() + first);
}

}  // namespace preshape
