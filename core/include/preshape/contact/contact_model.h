#pragma once

#include <span>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/contact/contact_frame.h"
#include "preshape/spatial/wrench.h"

namespace preshape {

using WrenchBasis = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Kind `contact`: what a contact transmits (thesis sec. 2.4.2, table 2.1). [every call: any thread, const]
class PRESHAPE_API ContactModel {
 public:
  virtual ~ContactModel();

  /// Number of unit wrenches of one contact: 1 frictionless point .. 6 plane with friction.
  virtual int basis_size() const noexcept = 0;

  /// Unit wrenches of each contact about its own point, expressed in O (thesis eq. 3.6.6): the columns
  /// i * basis_size() .. (i + 1) * basis_size() - 1 belong to contact i. Moments are without unit.
  /// @param basis 6 x (contacts.size() * basis_size()), overwritten
  virtual void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<WrenchBasis> basis) const = 0;

  /// The wrench that each contact adds to the pattern of the grasp, about its own point, expressed in O
  /// (thesis eq. 3.6.5); moments over the characteristic length.
  virtual void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const = 0;

  /// Growth without a change of this interface: an extension by its id, or null.
  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
