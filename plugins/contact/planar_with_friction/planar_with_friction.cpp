#include <algorithm>
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

/// Planar contact with friction of thesis table 2.1: a rectangle of half sides X along x, the approach axis' part in the
/// contact plane, and Y along y = n x x, each of whose points bears a force within a friction pyramid along x and y.
/// The pyramid stands inside Coulomb's cone, s = mu / sqrt(2). With the components fx, fy, fn and mx, my, mz about the
/// rectangle's centre that is exactly [CaronPhamNakamura2015, prop. 1]
///   fn >= 0,  |fx|, |fy| <= s fn,  |mx| <= Y fn,  |my| <= X fn,
///   mz >= -s (X + Y) fn + |Y fx - s mx| + |X fy - s my|,
///   mz <=  s (X + Y) fn - |Y fx + s mx| - |X fy + s my|,
/// the sum of the pyramids at the four corners.
///
/// The pattern wrench is a unit normal force with the share `pull` of its friction, `lean` from the approach axis
/// towards t, and the share `twist` of the moment about n that the rest of the friction bears:
///   f = n + pull s (cos(lean) a' + sin(lean) t),   m = twist (1 - pull) s (X + Y) n,   a' = t x n.
class PlanarWithFriction final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("mu", 0.5, 0.01, 5.0, "1", "Coulomb friction coefficient"),
            D::number("half_length", 0.05, 0.001, 1.0, "1", "half of the side along the approach axis, over L"),
            D::number("half_width", 0.05, 0.001, 1.0, "1", "half of the side along t, over L"),
            D::number("pull", 0.6, 0.0, 1.0, "1", "share of the friction in the pattern"),
            D::number("lean", 0.5, -3.1416, 3.1416, "rad", "direction of that friction, from the approach towards t"),
            D::number("twist", 1.0, -1.0, 1.0, "1", "share of the moment about n that this leaves, in the pattern")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant", "friction"}; }

  explicit PlanarWithFriction(const preshape::Parameters& p)
      : s_(p.number("mu") / std::numbers::sqrt2), X_(p.number("half_length")), Y_(p.number("half_width")),
        pull_(p.number("pull")), lean_(p.number("lean")), twist_(p.number("twist")) {}

  int basis_size() const noexcept override { return 6; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 6, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (const Eigen::Vector3d& axis : {C.n, axes.x, axes.y}) {
        basis.col(column).head<3>() = axis;
        basis.col(column++ + 3).tail<3>() = axis;
      }
      column += 3;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Eigen::Vector3d n = contacts[i].n, t = n.cross(contacts[i].a);
      const Eigen::Vector3d friction = std::cos(lean_) * t.cross(n) + std::sin(lean_) * t;
      F_C_O[i] = Wrench(n + pull_ * s_ * friction, twist_ * (1.0 - pull_) * s_ * (X_ + Y_) * n);
    }
  }

  int primitive_count(int) const noexcept override { return 16; }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) throw InputError("resolution: it must be at least 3, got " + std::to_string(resolution));
    preshape::require_size("columns of the wrenches", contacts.size() * 16, static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (const double along : {-X_, X_}) {
        for (const double across : {-Y_, Y_}) {
          const Eigen::Vector3d p = along * axes.x + across * axes.y;
          for (const double fx : {-s_, s_}) {
            for (const double fy : {-s_, s_}) {
              const Eigen::Vector3d f = C.n + fx * axes.x + fy * axes.y;
              wrenches.col(column++) << f, p.cross(f);
            }
          }
        }
      }
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const ContactPlaneAxes axes = contact_plane_axes(contact);
    const Eigen::Vector3d f = F_C_O.force(), m = F_C_O.moment();
    const double fx = f.dot(axes.x), fy = f.dot(axes.y), fn = f.dot(contact.n), missed = tolerance * fn;
    const double mx = m.dot(axes.x), my = m.dot(axes.y), mz = m.dot(contact.n);
    if (fn < 0.0 || std::max(std::abs(fx), std::abs(fy)) > s_ * fn + missed) return false;
    if (std::abs(mx) > Y_ * fn + missed || std::abs(my) > X_ * fn + missed) return false;
    const double most = s_ * (X_ + Y_) * fn + missed;
    return mz >= std::abs(Y_ * fx - s_ * mx) + std::abs(X_ * fy - s_ * my) - most &&
           mz <= most - std::abs(Y_ * fx + s_ * mx) - std::abs(X_ * fy + s_ * my);
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  double s_, X_, Y_, pull_, lean_, twist_;
};

}  // namespace

PRESHAPE_PLUGIN(({"planar_with_friction", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Planar contact with friction over a rectangle"}),
                ({"contact/planar_with_friction"}),
                preshape::component<PlanarWithFriction>("planar_with_friction",
                                        "Rectangle with friction at every point, its cone included"))
