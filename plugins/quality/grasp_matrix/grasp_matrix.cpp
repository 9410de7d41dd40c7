#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::WrenchUnion;
using Square = Eigen::Matrix<double, 6, 6>;
using SingularValues = Eigen::Matrix<double, 6, 1>;

/// The triangular factor R of WU = Q R, which has the singular values of WU: six wrenches at a time below
/// what there is, so that nothing is allocated.
Square triangular_factor(const WrenchUnion& wrench_union) {
  using Stack = Eigen::Matrix<double, 12, 6>;
  Square R = Square::Zero();
  for (Eigen::Index first = 0; first < wrench_union.rows(); first += 6) {
    const Eigen::Index count = std::min<Eigen::Index>(6, wrench_union.rows() - first);
    Stack stack = Stack::Zero();
    stack.topRows<6>() = R;
    stack.middleRows(6, count) = wrench_union.middleRows(first, count);
    const Eigen::HouseholderQR<Stack> factor(stack);
    R.triangularView<Eigen::Upper>() = factor.matrixQR().topRows<6>();
  }
  return R;
}

/// The six singular values of the grasp matrix, largest first. The wrench union is its transpose. They are
/// those of the wrenches themselves: the 6 x 6 products would lose half of the digits.
SingularValues singular_values(const WrenchUnion& wrench_union) {
  SingularValues values = Eigen::JacobiSVD<Square>(triangular_factor(wrench_union)).singularValues();
  if (wrench_union.rows() < 6) values.tail(6 - wrench_union.rows()).setZero();
  return values;
}

/// Classical measures of the grasp matrix G = WU', 6 x m, whose columns are the contacts' unit wrenches about
/// O, lengths over L [LiSastry1988; RoaSuarez2015]: with its singular values s_1 >= ... >= s_6
///   smallest singular value = s_6;   condition = s_1 / s_6;   volume = sqrt(det(G G')) = s_1 ... s_6.
class GraspMatrix final : public preshape::QualityMeasure {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_invariant", "frame_invariant_first", "permutation_invariant"};
  }
  explicit GraspMatrix(const preshape::Parameters&) {}

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const preshape::GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    if (!grasp.wrench_union.allFinite())
      throw preshape::InputError("quality 'grasp_matrix': a wrench of the union is not finite");
    const SingularValues s = singular_values(grasp.wrench_union);
    values[0] = s[5];
    values[1] = s[5] * kSingular > s[0] ? s[0] / s[5] : kSingular;
    values[2] = s.prod();
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// A condition from which on a matrix counts as singular: rounding leaves it few sure digits.
  static constexpr double kSingular = 1e6;

  std::array<preshape::QualityNumber, 3> numbers_ = {
      preshape::QualityNumber{"smallest_singular_value", "1", 0, kInfinity, true},
      preshape::QualityNumber{"condition", "1", 1, kSingular, false},
      preshape::QualityNumber{"volume", "1", 0, kInfinity, true}};
};

}  // namespace

PRESHAPE_PLUGIN(({"grasp_matrix", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Singular values of the grasp matrix"}),
                ({"quality/grasp_matrix"}),
                preshape::component<GraspMatrix>(
                    "grasp_matrix", "Smallest singular value, condition and volume of the grasp matrix"))
