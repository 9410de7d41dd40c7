#pragma once

#include <span>
#include <string_view>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/contact/contact_model.h"

namespace preshape {

using WrenchVector = Eigen::Matrix<double, 6, 1>;

/// What bounds the normal forces of a grasp's contacts [FerrariCanny1992].
enum class ForceBound {
  kSum,   ///< their sum is at most 1 (L1: one source of power for all)
  kEach,  ///< each is at most 1 (L_inf: each finger has its own)
};

/// The wrenches about O that a grasp can apply under a bound of its normal forces: a convex polytope that has
/// the origin in it. Lengths are over the characteristic length. Under kSum it is the convex hull of the
/// contacts' primitive wrenches and 0; under kEach the Minkowski sum of such hulls, one a contact, which is
/// never enumerated.
class PRESHAPE_API GraspWrenchSpace {
 public:
  /// Of primitive wrenches about O, each of unit normal force: 6 x (contacts * per_contact), finite.
  /// @throws InputError when one is not finite
  GraspWrenchSpace(WrenchBasis primitives, Eigen::Index per_contact, ForceBound bound);

  /// The vertex that is farthest along u, O(columns).
  WrenchVector support(const WrenchVector& u) const;
  /// An upper bound of the vertices' norms.
  double radius() const { return radius_; }

  const WrenchBasis& primitives() const { return primitives_; }
  Eigen::Index per_contact() const { return per_contact_; }
  ForceBound bound() const { return bound_; }

 private:
  WrenchBasis primitives_;
  Eigen::Index per_contact_;
  ForceBound bound_;
  double radius_;
};

/// Primitive wrenches of contacts about O: the edges of inner polyhedral approximations of what each can
/// bear.
struct GraspPrimitives {
  WrenchBasis
      wrenches;  ///< 6 x (contacts * per_contact), unit normal force, lengths over the characteristic length
  Eigen::Index per_contact = 0;
};

/// @param model null when it is not known
/// @param resolution edges round each normal, >= 3
/// @param owner who asks, for the message: "quality 'ferrari_canny'"
/// @throws InputError when the model is not known or says nothing of its limits, or a contact is not finite
PRESHAPE_API GraspPrimitives grasp_primitives(const ContactModel* model,
                                              std::span<const ContactFrame> contacts, int resolution,
                                              double length_m, std::string_view owner);

}  // namespace preshape
