#pragma once

#include <array>
#include <cmath>
#include <map>

#include "preshape/base/random.h"
#include "preshape/geometry/triangle_mesh.h"
#include "support/sample.h"

namespace preshape::test {

/// Closed box of 12 triangles, faces outward.
inline TriangleMesh box_mesh(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                               i & 4 ? upper.z() : lower.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Regular tetrahedron with corners on a cube of side 2.
inline TriangleMesh tetrahedron_mesh() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

/// Icosahedron with each triangle split in four `level` times, corners on the unit sphere.
inline TriangleMesh sphere_mesh(int level) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        mesh.vertices.push_back(
            (mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)]) / 2);
      }
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      for (const Triangle& part :
           {Triangle(t[0], ab, ca), Triangle(t[1], bc, ab), Triangle(t[2], ca, bc), Triangle(ab, bc, ca)}) {
        finer.push_back(part);
      }
    }
    mesh.triangles = finer;
    for (auto& p : mesh.vertices) p.normalize();
  }
  for (auto& p : mesh.vertices) p.normalize();
  return mesh;
}

/// Unconnected triangles in the cube [-1, 1]^3 with sides of about `size`.
inline TriangleMesh soup_mesh(Random& random, int count, double size) {
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Eigen::Vector3d middle = random_vector(random);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(middle + size * random_vector(random));
    mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  for (auto& v : mesh.vertices) v = R * v + p;
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& factors) {
  for (auto& v : mesh.vertices) v = v.cwiseProduct(factors);
  return mesh;
}

/// Both meshes, the second's vertices after the first's.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::int32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back(t.array() + offset);
  return a;
}

/// Every triangle with vertices of its own, as STL has them.
inline TriangleMesh unwelded(const TriangleMesh& mesh) {
  TriangleMesh loose;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::int32_t>(loose.vertices.size());
    for (int k = 0; k < 3; ++k) loose.vertices.push_back(mesh.corner(t, k));
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  return loose;
}

inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace preshape::test
