// Contact models: three good ones, and one for each check that it breaks.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "preshape/base/require.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ContactFrame;
using preshape::ContactLimits;
using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::Wrench;
using preshape::WrenchBasis;
using Eigen::Vector3d;
using Names = std::vector<std::string>;
using Basis = Eigen::Ref<WrenchBasis>;
using Contacts = std::span<const ContactFrame>;

/// Tangents of a contact; any two when the approach axis is parallel to the normal.
struct Tangents {
  Vector3d u, v;
  explicit Tangents(const ContactFrame& C) {
    if (!(std::abs(C.n.norm() - 1.0) <= 1e-6)) throw InputError("the normal of a contact must be a unit vector");
    v = C.n.cross(C.a).norm() > 1e-6 ? C.n.cross(C.a).normalized() : C.n.unitOrthogonal();
    u = v.cross(C.n).normalized();
  }
};

/// A point contact that transmits its normal force alone.
class Frictionless : public preshape::ContactModel {
 public:
  explicit Frictionless(const preshape::Parameters&) {}
  int basis_size() const noexcept override { return 1; }
  void wrench_basis(Contacts contacts, Basis basis) const override {
    const auto size = static_cast<std::size_t>(basis_size());
    preshape::require_size("columns of the basis", contacts.size() * size, static_cast<std::size_t>(basis.cols()));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      fill_basis(contacts[i], basis.middleCols(static_cast<Eigen::Index>(i * size), basis_size()));
    }
  }
  void pattern_wrenches(Contacts contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    std::transform(contacts.begin(), contacts.end(), F_C_O.begin(), [&](const ContactFrame& C) { return pattern(C); });
  }

 protected:
  virtual void fill_basis(const ContactFrame& C, Basis basis) const { basis.col(0) << C.n, Vector3d::Zero(); }
  virtual Wrench pattern(const ContactFrame& C) const { return {C.n, Vector3d::Zero()}; }
};

struct GoodFrictionless final : Frictionless {
  using Frictionless::Frictionless;
  static Names capabilities() { return {"frame_covariant"}; }
};

/// A point contact with Coulomb friction, with limits. What is wrong with the others is wrong in one of these.
class HardFinger : public Frictionless, public ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("mu", 0.5, 0.0, 10.0, "1", "Coulomb's coefficient")};
  }
  explicit HardFinger(const preshape::Parameters& p) : Frictionless(p), mu_(p.number("mu")) {}
  int basis_size() const noexcept override { return 3; }
  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const ContactLimits*>(this) : nullptr;
  }

  int primitive_count(int resolution) const noexcept override { return resolution; }
  void primitive_wrenches(Contacts contacts, int resolution, Basis wrenches) const override {
    if (resolution < 3) throw InputError("the resolution must be at least 3, got " + std::to_string(resolution));
    const auto count = static_cast<std::size_t>(primitive_count(resolution));
    preshape::require_size("columns of the edges", contacts.size() * count, static_cast<std::size_t>(wrenches.cols()));
    for (std::size_t i = 0; i < wrenches.cols() / count; ++i) {
      for (std::size_t k = 0; k < count; ++k) {
        wrenches.col(static_cast<Eigen::Index>(i * count + k)) = edge(contacts[i], static_cast<int>(k), resolution).vector();
      }
    }
  }
  bool admits(const ContactFrame& C, const Wrench& F, double tolerance) const override {
    const double normal = F.force().dot(C.n), slack = tolerance * std::abs(normal);
    return normal >= 0.0 && moment_fits(C, F, slack) && force_fits(C, F.force() - normal * C.n, normal, slack);
  }

 protected:
  void fill_basis(const ContactFrame& C, Basis basis) const override {
    const Tangents T(C);
    basis.setZero();
    basis.topRows<3>() << C.n, T.u, T.v;
  }
  virtual Wrench edge(const ContactFrame& C, int k, int resolution) const {
    const Tangents T(C);
    const double angle = 2.0 * std::numbers::pi * k / resolution;
    return {C.n + mu_ * (std::cos(angle) * T.u + std::sin(angle) * T.v), Vector3d::Zero()};
  }
  virtual bool moment_fits(const ContactFrame&, const Wrench& F, double slack) const { return F.moment().norm() <= slack; }
  virtual bool force_fits(const ContactFrame&, const Vector3d& side, double normal, double slack) const {
    return side.norm() <= mu_ * normal + slack;
  }
  double mu_;
};

