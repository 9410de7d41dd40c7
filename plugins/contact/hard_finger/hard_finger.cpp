#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/contact/contact_plane.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::contact_plane_axes;
using preshape::ContactFrame;
using preshape::ContactPlaneAxes;
using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::require_contact_frames;
using preshape::Wrench;

/// Hard finger, the friction point of thesis table 2.1: a force f = fn n + ft, ft across the inward normal n, with
/// fn >= 0 and |ft| <= mu fn, and no moment [MurrayLiSastry1994, ch. 5].
///
/// The pattern wrench is a unit normal force with the share `pull` of its friction in the contact plane, `lean` from
/// the approach axis towards t: f = n + pull mu (cos(lean) a' + sin(lean) t), a' = t x n. Both a' and t shrink as the
/// approach axis nears the normal.
class HardFinger final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("mu", 0.5, 0.01, 5.0, "1", "Coulomb friction coefficient"),
            ParameterDeclaration::number("pull", 1.0, 0.0, 1.0, "1", "share of the friction in the pattern"),
            ParameterDeclaration::number("lean", 0.5, -3.1416, 3.1416, "rad",
                                         "direction of that friction, from the approach towards t")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_covariant", "friction", "isotropic"};
  }

  explicit HardFinger(const preshape::Parameters& p)
      : mu_(p.number("mu")), pull_(p.number("pull")), lean_(p.number("lean")) {}

  int basis_size() const noexcept override { return 3; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 3, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (const Eigen::Vector3d& force : {C.n, axes.x, axes.y}) basis.col(column++).head<3>() = force;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Eigen::Vector3d n = contacts[i].n, t = n.cross(contacts[i].a);
      const Eigen::Vector3d friction = std::cos(lean_) * t.cross(n) + std::sin(lean_) * t;
      F_C_O[i] = Wrench(n + pull_ * mu_ * friction, Eigen::Vector3d::Zero());
    }
  }

  int primitive_count(int resolution) const noexcept override { return resolution; }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) {
      throw InputError("resolution: a friction cone has at least 3 edges, got " + std::to_string(resolution));
    }
    const auto edges = static_cast<std::size_t>(resolution);
    preshape::require_size("columns of the wrenches", contacts.size() * edges, static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    wrenches.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (int k = 0; k < resolution; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / resolution;
        wrenches.col(column++).head<3>() = C.n + mu_ * (std::cos(angle) * axes.x + std::sin(angle) * axes.y);
      }
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const double fn = F_C_O.force().dot(contact.n), missed = tolerance * fn;
    const double ft = (F_C_O.force() - fn * contact.n).norm();
    return fn >= 0.0 && ft <= mu_ * fn + missed && F_C_O.moment().norm() <= missed;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  double mu_, pull_, lean_;
};

}  // namespace

PRESHAPE_PLUGIN(({"hard_finger", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Hard finger: point contact with Coulomb friction"}),
                ({"contact/hard_finger"}),
                preshape::component<HardFinger>("hard_finger", "Point contact with Coulomb friction, its cone included"))
