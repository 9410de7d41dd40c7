#include <array>
#include <limits>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::GraspView;
using preshape::ParameterDeclaration;

/// From the mean of the forefingers' contacts to the thumb's [m].
Eigen::Vector3d opposition_vector(std::span<const preshape::ContactFrame> contacts) {
  if (contacts.size() < 2) return Eigen::Vector3d::Zero();
  Eigen::Vector3d forefingers = Eigen::Vector3d::Zero();
  for (const auto& contact : contacts.subspan(1)) forefingers += contact.p_OC;
  return contacts.front().p_OC - forefingers / static_cast<double>(contacts.size() - 1);
}

/// Squares of a vector's direction cosines: along the opposition axis, along the part of the approach axis
/// across it, and along what remains. They add up to 1.
std::array<double, 3> shares(const Eigen::Vector3d& v, const GraspView& grasp) {
  const Eigen::Vector3d u = v.normalized(), o = grasp.opposition_O.normalized();
  const Eigen::Vector3d across = grasp.approach_O - grasp.approach_O.dot(o) * o;
  const double pad = std::min(1.0, u.dot(o) * u.dot(o));
  if (across.norm() < 1e-9) return {pad, 0.0, 1.0 - pad};
  const double along = u.dot(across.normalized()), palm = std::min(1.0 - pad, along * along);
  return {pad, palm, 1.0 - pad - palm};
}

/// Opposition type [IberallBinghamArbib1986; MacKenzieIberall1994]: pad opposition presses along an axis in
/// the plane of the palm, palm opposition along the palm's normal, side opposition across both. The axes are
/// those of the approach plane: opposition, approach, transverse.
class Opposition final : public preshape::QualityMeasure {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_invariant", "frame_invariant_first", "permutation_invariant",
            "force_scale_invariant"};
  }
  explicit Opposition(const preshape::Parameters&) {}

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    const Eigen::Vector3d v = opposition_vector(grasp.contacts);
    if (!v.allFinite() || !grasp.approach_O.allFinite() || !grasp.opposition_O.allFinite())
      throw preshape::InputError(
          "quality 'opposition': a contact, the approach or the opposition axis is not known or not finite");
    values[0] = kNone;
    std::fill(values.begin() + 1, values.end(), 0.0);
    if (v.norm() <= 1e-9 * grasp.length_m) return;
    const auto found = shares(v, grasp);
    std::copy(found.begin(), found.end(), values.begin() + 1);
    values[0] = code(found);
  }

 private:
  static constexpr double kNone = -1.0, kTie = 1e-9;

  /// The first of the largest, ties by a rounding among them.
  static double code(const std::array<double, 3>& shares) {
    const double most = *std::max_element(shares.begin(), shares.end());
    return static_cast<double>(
        std::find_if(shares.begin(), shares.end(), [&](double s) { return s >= most - kTie; }) -
        shares.begin());
  }

  std::array<preshape::QualityNumber, 4> numbers_ = {preshape::QualityNumber{"opposition", "-", -1, 2, false},
                                                     preshape::QualityNumber{"pad", "1", 0, 1, true},
                                                     preshape::QualityNumber{"palm", "1", 0, 1, true},
                                                     preshape::QualityNumber{"side", "1", 0, 1, true}};
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"opposition", "1.0.0", "BSD-3-Clause", "the preshape developers", "Pad, palm or side opposition"}),
    ({"quality/opposition"}),
    preshape::component<Opposition>("opposition", "Pad, palm or side opposition, with the shares of each"))
