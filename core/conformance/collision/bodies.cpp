#include "bodies.h"

#include <cmath>
#include <map>
#include <numbers>

#include "preshape/base/assert.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;

TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vector& v : mesh.vertices) v.normalize();
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

TriangleMesh subdivided(const TriangleMesh& coarse) {
  TriangleMesh fine{coarse.vertices, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.vertices.size()));
    if (is_new) {
      const Vector sum =
          fine.vertices[static_cast<std::size_t>(a)] + fine.vertices[static_cast<std::size_t>(b)];
      fine.vertices.push_back(sum.normalized());
    }
    return place->second;
  };
  for (const Triangle& t : coarse.triangles) {
    const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
    for (const Triangle& part :
         {Triangle(t[0], ab, ca), Triangle(t[1], bc, ab), Triangle(t[2], ca, bc), Triangle(ab, bc, ca)}) {
      fine.triangles.push_back(part);
    }
  }
  return fine;
}

Vector in_cube(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// Triangles without a common corner, of that size; as wide as `width` of their length.
TriangleMesh loose(int count, double size, double width) {
  Random random(7);
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vector a = in_cube(random), along = size * random_unit(random), across = size * random_unit(random);
    mesh.vertices.insert(mesh.vertices.end(), {a, a + along, a + random.uniform() * along + width * across});
    mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

TriangleMesh doubled(TriangleMesh mesh) {
  const auto copy = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), copy.begin(), copy.end());
  return mesh;
}

/// A sphere with points and lines for triangles, on it and beside it, between its own.
TriangleMesh with_flat_triangles() {
  TriangleMesh mesh = icosphere(1);
  const int n = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{1.3, 0.1, 0.2}, {1.3, 0.5, 0.2}, {1.3, 0.3, 0.2}});
  for (std::size_t t = 0; t < 10; ++t) {
    const Triangle own = mesh.triangles[8 * t];
    const Triangle flat = t % 3 == 0   ? Triangle(own[0], own[0], own[1])
                          : t % 3 == 1 ? Triangle(own[2], own[2], own[2])
                                       : Triangle(n, n + 1, n + 2);
    mesh.triangles.insert(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(8 * t + 3), flat);
  }
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vector& v : mesh.vertices) v *= factor;
  return mesh;
}

std::vector<Body> make_bodies() {
  const Vector none = Vector::Zero(), far(1e4, -1e4, 1e4);
  TriangleMesh open = icosphere(2);
  open.triangles.resize(200);
  return {{"sphere", icosphere(2), true, {0.1, 0.05, -0.02}},
          {"box", box_mesh({-1, -0.5, -0.25}, {1, 0.5, 0.25}), true, {0.3, 0.1, 0.05}},
          {"torus", torus(18, 9), true, {1.02, 0.03, 0.01}},
          {"slivers", loose(60, 1.0, 1e-6), false, none},
          {"soup", loose(100, 0.5, 1.0), false, none},
          {"doubled triangles", doubled(icosphere(1)), true, {0.1, 0.05, -0.02}},
          {"flat triangles", with_flat_triangles(), true, {0.1, 0.05, -0.02}},
          {"open sphere", open, false, none},
          {"touching boxes",
           joined(box_mesh({-1, -1, -1}, {0, 1, 1}), box_mesh({0, -1, -1}, {1, 1, 1})),
           true,
           {-0.4, 0.1, 0.2}},
          {"far sphere", moved(icosphere(1), {Eigen::Matrix3d::Identity(), far}), true, far},
          {"tiny sphere", scaled(icosphere(1), 1e-6), true, none},
          {"huge sphere", scaled(icosphere(1), 1e6), true, none},
          {"triangle", loose(1, 1.0, 1.0), false, none}};
}

}  // namespace

Vector Body::centre() const {
  return bounding_box(mesh).centre();
}
double Body::extent() const {
  return bounding_box(mesh).extents().norm();
}

const std::vector<Body>& bodies() {
  static const std::vector<Body> kBodies = make_bodies();
  return kBodies;
}

const Body& body(std::string_view name) {
  for (const Body& b : bodies()) {
    if (b.name == name) return b;
  }
  PRESHAPE_DEMAND(!"a body's name");
  return bodies().front();
}

TriangleMesh icosphere(int subdivisions) {
  TriangleMesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(mesh);
  return mesh;
}

TriangleMesh box_mesh(const Vector& lower, const Vector& upper) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                               i & 4 ? upper.z() : lower.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh torus(int around, int across) {
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * k / across;
      const double r = 1 + 0.4 * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
      const int i2 = (i + 1) % around, k2 = (k + 1) % across;
      mesh.triangles.emplace_back(i * across + k, i2 * across + k, i2 * across + k2);
      mesh.triangles.emplace_back(i * across + k, i2 * across + k2, i * across + k2);
    }
  }
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Pose& X) {
  for (Vector& v : mesh.vertices) v = X * v;
  return mesh;
}

TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto n = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles) mesh.triangles.push_back(t + Triangle::Constant(n));
  return mesh;
}

Vector random_unit(Random& random) {
  const Vector v(random.normal(), random.normal(), random.normal());
  return v.normalized();
}

Eigen::Matrix3d random_rotation(Random& random) {
  return Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
      .normalized()
      .toRotationMatrix();
}

RayHit cast_one(const CollisionScene& scene, const Ray& ray) {
  RayHit hit{-1.0, -7};  // neither a hit nor a miss, so that an answer that is not written shows
  scene.cast({&ray, 1}, {&hit, 1});
  return hit;
}

double distance_one(const CollisionScene& scene, const PosedSolid& solid) {
  double distance = -1.0;
  scene.distance({&solid, 1}, {&distance, 1});
  return distance;
}

double distance_one(const CollisionBackend& backend, const PosedSolid& a, const PosedSolid& b) {
  double distance = -1.0;
  backend.distance({&a, 1}, {&b, 1}, {&distance, 1});
  return distance;
}

}  // namespace preshape::conformance