struct GoodHardFinger final : HardFinger {
  using HardFinger::HardFinger;
  static Names capabilities() { return {"frame_covariant", "friction", "isotropic"}; }
};

/// Coulomb's friction with a moment about the normal: an ellipsoid.
class GoodSoftFinger final : public HardFinger {
 public:
  using HardFinger::HardFinger;
  static Names capabilities() { return {"frame_covariant", "friction", "isotropic"}; }
  int basis_size() const noexcept override { return 4; }
  int primitive_count(int resolution) const noexcept override { return resolution + 2; }
  bool admits(const ContactFrame& C, const Wrench& F, double tolerance) const override {
    const double normal = F.force().dot(C.n), slack = tolerance * std::abs(normal), spin = F.moment().dot(C.n);
    const double side = (F.force() - normal * C.n).norm();
    if (normal < 0.0 || (F.moment() - spin * C.n).norm() > slack) return false;
    return std::hypot(side, mu_ * spin / kTorsion) <= mu_ * normal + slack && std::abs(spin) <= kTorsion * normal + slack;
  }

 private:
  static constexpr double kTorsion = 0.3;
  void fill_basis(const ContactFrame& C, Basis basis) const override {
    HardFinger::fill_basis(C, basis.leftCols(3));
    basis.col(3) << Vector3d::Zero(), C.n;
  }
  Wrench edge(const ContactFrame& C, int k, int resolution) const override {
    if (k < resolution) return HardFinger::edge(C, k, resolution);
    return {C.n, (k == resolution ? kTorsion : -kTorsion) * C.n};
  }
};

struct C01Leans final : HardFinger {
  using HardFinger::HardFinger;
  static Names capabilities() { return {"frame_covariant"}; }
  Wrench pattern(const ContactFrame& C) const override { return {C.n + 0.1 * Vector3d::UnitX(), Vector3d::Zero()}; }
};

/// A plane that is fixed to the object; its moments are about O.
struct C02MomentAboutOrigin final : Frictionless {
  using Frictionless::Frictionless;
  int basis_size() const noexcept override { return 6; }
  void fill_basis(const ContactFrame&, Basis basis) const override { basis.setIdentity(); }
  Wrench pattern(const ContactFrame& C) const override { return {C.n, C.p_OC.cross(C.n)}; }
};

struct C03SlantsForOneBody final : Frictionless {
  using Frictionless::Frictionless;
  Vector3d slanted(const ContactFrame& C) const { return (C.n + 0.3 * C.a).normalized(); }
  void fill_basis(const ContactFrame& C, Basis basis) const override { basis.col(0) << slanted(C), Vector3d::Zero(); }
  Wrench pattern(const ContactFrame& C) const override { return {slanted(C), Vector3d::Zero()}; }
};

struct C04Pulls final : Frictionless {
  using Frictionless::Frictionless;
  Wrench pattern(const ContactFrame& C) const override { return {-0.1 * C.n, Vector3d::Zero()}; }
};

struct C05MoreThanMu final : HardFinger {
  using HardFinger::HardFinger;
  bool force_fits(const ContactFrame&, const Vector3d& side, double normal, double slack) const override {
    return side.norm() <= 1.001 * mu_ * normal + slack;
  }
};

struct C08BreaksAtTen final : HardFinger {
  using HardFinger::HardFinger;
  bool force_fits(const ContactFrame& C, const Vector3d& side, double normal, double slack) const override {
    return normal <= 10.0 && HardFinger::force_fits(C, side, normal, slack);
  }
};

struct C09FourEdgesAtAnyResolution final : HardFinger {
  using HardFinger::HardFinger;
  Wrench edge(const ContactFrame& C, int k, int resolution) const override {
    return HardFinger::edge(C, k % 4, std::min(resolution, 4));
  }
};

/// More friction along the approach axis than across it.
struct C10Grained final : HardFinger {
  using HardFinger::HardFinger;
  static Names capabilities() { return {"isotropic"}; }
  Wrench edge(const ContactFrame& C, int k, int resolution) const override {
    const Vector3d f = HardFinger::edge(C, k, resolution).force(), v = Tangents(C).v;
    return {f - 0.4 * f.dot(v) * v, Vector3d::Zero()};
  }
  bool force_fits(const ContactFrame& C, const Vector3d& side, double normal, double slack) const override {
    const Tangents T(C);
    return std::hypot(side.dot(T.u), side.dot(T.v) / 0.6) <= mu_ * normal + slack;
  }
};

