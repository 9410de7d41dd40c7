#include <cmath>
#include <numbers>
#include <string>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ContactFrame;
using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::Wrench;

/// Hard finger: a point contact with Coulomb friction. It passes any force f = fn n + ft, ft across the inward normal
/// n, with fn >= 0 and |ft| <= mu fn, and no moment [MurrayLiSastry1994, ch. 5].
///
/// The pattern wrench is a unit normal force, and the share `pull` of the friction that it allows, along the part of
/// the approach axis a in the contact plane: f = n + pull mu (a - (a . n) n).
class @CLASS@ final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("mu", 0.5, 0.01, 10.0, "1", "Coulomb friction coefficient"),
            ParameterDeclaration::number("pull", 0.5, 0.0, 1.0, "1", "share of the friction used along the approach")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "frame_covariant", "friction"};
  }

  explicit @CLASS@(const preshape::Parameters& p) : mu_(p.number("mu")), pull_(p.number("pull")) {}

  int basis_size() const noexcept override { return 3; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 3, static_cast<std::size_t>(basis.cols()));
    check(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const Tangents across = tangents(C);
      basis.col(column++).head<3>() = C.n;
      basis.col(column++).head<3>() = across.first;
      basis.col(column++).head<3>() = across.second;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    check(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactFrame& C = contacts[i];
      const Eigen::Vector3d a_across = C.a - C.a.dot(C.n) * C.n;
      F_C_O[i] = Wrench(C.n + pull_ * mu_ * a_across, Eigen::Vector3d::Zero());
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
    check(contacts);
    wrenches.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const Tangents across = tangents(C);
      for (int k = 0; k < resolution; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / resolution;
        wrenches.col(column++).head<3>() =
            C.n + mu_ * (std::cos(angle) * across.first + std::sin(angle) * across.second);
      }
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    check({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const double fn = F_C_O.force().dot(contact.n);
    const double ft = (F_C_O.force() - fn * contact.n).norm();
    return fn >= 0.0 && ft <= (mu_ + tolerance) * fn && F_C_O.moment().norm() <= tolerance * fn;
  }

  const void* extension(const char* id) const noexcept override {
    if (std::string_view(id) == kId) return static_cast<const preshape::ContactLimits*>(this);
    return nullptr;
  }

 private:
  struct Tangents {
    Eigen::Vector3d first, second;
  };

  /// Two unit vectors across the normal and each other. They turn with the contact, unless the approach axis runs
  /// along the normal: then any pair does.
  static Tangents tangents(const ContactFrame& C) {
    Eigen::Vector3d t = C.n.cross(C.a);
    if (t.norm() < 1e-9) {
      Eigen::Index least;
      C.n.cwiseAbs().minCoeff(&least);
      t = C.n.cross(Eigen::Vector3d::Unit(least));
    }
    t.normalize();
    return {t.cross(C.n), t};
  }

  static void check(std::span<const ContactFrame> contacts) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactFrame& C = contacts[i];
      if (C.p_OC.allFinite() && C.n.allFinite() && C.a.allFinite() && C.t.allFinite()) continue;
      throw InputError("contact " + std::to_string(i) + ": its point and axes must be finite numbers");
    }
  }

  double mu_, pull_;
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Hard finger with Coulomb friction"}),
                ({"contact/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Hard finger: any force in the Coulomb cone, no moment"))
