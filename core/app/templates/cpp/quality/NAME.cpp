#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/SVD>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::GraspView;
using preshape::ParameterDeclaration;
using preshape::QualityNumber;

/// Smallest singular value of the wrench union [LiSastry1988]: how far the grasp is from losing the wrench that it
/// bears least, and, over the largest one, how evenly it bears all. Forces and moments are made comparable by the
/// characteristic length L, with which the wrench union comes, and by the weight `moment`.
class @CLASS@ final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("moment", 1.0, 0.01, 100.0, "1", "weight of a moment over L beside a force")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_invariant", "permutation_invariant"};
  }

  explicit @CLASS@(const preshape::Parameters& p) : moment_(p.number("moment")) {}

  std::span<const QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    check(grasp);
    values[0] = values[1] = 0.0;
    if (grasp.wrench_union.rows() < 6) return;  // it cannot have rank 6
    Eigen::MatrixXd weighted = grasp.wrench_union;
    weighted.rightCols<3>() *= moment_;
    const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(weighted).singularValues();  // falling
    values[0] = singular[5];
    if (singular[0] > 0.0) values[1] = singular[5] / singular[0];
  }

 private:
  static void check(const GraspView& grasp) {
    bool finite = grasp.wrench_union.allFinite() && grasp.resultant.vector().allFinite() && std::isfinite(grasp.length_m);
    for (const auto& C : grasp.contacts) finite = finite && (C.p_OC + C.n + C.a + C.t).allFinite();
    for (const auto& F : grasp.F_C_O) finite = finite && F.vector().allFinite();
    if (!finite) throw preshape::InputError("grasp: its contacts and wrenches must be finite numbers");
  }

  double moment_;
  std::array<QualityNumber, 2> numbers_ = {
      QualityNumber{"smallest_singular_value", "1", 0.0, std::numeric_limits<double>::infinity(), true},
      QualityNumber{"evenness", "1", 0.0, 1.0, true}};
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Singular values of the wrench union"}),
                ({"quality/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Smallest singular value of the wrench union"))
