#include <cmath>
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

using preshape::ContactFrame;
using preshape::contact_line_axes;
using preshape::ContactLineAxes;
using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::require_contact_frames;
using preshape::Wrench;

/// Friction line of thesis table 2.1: a straight piece of line, u, in the contact plane, of half length h, each of whose
/// points bears a force within Coulomb's cone [MasonSalisbury1985]. All that such forces can add up to, two at the ends
/// can: f = f1 + f2, m = h u x (f1 - f2). With v = n x u, the ends' parts across the line follow from f and m,
///   2 fn_i = fn -+ (m . v) / h,   2 fv_i = fv +- (m . n) / h,
/// those along it are free but for their sum fu, and the contact bears the wrench when fn_i >= 0, |fv_i| <= mu fn_i,
///   |fu| <= sum_i sqrt((mu fn_i)^2 - fv_i^2)   and   m . u = 0.
///
/// The pattern wrench is a unit normal force with the share `pull` of its friction, `lean` from the approach axis
/// towards t, and the share `twist` of the moment about n that the rest of the friction bears:
///   f = n + pull mu (cos(lean) a' + sin(lean) t),   m = twist (1 - pull) mu h n,   a' = t x n.
class FrictionLine final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("mu", 0.5, 0.01, 5.0, "1", "Coulomb friction coefficient"),
            D::number("half_length", 0.05, 0.001, 1.0, "1", "half of the length of the line, over L"),
            D::choice("line", "along", {"along", "across"}, "it lies along the approach axis or along t"),
            D::number("pull", 0.6, 0.0, 1.0, "1", "share of the friction in the pattern"),
            D::number("lean", 0.5, -3.1416, 3.1416, "rad", "direction of that friction, from the approach towards t"),
            D::number("twist", 1.0, -1.0, 1.0, "1", "share of the moment about n that this leaves, in the pattern")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant", "friction"}; }

  explicit FrictionLine(const preshape::Parameters& p)
      : mu_(p.number("mu")), h_(p.number("half_length")), across_(p.text("line") == "across"), pull_(p.number("pull")),
        lean_(p.number("lean")), twist_(p.number("twist")) {}

  int basis_size() const noexcept override { return 5; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 5, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactLineAxes axes = contact_line_axes(C, across_);
      for (const Eigen::Vector3d& force : {C.n, axes.u, axes.v}) basis.col(column++).head<3>() = force;
      for (const Eigen::Vector3d& moment : {axes.v, C.n}) basis.col(column++).tail<3>() = moment;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Eigen::Vector3d n = contacts[i].n, t = n.cross(contacts[i].a);
      const Eigen::Vector3d friction = std::cos(lean_) * t.cross(n) + std::sin(lean_) * t;
      F_C_O[i] = Wrench(n + pull_ * mu_ * friction, twist_ * (1.0 - pull_) * mu_ * h_ * n);
    }
  }

  int primitive_count(int resolution) const noexcept override {
    return resolution <= std::numeric_limits<int>::max() / 2 ? 2 * resolution : std::numeric_limits<int>::max();
  }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) {
      throw InputError("resolution: a friction cone has at least 3 edges, got " + std::to_string(resolution));
    }
    const auto edges = 2 * static_cast<std::size_t>(resolution);
    preshape::require_size("columns of the wrenches", contacts.size() * edges, static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactLineAxes axes = contact_line_axes(C, across_);
      for (const double end : {-h_, h_}) {
        for (int k = 0; k < resolution; ++k) {
          const double angle = 2.0 * std::numbers::pi * k / resolution;
          const Eigen::Vector3d f = C.n + mu_ * (std::cos(angle) * axes.u + std::sin(angle) * axes.v);
          wrenches.col(column++) << f, end * axes.u.cross(f);
        }
      }
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const ContactLineAxes axes = contact_line_axes(contact, across_);
    const Eigen::Vector3d f = F_C_O.force(), m = F_C_O.moment();
    const double fn = f.dot(contact.n), fu = f.dot(axes.u), fv = f.dot(axes.v), missed = tolerance * fn;
    if (fn < 0.0 || std::abs(m.dot(axes.u)) > missed) return false;
    double along = 0.0;
    for (const double end : {h_, -h_}) {
      const double fn_i = 0.5 * (fn - m.dot(axes.v) / end), fv_i = 0.5 * (fv + m.dot(contact.n) / end);
      const double most = mu_ * fn_i + missed;
      if (fn_i < -missed || std::abs(fv_i) > most) return false;
      along += std::sqrt((most - fv_i) * (most + fv_i));
    }
    return std::abs(fu) <= along;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  double mu_, h_;
  bool across_;
  double pull_, lean_, twist_;
};

}  // namespace

PRESHAPE_PLUGIN(({"friction_line", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Line contact with Coulomb friction"}),
                ({"contact/friction_line"}),
                preshape::component<FrictionLine>("friction_line",
                                        "Piece of line with Coulomb friction at every point, its cone included"))
