#include <limits>
#include <vector>

#include "preshape/base/require.h"
#include "preshape/contact/wrench_hull.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"
#include "volume.h"

namespace {

using preshape::ForceBound;
using preshape::GraspWrenchSpace;
using preshape::ParameterDeclaration;

/// Ferrari and Canny's measures of the grasp wrench space about O [FerrariCanny1992]:
///   epsilon = the radius of the largest ball about 0 in it: the weakest wrench that the grasp just resists;
///   volume  = its six-dimensional volume;
/// under normal forces whose sum (l1) or each of which (linf) is at most 1.
class FerrariCanny final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::choice("norm", "l1", {"l1", "linf"},
                                         "bound 1 on the sum of the normal forces, or on each"),
            ParameterDeclaration::integer("resolution", 8, 3, 32, "1", "edges of a friction cone"),
            ParameterDeclaration::flag("volume", false, "give the volume too")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_invariant", "frame_invariant_first", "permutation_invariant",
            "force_scale_invariant"};
  }

  explicit FerrariCanny(const preshape::Parameters& p)
      : bound_(p.text("norm") == "linf" ? ForceBound::kEach : ForceBound::kSum),
        resolution_(static_cast<int>(p.integer("resolution"))),
        with_volume_(p.flag("volume")) {
    if (with_volume_) numbers_.push_back({"wrench_volume", "1", 0, kInfinity, true});
  }

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const preshape::GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    auto primitives = preshape::grasp_primitives(grasp.contact_model, grasp.contacts, resolution_,
                                                 grasp.length_m, "quality 'ferrari_canny'");
    const GraspWrenchSpace space(std::move(primitives.wrenches), primitives.per_contact, bound_);
    const auto fit = preshape::largest_ellipsoid(space);
    values[0] = fit.factor;
    values[1] = fit.spans ? 0.0 : 1.0;
    if (with_volume_) values[2] = fit.spans ? ferrari_canny::volume(space) : 0.0;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  ForceBound bound_;
  int resolution_;
  bool with_volume_;
  std::vector<preshape::QualityNumber> numbers_ = {{"epsilon", "1", 0, kInfinity, true},
                                                   {"degenerate", "1", 0, 1, false}};
};

}  // namespace

PRESHAPE_PLUGIN(({"ferrari_canny", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Epsilon and volume of the grasp wrench space"}),
                ({"quality/ferrari_canny"}),
                preshape::component<FerrariCanny>(
                    "ferrari_canny", "Epsilon and volume of the grasp wrench space (Ferrari and Canny 1992)"))
