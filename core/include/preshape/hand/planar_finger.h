#pragma once

#include <array>
#include <optional>
#include <vector>

#include "preshape/hand/hand_model.h"

namespace preshape {

/// A finger of an abduction joint and three flexion joints whose axes are parallel to each other and at right angles to
/// the abduction's, as thesis sec. 4.4 has it: its inverse kinematics is closed [Craig1986, ch. 4]. All lengths [m],
/// angles [rad], everything in H.
///
/// Abduction q1 turns the plane of the links; the tip is in it when  n(q1) . (p - p1) = d,  n the flexion axis, p1 a
/// point of the abduction axis, d the tip's offset along n: A cos q1 + B sin q1 + C = d has two solutions. In the plane the
/// three links are solved for a chosen sum of the flexions  q2 + q3 + q4 = phi:  two solutions, elbow up and down.
class PRESHAPE_API PlanarFinger {
 public:
  using Values = std::array<double, 4>;

  /// The finger of a hand as such a one, or none when it is not.
  static std::optional<PlanarFinger> recognise(const HandModel& hand, int finger);

  /// Every posture, up to four, whose tip is at p_HD with that sum of flexions, values in -pi .. pi; limits do not count.
  std::vector<Values> solve(const Eigen::Vector3d& p_HD, double phi) const;

  /// Of the postures within the limits with any sum of flexions, the one nearest to `preferred`, or none. Sums are
  /// looked for at even steps, then between the neighbours of the best.
  std::optional<Values> solve_within_limits(const Eigen::Vector3d& p_HD, const Values& preferred) const;

 private:
  PlanarFinger() = default;
  std::vector<double> abductions(const Eigen::Vector3d& p_HD) const;

  Eigen::Vector3d p1_, z1_, n_;                       ///< abduction axis; flexion axis at q1 = 0
  Eigen::Vector3d p2_;                                ///< of the first flexion axis, in the links' plane, at q = 0
  std::array<Eigen::Vector2d, 3> link_;               ///< each link in the plane at q = 0, towards the tip
  Eigen::Vector3d e1_, e2_;                           ///< axes of the plane; e1 x e2 = n
  double d_ = 0.0;
  std::array<double, 4> lower_{}, upper_{};
};

}  // namespace preshape