struct C11CountsTwice final : Frictionless {
  using Frictionless::Frictionless;
  int basis_size() const noexcept override { return 2; }
  void fill_basis(const ContactFrame& C, Basis basis) const override {
    basis.setZero();
    basis.topRows<3>() << C.n, C.n;
  }
};

struct C15DividesByTheNormal final : Frictionless {
  using Frictionless::Frictionless;
  Wrench pattern(const ContactFrame& C) const override { return {C.n / C.n.norm(), Vector3d::Zero()}; }
};

struct C17Slips final : Frictionless {
  using Frictionless::Frictionless;
  static Names capabilities() { return {"friction"}; }
};

struct C18LooksAtTheNeighbour final : Frictionless {
  using Frictionless::Frictionless;
  void wrench_basis(Contacts contacts, Basis basis) const override {
    Frictionless::wrench_basis(contacts, basis);
    if (contacts.size() > 1) basis.col(0) = -basis.col(0);
  }
};

struct C19SpinsWithoutBasis final : Frictionless {
  using Frictionless::Frictionless;
  Wrench pattern(const ContactFrame& C) const override { return {C.n, 0.2 * C.n}; }
};

struct C20BearsAnyMoment final : HardFinger {
  using HardFinger::HardFinger;
  bool moment_fits(const ContactFrame&, const Wrench&, double) const override { return true; }
};

struct C21ToleranceTakenAway final : HardFinger {
  using HardFinger::HardFinger;
  Wrench edge(const ContactFrame& C, int k, int resolution) const override {
    return {0.001 * C.n + 0.999 * HardFinger::edge(C, k, resolution).force(), Vector3d::Zero()};
  }
  bool force_fits(const ContactFrame&, const Vector3d& side, double normal, double slack) const override {
    return side.norm() <= std::max(0.0, mu_ * normal - slack) + 1e-12 * normal;
  }
};

}  // namespace

using preshape::component;
PRESHAPE_PLUGIN(({"zoo_contact", "1.0.0", "BSD-3-Clause", "the preshape developers", "Contact models, most of them broken"}),
                ({"contact/good_frictionless", "contact/good_hard_finger", "contact/good_soft_finger",
                  "contact/c01_leans", "contact/c02_moment_about_origin", "contact/c03_slants_for_one_body",
                  "contact/c04_pulls", "contact/c05_more_than_mu", "contact/c08_breaks_at_ten",
                  "contact/c09_four_edges_at_any_resolution", "contact/c10_grained", "contact/c11_counts_twice",
                  "contact/c15_divides_by_the_normal", "contact/c17_slips", "contact/c18_looks_at_the_neighbour",
                  "contact/c19_spins_without_basis", "contact/c20_bears_any_moment",
                  "contact/c21_tolerance_taken_away"}),
                component<GoodFrictionless>("good_frictionless", "Normal force alone"),
                component<GoodHardFinger>("good_hard_finger", "Coulomb friction"),
                component<GoodSoftFinger>("good_soft_finger", "Coulomb friction with a moment about the normal"),
                component<C01Leans>("c01_leans", "Leans to one axis of O"),
                component<C02MomentAboutOrigin>("c02_moment_about_origin", "Takes moments about O"),
                component<C03SlantsForOneBody>("c03_slants_for_one_body", "Slants to the approach axis"),
                component<C04Pulls>("c04_pulls", "Pulls"),
                component<C05MoreThanMu>("c05_more_than_mu", "Bears a little more than mu"),
                component<C08BreaksAtTen>("c08_breaks_at_ten", "Bears no force beyond ten"),
                component<C09FourEdgesAtAnyResolution>("c09_four_edges_at_any_resolution", "Never more than four edges"),
                component<C10Grained>("c10_grained", "More friction along the approach axis"),
                component<C11CountsTwice>("c11_counts_twice", "One unit wrench twice"),
                component<C15DividesByTheNormal>("c15_divides_by_the_normal", "Divides by the normal's length"),
                component<C17Slips>("c17_slips", "Promises friction without any"),
                component<C18LooksAtTheNeighbour>("c18_looks_at_the_neighbour", "Turns the first of several"),
                component<C19SpinsWithoutBasis>("c19_spins_without_basis", "A moment that it cannot transmit"),
                component<C20BearsAnyMoment>("c20_bears_any_moment", "Looks at no moment"),
                component<C21ToleranceTakenAway>("c21_tolerance_taken_away", "Tolerance with the wrong sign"))
