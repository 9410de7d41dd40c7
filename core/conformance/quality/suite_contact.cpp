#include "suite_contact.h"

#include <cmath>
#include <cstring>
#include <numbers>

namespace preshape::conformance {

namespace {

/// Tangents that turn with the scene: t and n x t, where the normal is not along the approach axis.
std::pair<Eigen::Vector3d, Eigen::Vector3d> tangents(const ContactFrame& C) {
  const Eigen::Vector3d u = C.t.norm() < 1e-9 ? C.n.unitOrthogonal() : C.t.normalized();
  return {u, C.n.cross(u)};
}

}  // namespace

void SuiteContact::wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<WrenchBasis> basis) const {
  Eigen::Index next = 0;
  for (const ContactFrame& C : contacts) {
    const auto [u, v] = tangents(C);
    Eigen::Matrix<double, 6, 4> all = Eigen::Matrix<double, 6, 4>::Zero();
    all.topRows<3>().leftCols<3>() << C.n, u, v;
    all.bottomRows<3>().col(3) = C.n;
    basis.middleCols(next, basis_size()) = all.leftCols(basis_size());
    next += basis_size();
  }
}

void SuiteContact::pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactFrame& C = contacts[i];
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    F_C_O[i] = transmits_ == Transmits::kNormal ? Wrench(C.n, none)
                                                : Wrench(0.45 * C.a + C.n + 0.25 * C.t,
                                                         transmits_ == Transmits::kForce ? none : Eigen::Vector3d(0.8 * C.n));
  }
}

const void* SuiteContact::extension(const char* id) const noexcept {
  return std::strcmp(id, ContactLimits::kId) == 0 ? static_cast<const ContactLimits*>(this) : nullptr;
}

int SuiteContact::primitive_count(int resolution) const noexcept {
  return transmits_ == Transmits::kNormal ? 1 : transmits_ == Transmits::kForce ? resolution : resolution + 2;
}

void SuiteContact::primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                                      Eigen::Ref<WrenchBasis> wrenches) const {
  wrenches.setZero();
  Eigen::Index next = 0;
  for (const ContactFrame& C : contacts) {
    const auto [u, v] = tangents(C);
    const int count = primitive_count(resolution);
    for (int k = 0; k < count; ++k, ++next) {
      wrenches.col(next).head<3>() = C.n;
      if (transmits_ == Transmits::kNormal) continue;
      const double angle = 2.0 * std::numbers::pi * k / resolution;
      if (k < resolution) wrenches.col(next).head<3>() += kFriction * (std::cos(angle) * u + std::sin(angle) * v);
      else wrenches.col(next).tail<3>() = (k == resolution ? kFriction : -kFriction) * kSpin * C.n;
    }
  }
}

bool SuiteContact::admits(const ContactFrame& C, const Wrench& F, double tolerance) const {
  const double normal = F.force().dot(C.n), spin = F.moment().dot(C.n), most = kFriction * normal + tolerance * normal;
  const double tangential = (F.force() - normal * C.n).norm(), bending = (F.moment() - spin * C.n).norm();
  if (normal < 0.0 || bending > tolerance * normal) return false;
  if (transmits_ == Transmits::kNormal) return tangential <= tolerance * normal && std::abs(spin) <= tolerance * normal;
  if (transmits_ == Transmits::kForce) return tangential <= most && std::abs(spin) <= tolerance * normal;
  return std::hypot(tangential, spin / kSpin) <= most;
}

const SuiteContact& suite_contact(Transmits transmits) {
  static const SuiteContact normal(Transmits::kNormal), force(Transmits::kForce), spin(Transmits::kForceAndSpin);
  return transmits == Transmits::kNormal ? normal : transmits == Transmits::kForce ? force : spin;
}

}  // namespace preshape::conformance
