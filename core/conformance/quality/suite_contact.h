#pragma once

#include "preshape/contact/contact_limits.h"

namespace preshape::conformance {

/// What each contact of a grasp transmits, as its number of unit wrenches.
enum class Transmits { kNormal = 1, kForce = 3, kForceAndSpin = 4 };

/// The contact model of the suite's grasps, with limits: Coulomb's cone of kFriction, and a spin about the normal in the
/// ellipsoid f_t^2 + (m_n / kSpin)^2 <= kFriction^2 f_n^2, as far as transmitted.
class SuiteContact final : public ContactModel, public ContactLimits {
 public:
  static constexpr double kFriction = 0.5, kSpin = 0.2;
  explicit SuiteContact(Transmits transmits) : transmits_(transmits) {}

  int basis_size() const noexcept override { return static_cast<int>(transmits_); }
  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<WrenchBasis> basis) const override;
  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override;
  const void* extension(const char* id) const noexcept override;

  int primitive_count(int resolution) const noexcept override;
  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<WrenchBasis> wrenches) const override;
  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override;

 private:
  Transmits transmits_;
};
/// The one model of each sort.
const SuiteContact& suite_contact(Transmits transmits);

}  // namespace preshape::conformance
