#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

/// The most that friction on a round contact bears about the normal, over mu fn radius: the mean distance from the
/// centre, weighted by the pressure, which falls off as 1, (1 - s^2)^(1/2) or 1 - s^2 at the share s of the radius.
double torsion_factor(const std::string& pressure) {
  if (pressure == "constant") return 2.0 / 3.0;
  return pressure == "hertz" ? 3.0 * std::numbers::pi / 16.0 : 8.0 / 15.0;
}

/// Circles of latitude on the limit surface between its two poles, the equator among them, at about the spacing of
/// `resolution` points round it.
int latitudes(int resolution) { return 2 * std::max(1, resolution / 4) - 1; }

/// Soft finger with an elliptic limit surface [HoweCutkosky1996; CiocarlieLacknerAllen2007]: a force fn n + ft and a
/// moment mz n with fn >= 0 and
///   |ft|^2 + (mz / e_z)^2 <= (mu fn)^2,   e_z = radius times 2/3, 3 pi / 16 or 8/15 by the pressure.
///
/// The pattern wrench is a unit normal force with the share `pull` of its friction in the contact plane, `lean` from
/// the approach axis towards t, and the share `twist` of the moment that this leaves:
///   f = n + pull mu (cos(lean) a' + sin(lean) t),   m = twist e_z mu sqrt(1 - pull^2) n,   a' = t x n.
class SoftFingerElliptic final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("mu", 0.5, 0.01, 5.0, "1", "Coulomb friction coefficient"),
            D::number("radius", 0.05, 0.001, 1.0, "1", "radius of the contact area, over L"),
            D::choice("pressure", "hertz", {"constant", "hertz", "winkler"}, "how the pressure falls off from the centre"),
            D::number("pull", 0.6, 0.0, 1.0, "1", "share of the friction in the pattern"),
            D::number("lean", 0.5, -3.1416, 3.1416, "rad", "direction of that friction, from the approach towards t"),
            D::number("twist", 1.0, -1.0, 1.0, "1", "share of the moment about n that this leaves, in the pattern")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_covariant", "friction", "isotropic"};
  }

  explicit SoftFingerElliptic(const preshape::Parameters& p)
      : mu_(p.number("mu")), e_z_(torsion_factor(p.text("pressure")) * p.number("radius")), pull_(p.number("pull")),
        lean_(p.number("lean")), twist_(p.number("twist")) {}

  int basis_size() const noexcept override { return 4; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 4, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (const Eigen::Vector3d& force : {C.n, axes.x, axes.y}) basis.col(column++).head<3>() = force;
      basis.col(column++).tail<3>() = C.n;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    const double moment = twist_ * e_z_ * mu_ * std::sqrt(1.0 - pull_ * pull_);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Eigen::Vector3d n = contacts[i].n, t = n.cross(contacts[i].a);
      const Eigen::Vector3d friction = std::cos(lean_) * t.cross(n) + std::sin(lean_) * t;
      F_C_O[i] = Wrench(n + pull_ * mu_ * friction, moment * n);
    }
  }

  int primitive_count(int resolution) const noexcept override {
    const std::int64_t count = std::int64_t{latitudes(resolution)} * resolution + 2;
    return static_cast<int>(std::clamp<std::int64_t>(count, 1, std::numeric_limits<int>::max()));
  }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) {
      throw InputError("resolution: a limit surface has at least 3 edges round it, got " + std::to_string(resolution));
    }
    const int count = primitive_count(resolution);
    preshape::require_size("columns of the wrenches", contacts.size() * static_cast<std::size_t>(count),
                           static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    wrenches.setZero();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      auto own = wrenches.middleCols(static_cast<Eigen::Index>(i) * count, count);
      own.topRows<3>().colwise() = contacts[i].n;
      add_limit_surface(contacts[i], resolution, own);
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const double fn = F_C_O.force().dot(contact.n), mz = F_C_O.moment().dot(contact.n), missed = tolerance * fn;
    const double ft = (F_C_O.force() - fn * contact.n).norm();
    return fn >= 0.0 && std::hypot(ft, mz / e_z_) <= mu_ * fn + missed &&
           (F_C_O.moment() - mz * contact.n).norm() <= missed;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  /// Adds points of the limit surface of a unit normal force: the two poles, of moment alone, and circles between.
  void add_limit_surface(const ContactFrame& C, int resolution, Eigen::Ref<preshape::WrenchBasis> wrenches) const {
    const ContactPlaneAxes axes = contact_plane_axes(C);
    wrenches.col(0).tail<3>() = mu_ * e_z_ * C.n;
    wrenches.col(1).tail<3>() = -mu_ * e_z_ * C.n;
    const int circles = latitudes(resolution);
    Eigen::Index column = 2;
    for (int j = 1; j <= circles; ++j) {
      const double latitude = std::numbers::pi * j / (circles + 1);  // from the pole
      for (int k = 0; k < resolution; ++k, ++column) {
        const double angle = 2.0 * std::numbers::pi * k / resolution;
        const Eigen::Vector3d outward = std::cos(angle) * axes.x + std::sin(angle) * axes.y;
        wrenches.col(column).head<3>() += mu_ * std::sin(latitude) * outward;
        wrenches.col(column).tail<3>() = mu_ * e_z_ * std::cos(latitude) * C.n;
      }
    }
  }

  double mu_, e_z_, pull_, lean_, twist_;
};

}  // namespace

PRESHAPE_PLUGIN(({"soft_finger_elliptic", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Soft finger whose friction and torsion share an elliptic limit surface"}),
                ({"contact/soft_finger_elliptic"}),
                preshape::component<SoftFingerElliptic>("soft_finger_elliptic",
                                                        "Soft finger with an elliptic limit surface, its cone included"))
