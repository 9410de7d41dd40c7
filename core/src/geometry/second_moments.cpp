#include "geometry/second_moments.h"

namespace preshape {

namespace {

/// Zeroth, first and second moments of a body that is put together from simplices with one corner at 0.
struct Moments {
  double mass = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  /// A simplex of `corners` corners, of which a, b, c are given and any other is the origin.
  void add(double part, int corners, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
           const Eigen::Vector3d& c) {
    const Eigen::Vector3d sum = a + b + c;
    mass += part;
    first += part / corners * sum;
    second += part / (corners * (corners + 1)) *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  Eigen::Matrix3d about_centroid() const { return second - first * first.transpose() / mass; }
};

template <class Part>
Moments moments(const TriangleMesh& mesh, int corners, Part part) {
  const Eigen::Vector3d middle = bounding_box(mesh).centre();
  Moments moments;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0) - middle, b = mesh.corner(t, 1) - middle,
                          c = mesh.corner(t, 2) - middle;
    moments.add(part(a, b, c), corners, a, b, c);
  }
  return moments;
}

}  // namespace

Eigen::Matrix3d second_moments(const TriangleMesh& mesh) {
  using V = const Eigen::Vector3d&;
  if (mesh_topology(mesh).bounds_volume()) {
    const Moments volume = moments(mesh, 4, [](V a, V b, V c) { return a.dot(b.cross(c)) / 6.0; });
    const Eigen::Matrix3d about = volume.about_centroid() * (volume.mass < 0 ? -1.0 : 1.0);
    // Pieces that cancel each other make a body of no sense; the surface then still has its moments.
    if (about.allFinite() && about.diagonal().minCoeff() > 0.0) return about;
  }
  return moments(mesh, 3, [](V a, V b, V c) { return (b - a).cross(c - a).norm() / 2.0; }).about_centroid();
}

}  // namespace preshape
