#include <cmath>
#include <string>
#include <string_view>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ContactFrame;
using preshape::InputError;
using preshape::Wrench;

void require_frames(std::span<const ContactFrame> contacts) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactFrame& C = contacts[i];
    if (std::abs(C.n.norm() - 1.0) <= 1e-6 && C.p_OC.allFinite() && C.a.allFinite() && C.t.allFinite()) continue;
    throw InputError("contact " + std::to_string(i) +
                     ": its normal must be a unit vector, its point and axes finite numbers");
  }
}

/// Frictionless point of thesis table 2.1: a push along the inward normal n and nothing else [Salisbury1982]. Unit
/// wrench, pattern wrench and only edge of its cone are the unit normal force.
class FrictionlessPoint final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<preshape::ParameterDeclaration> parameters() { return {}; }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant", "isotropic"}; }

  explicit FrictionlessPoint(const preshape::Parameters&) {}

  int basis_size() const noexcept override { return 1; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size(), static_cast<std::size_t>(basis.cols()));
    require_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) basis.col(column++).head<3>() = C.n;
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) F_C_O[i] = Wrench(contacts[i].n, Eigen::Vector3d::Zero());
  }

  int primitive_count(int) const noexcept override { return 1; }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) throw InputError("resolution: it must be at least 3, got " + std::to_string(resolution));
    preshape::require_size("columns of the wrenches", contacts.size(), static_cast<std::size_t>(wrenches.cols()));
    wrench_basis(contacts, wrenches);
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const double fn = F_C_O.force().dot(contact.n), missed = tolerance * fn;
    return fn >= 0.0 && (F_C_O.force() - fn * contact.n).norm() <= missed && F_C_O.moment().norm() <= missed;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"frictionless_point", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Frictionless point contact"}),
                ({"contact/frictionless_point"}),
                preshape::component<FrictionlessPoint>("frictionless_point",
                                                       "Point contact that only pushes along its normal"))
