#include <array>
#include <limits>

#include "preshape/base/require.h"
#include "preshape/contact/wrench_hull.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ForceBound;
using preshape::ParameterDeclaration;
using preshape::WrenchVector;

WrenchVector six(const preshape::Parameters& p, const char* name) {
  const auto given = p.numbers(name);
  if (given.size() != 6) {
    throw preshape::InputError(std::string("quality 'task_ellipsoid': ") + name +
                               " takes 6 numbers, three of force and three of moment, got " +
                               std::to_string(given.size()));
  }
  return Eigen::Map<const WrenchVector>(given.data());
}

/// Li and Sastry's task-oriented measure [LiSastry1988]: the largest factor by which the task ellipsoid
///   { centre + half_axes .* y : |y| <= 1 }
/// can be multiplied and still lies in the grasp wrench space about O.
class TaskEllipsoid final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::list("half_axes", {1, 1, 1, 1, 1, 1}, 0.0, 1000.0, "1",
                                       "of the task's wrenches along the axes of O: forces, moments over L"),
            ParameterDeclaration::list("centre", {0, 0, 0, 0, 0, 0}, -1000.0, 1000.0, "1",
                                       "of the task's wrenches about O: force, moment over L"),
            ParameterDeclaration::choice("norm", "l1", {"l1", "linf"},
                                         "bound 1 on the sum of the normal forces, or on each"),
            ParameterDeclaration::integer("resolution", 8, 3, 64, "1", "edges of a friction cone")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "permutation_invariant", "force_scale_invariant"};
  }

  explicit TaskEllipsoid(const preshape::Parameters& p)
      : task_{six(p, "centre"), six(p, "half_axes")},
        bound_(p.text("norm") == "linf" ? ForceBound::kEach : ForceBound::kSum),
        resolution_(static_cast<int>(p.integer("resolution"))) {
    if (task_.centre.isZero(0.0) && task_.half_axes.isZero(0.0))
      throw preshape::InputError(
          "quality 'task_ellipsoid': half_axes and centre are all 0, which is no task");
  }

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const preshape::GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    auto primitives = preshape::grasp_primitives(grasp.contact_model, grasp.contacts, resolution_,
                                                 grasp.length_m, "quality 'task_ellipsoid'");
    values[0] =
        preshape::largest_ellipsoid({std::move(primitives.wrenches), primitives.per_contact, bound_}, task_)
            .factor;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  preshape::WrenchEllipsoid task_;
  ForceBound bound_;
  int resolution_;
  std::array<preshape::QualityNumber, 1> numbers_ = {
      preshape::QualityNumber{"task_ellipsoid", "1", 0, kInfinity, true}};
};

}  // namespace

PRESHAPE_PLUGIN(({"task_ellipsoid", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "The largest task ellipsoid in the grasp wrench space"}),
                ({"quality/task_ellipsoid"}),
                preshape::component<TaskEllipsoid>(
                    "task_ellipsoid",
                    "The largest task ellipsoid in the grasp wrench space (Li and Sastry 1988)"))
