#include <array>

#include "preshape/base/require.h"
#include "preshape/contact/grasp_wrench_space.h"
#include "preshape/contact/linear_program.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"
#include "preshape/spatial/reciprocal.h"

namespace {

using preshape::ParameterDeclaration;
using preshape::WrenchBasis;

/// The largest t such that coefficients x >= t with sum 1 balance the wrenches, times their number: from 0
/// (some are of no use) to 1 (all push alike). With x = y + t it is a programme in y, t >= 0.
double balance(const WrenchBasis& G) {
  const Eigen::Index count = G.cols();
  preshape::EquilibriumProgram p;
  p.E.resize(6, count + 1);
  p.E << G, G.rowwise().sum();
  p.A = Eigen::RowVectorXd::Ones(count + 1);
  p.A(0, count) = static_cast<double>(count);
  p.b = Eigen::VectorXd::Ones(1);
  p.c = Eigen::VectorXd::Unit(count + 1, count) * static_cast<double>(count);
  return std::clamp(preshape::maximise(p).value, 0.0, 1.0);
}

/// Force closure: the contacts' primitive wrenches span six dimensions, and a combination of them with
/// positive coefficients throughout is 0 [MurrayLiSastry1994, ch. 5]. By a linear programme.
class ForceClosure final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {
        ParameterDeclaration::integer("resolution", 8, 3, 64, "1", "edges of a friction cone"),
        ParameterDeclaration::number("tolerance", 1e-7, 1e-12, 0.1, "1", "a margin up to it counts as none")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_invariant", "frame_invariant_first", "permutation_invariant",
            "force_scale_invariant"};
  }

  explicit ForceClosure(const preshape::Parameters& p)
      : resolution_(static_cast<int>(p.integer("resolution"))), tolerance_(p.number("tolerance")) {}

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const preshape::GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    const WrenchBasis G = preshape::grasp_primitives(grasp.contact_model, grasp.contacts, resolution_,
                                                     grasp.length_m, "quality 'force_closure'")
                              .wrenches;
    const double margin = preshape::wrench_rank(G.transpose()) == 6 ? balance(G) : 0.0;
    values[0] = margin > tolerance_ ? 1.0 : 0.0;
    values[1] = margin > tolerance_ ? margin : 0.0;
  }

 private:
  int resolution_;
  double tolerance_;
  std::array<preshape::QualityNumber, 2> numbers_ = {
      preshape::QualityNumber{"force_closure", "1", 0, 1, true},
      preshape::QualityNumber{"closure_margin", "1", 0, 1, true}};
};

}  // namespace

PRESHAPE_PLUGIN(({"force_closure", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Force closure by a linear programme"}),
                ({"quality/force_closure"}),
                preshape::component<ForceClosure>(
                    "force_closure", "Whether the contacts can resist every wrench, by a linear programme"))
