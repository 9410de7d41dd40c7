#include <array>
#include <cmath>

#include "preshape/base/require.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"
#include "preshape/spatial/reciprocal.h"

namespace {

using preshape::ParameterDeclaration;

/// Stability and manipulability (thesis eq. 3.7.4, 3.7.5):
///   Sta  = 6 - dim Null(WU) = rank(WU);
///   Manu = number of components of the resultant wrench whose magnitude is at least `limit`, where the sets Zero
///          and L cross.
class StaManu final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("limit", 0.1, 0.0, 10.0, "1", "smallest component that counts for manipulability"),
            ParameterDeclaration::number("rank_tolerance", preshape::kRankTolerance, 0.0, 0.1, "1",
                                         "share of the largest singular value that counts as zero")};
  }
  static std::vector<std::string> capabilities() { return {"frame_invariant_first", "permutation_invariant"}; }

  explicit StaManu(const preshape::Parameters& p) : limit_(p.number("limit")), tolerance_(p.number("rank_tolerance")) {}

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const preshape::GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    values[0] = preshape::wrench_rank(grasp.wrench_union, tolerance_);
    // A component that is 0.1 on paper may miss it by a rounding.
    const double limit = limit_ * (1.0 - 1e-12);
    values[1] = static_cast<double>((grasp.resultant.vector().array().abs() >= limit).count());
  }

 private:
  double limit_, tolerance_;
  std::array<preshape::QualityNumber, 2> numbers_ = {preshape::QualityNumber{"stability", "1", 0, 6, true},
                                                     preshape::QualityNumber{"manipulability", "1", 0, 6, true}};
};

}  // namespace

PRESHAPE_PLUGIN(({"sta_manu", "1.0.0", "BSD-3-Clause", "the preshape developers", "Stability and manipulability"}),
                ({"quality/sta_manu"}),
                preshape::component<StaManu>("sta_manu", "Rank of the wrench union and of the resultant (thesis sec. 3.7)"))
