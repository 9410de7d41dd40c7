#include "volume.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <string>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "preshape/base/error.h"

namespace ferrari_canny {

namespace {

using preshape::ForceBound;
using preshape::GraspWrenchSpace;
using preshape::WrenchBasis;

/// How many points there are to look at: sums of a wrench, or none, of each contact; or all wrenches and 0.
double point_count(const GraspWrenchSpace& space) {
  const auto contacts = static_cast<double>(space.primitives().cols() / space.per_contact());
  if (space.bound() == ForceBound::kSum) return static_cast<double>(space.primitives().cols()) + 1.0;
  return std::pow(static_cast<double>(space.per_contact()) + 1.0, contacts);
}

WrenchBasis points_of(const GraspWrenchSpace& space) {
  WrenchBasis points = WrenchBasis::Zero(6, 1);
  if (space.bound() == ForceBound::kSum) {
    points.conservativeResize(6, space.primitives().cols() + 1);
    points.rightCols(space.primitives().cols()) = space.primitives();
    return points;
  }
  const Eigen::Index each = space.per_contact();
  for (Eigen::Index first = 0; first < space.primitives().cols(); first += each) {
    const Eigen::Index before = points.cols();
    points.conservativeResize(6, before * (each + 1));
    for (Eigen::Index k = 0; k < each; ++k) {
      points.middleCols((k + 1) * before, before) =
          points.leftCols(before).colwise() + space.primitives().col(first + k);
    }
  }
  return points;
}

/// Where Qhull's words go: it cannot do without a stream.
struct Silence {
  char text[512];
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{fmemopen(text, sizeof text, "w"), std::fclose};
};

/// One state of Qhull, freed with all that it allocated.
class Qhull {
 public:
  explicit Qhull(std::FILE* words) { qh_zero(&state_, words); }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int blocks = 0, bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }

  /// @returns nothing when it finds no hull
  std::optional<double> volume(WrenchBasis points, std::string options, std::FILE* words) {
    const int failed = qh_new_qhull(&state_, 6, static_cast<int>(points.cols()), points.data(), False,
                                    options.data(), nullptr, words);
    if (failed == qh_ERRmem) throw std::bad_alloc();
    if (failed) return std::nullopt;
    qh_getarea(&state_, state_.facet_list);
    return state_.totvol;
  }

 private:
  qhT state_;
};

}  // namespace

double volume(const GraspWrenchSpace& space) {
  if (point_count(space) > static_cast<double>(kMostPoints)) {
    throw preshape::InputError("quality 'ferrari_canny': the volume needs the hull of " +
                               std::to_string(static_cast<long long>(std::min(1e15, point_count(space)))) +
                               " points, and the most is " + std::to_string(kMostPoints) +
                               "; lower `resolution`, or set volume = false");
  }
  const WrenchBasis points = points_of(space);
  for (const char* options : {"qhull Pp", "qhull Pp QJ"}) {
    Silence silence;
    if (!silence.stream) throw std::bad_alloc();
    if (const auto found = Qhull(silence.stream.get()).volume(points, options, silence.stream.get()))
      return *found;
  }
  throw preshape::InputError(
      "quality 'ferrari_canny': Qhull finds no hull of the wrenches; set volume = false");
}

}  // namespace ferrari_canny
