// What a nearest hit costs: each collision backend, and Embree's own triangles in single precision where
// Embree is installed, on spheres, in one process, in rounds, so that a machine's moods fall on all. Prints
// medians and ratios.
#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include <fmt/format.h>
#ifdef PRESHAPE_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

#include "core/geometry/shapes.h"
#include "preshape/base/error.h"
#include "preshape/geometry/collision.h"
#include "preshape/plugin/fingerprint.h"
#include "preshape/plugin/registry.h"
#include "preshape/version.h"

using namespace preshape;
using namespace preshape::test;

namespace {

constexpr int kRounds = 9;
constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kRays = 20000;

/// As a hand asks: groups of four parallel rays, from a random side, at steps of the approach.
std::vector<Ray> grasp_rays(Random& random) {
  std::vector<Ray> rays;
  while (rays.size() < kRays) {
    const Eigen::Matrix3d R = random_rotation(random);
    for (int step = 0; step < 20; ++step) {
      for (int finger = 0; finger < 4; ++finger)
        rays.push_back({R * Eigen::Vector3d(-3, 0.3 * finger - 0.45, 0.09 * step - 0.9), R.col(0)});
    }
  }
  return rays;
}

/// Something that casts all rays and says how many met.
struct Caster {
  std::string name;
  std::function<std::size_t(const std::vector<Ray>&)> cast;
  std::vector<double> nanoseconds{};

  double median() const {
    std::vector<double> sorted = nanoseconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

Caster backend_caster(const Registry& registry, const std::string& name, const TriangleMesh& mesh) {
  std::shared_ptr<const CollisionScene> scene = build_scene(registry.create<CollisionBackend>(name), mesh);
  return {name, [scene](const std::vector<Ray>& rays) {
            std::vector<RayHit> hits(rays.size());
            scene->cast(rays, hits);
            return static_cast<std::size_t>(
                std::count_if(hits.begin(), hits.end(), [](const RayHit& h) { return h.met(); }));
          }};
}

#ifdef PRESHAPE_HAS_EMBREE
std::shared_ptr<RTCSceneTy> plain_scene(RTCDevice device, const TriangleMesh& mesh) {
  std::shared_ptr<RTCSceneTy> scene(rtcNewScene(device), rtcReleaseScene);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  for (const auto& v : mesh.vertices)
    corner = std::copy_n(Eigen::Vector3f(v.cast<float>()).data(), 3, corner);
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
  for (const auto& t : mesh.triangles) index = std::copy_n(t.data(), 3, index);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  return scene;
}

bool plain_cast(RTCScene scene, const Ray& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  const Eigen::Vector3f origin = ray.origin.cast<float>(), along = ray.direction.cast<float>();
  query.ray.org_x = origin.x(), query.ray.org_y = origin.y(), query.ray.org_z = origin.z();
  query.ray.dir_x = along.x(), query.ray.dir_y = along.y(), query.ray.dir_z = along.z();
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &query);
  return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

Caster plain_caster(const TriangleMesh& mesh) {
  std::shared_ptr<RTCDeviceTy> device(rtcNewDevice("threads=1"), rtcReleaseDevice);
  const auto scene = plain_scene(device.get(), mesh);
  return {"rtcIntersect1", [device, scene](const std::vector<Ray>& rays) {
            return static_cast<std::size_t>(std::count_if(
                rays.begin(), rays.end(), [&](const Ray& ray) { return plain_cast(scene.get(), ray); }));
          }};
}
#endif

void compare(const Registry& registry, int subdivisions) {
  Random random(kSeed);
  const TriangleMesh mesh = sphere_mesh(subdivisions);
  const auto rays = grasp_rays(random);
  std::vector<Caster> casters;
  for (const auto& name : registry.names("collision")) {
    if (name != "brute" || subdivisions <= 2) casters.push_back(backend_caster(registry, name, mesh));
  }
#ifdef PRESHAPE_HAS_EMBREE
  casters.push_back(plain_caster(mesh));
#endif
  for (int round = 0; round <= kRounds; ++round) {
    for (Caster& caster : casters) {
      const auto begin = std::chrono::steady_clock::now();
      if (caster.cast(rays) == 0) throw InputError(caster.name + " meets nothing");
      const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - begin;
      if (round > 0)
        caster.nanoseconds.push_back(passed.count() / double(rays.size()));  // at first caches are cold
    }
  }
  for (const Caster& caster : casters) {
    fmt::print("{:>7} triangles   {:<14} {:8.0f} ns a ray   {:.2f} of {}\n", mesh.triangles.size(),
               caster.name, caster.median(), caster.median() / casters.back().median(), casters.back().name);
  }
}

}  // namespace

int main() {
  fmt::print("nearest hits in the grasp pattern: preshape {}, {}, {} build, seed {}, {} rounds of {} rays\n",
             PRESHAPE_VERSION_STRING, fingerprint_text(host_fingerprint()), PRESHAPE_BUILD_TYPE, kSeed,
             kRounds, kRays);
  try {
    const Registry registry({{PRESHAPE_BINARY_DIR "/lib/preshape/plugins", "build"}}, {});
    for (const int subdivisions : {2, 4, 6}) compare(registry, subdivisions);
  } catch (const Error& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 1;
  }
}
