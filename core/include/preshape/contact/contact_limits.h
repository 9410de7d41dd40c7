#pragma once

#include <span>

#include "preshape/contact/contact_model.h"

namespace preshape {

/// Extension of a contact model: which wrenches a contact can bear. Its cone is that of a unit normal force,
/// scaled by any factor >= 0. [every call: any thread, const]
class PRESHAPE_API ContactLimits {
 public:
  /// What ContactModel::extension is asked for.
  static constexpr const char* kId = "preshape.contact_limits/1";

  virtual ~ContactLimits();

  /// Number of primitive wrenches of one contact.
  /// @param resolution edges round the normal, >= 3; a contact without friction has one wrench at any
  virtual int primitive_count(int resolution) const noexcept = 0;

  /// Edges of an inner polyhedral approximation of the cone, each with unit normal force, about the contact's
  /// own point, expressed in O; moments over the characteristic length.
  /// @param wrenches 6 x (contacts.size() * primitive_count(resolution)), overwritten
  /// @throws InputError when its size does not fit or the resolution is below 3
  virtual void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                                  Eigen::Ref<WrenchBasis> wrenches) const = 0;

  /// Whether the contact can bear the wrench, given about its own point in O.
  /// @param tolerance share of the normal force by which a bound may be missed
  virtual bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const = 0;
};

/// The model's limits, or null when it says nothing of them.
inline const ContactLimits* contact_limits(const ContactModel& model) {
  return static_cast<const ContactLimits*>(model.extension(ContactLimits::kId));
}

}  // namespace preshape
