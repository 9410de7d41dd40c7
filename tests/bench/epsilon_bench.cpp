// What epsilon costs: the lazy hull against all facets of Qhull, on the same grasps in one process, round by round, so that
// a machine's moods fall on both. Prints the ratio of the times, and how far the two are apart.
#include <algorithm>
#include <chrono>
#include <functional>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "preshape/contact/wrench_hull.h"
#include "preshape/version.h"
#include "support/cones.h"
#include "support/enumerated.h"
#include "support/qhull.h"

using namespace preshape;
using namespace preshape::test;

namespace {

constexpr int kGrasps = 24, kRounds = 9, kEdges = 8;
constexpr std::uint64_t kSeed = 1;

double seconds(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A thumb against forefingers beside one another on a unit sphere, as a hand grasps; no two alike.
std::vector<PointContact> opposed_grasp(Random& random, int count) {
  std::vector<PointContact> contacts;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = Eigen::Vector3d(i == 0 ? 1.0 : -1.0, i == 0 ? 0.0 : 0.5 * (i - 0.5 * count), 0.0) + 0.1 * random_vector(random);
    contacts.push_back({p.normalized(), -p.normalized()});
  }
  return contacts;
}

/// Evenly round the equator: many facets are equally near.
std::vector<PointContact> ring(int count) {
  std::vector<PointContact> contacts;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back({p, -p});
  }
  return contacts;
}

double by_qhull(const WrenchBasis& points) {
  const Hull hull = qhull(points);
  return hull.made ? std::max(0.0, *std::min_element(hull.offsets.begin(), hull.offsets.end())) : 0.0;
}

void compare(const char* sort, int count, ForceBound bound, int grasps, const std::function<std::vector<PointContact>(Random&)>& make) {
  Random random(kSeed);
  std::vector<GraspWrenchSpace> spaces;
  std::vector<WrenchBasis> points;
  for (int i = 0; i < grasps; ++i) {
    spaces.push_back(wrench_space(make(random), kEdges, bound));
    points.push_back(enumerated(spaces.back()));
  }
  std::vector<double> ratios, ours, theirs;
  std::vector<double> lazy(spaces.size()), full(spaces.size());
  for (int round = 0; round <= (grasps < kGrasps ? 2 : kRounds); ++round) {
    const double a = seconds([&] { for (std::size_t i = 0; i < spaces.size(); ++i) lazy[i] = largest_ellipsoid(spaces[i]).factor; });
    const double b = seconds([&] { for (std::size_t i = 0; i < spaces.size(); ++i) full[i] = by_qhull(points[i]); });
    if (round == 0) continue;  // caches are cold
    ratios.push_back(b / a), ours.push_back(a / grasps), theirs.push_back(b / grasps);
  }
  double apart = 0.0;
  for (std::size_t i = 0; i < lazy.size(); ++i) apart = std::max(apart, std::abs(lazy[i] - full[i]));
  for (auto* all : {&ratios, &ours, &theirs}) std::sort(all->begin(), all->end());
  const std::size_t middle = ratios.size() / 2;
  const auto closed = std::count_if(lazy.begin(), lazy.end(), [](double e) { return e > 0.0; });
  fmt::print("{:<8} {} contacts {:<4}  {:>2} of {:>2} closed  lazy hull {:8.4f} ms  Qhull {:9.3f} ms  ratio median {:7.1f}, least {:7.1f}  apart {:.1e}\n",
             sort, count, bound == ForceBound::kSum ? "l1" : "linf", closed, grasps, 1e3 * ours[middle], 1e3 * theirs[middle],
             ratios[middle], ratios.front(), apart);
}

}  // namespace

int main() {
  fmt::print("epsilon by the lazy hull against Qhull, facets only: preshape {}, {} build, {} edges, seed {}, {} rounds\n",
             PRESHAPE_VERSION_STRING, PRESHAPE_BUILD_TYPE, kEdges, kSeed, kRounds);
  for (int count = 3; count <= 5; ++count) {
    compare("opposed", count, ForceBound::kSum, kGrasps, [=](Random& r) { return opposed_grasp(r, count); });
    compare("random", count, ForceBound::kSum, kGrasps, [=](Random& r) { return random_grasp(r, count, 0.5); });
    compare("ring", count, ForceBound::kSum, kGrasps, [=](Random&) { return ring(count); });
  }
  compare("random", 3, ForceBound::kEach, 4, [](Random& r) { return random_grasp(r, 3, 0.5); });
}
