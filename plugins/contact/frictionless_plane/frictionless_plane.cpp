#include <cmath>
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

/// Frictionless plane of thesis table 2.1: a rectangle of the contact plane pushes along the inward normal n, with its
/// pressure anywhere inside: a force fn n and the moments of n at a point of the rectangle,
///   fn >= 0,  |m . x| <= half_width fn,  |m . y| <= half_length fn
/// with x along the approach axis' part in the contact plane and y = n x x [MasonSalisbury1985]. It is what four
/// frictionless points at the corners bear. The pattern wrench is a unit normal force at the centre of pressure.
class FrictionlessPlane final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("half_length", 0.05, 0.001, 1.0, "1", "half of the side along the approach axis, over L"),
            D::number("half_width", 0.05, 0.001, 1.0, "1", "half of the side along t, over L"),
            D::number("press_along", 0.0, -1.0, 1.0, "1", "where the pattern presses, share of half_length"),
            D::number("press_across", 0.0, -1.0, 1.0, "1", "where the pattern presses, share of half_width")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant"}; }

  explicit FrictionlessPlane(const preshape::Parameters& p)
      : half_length_(p.number("half_length")), half_width_(p.number("half_width")), press_along_(p.number("press_along")),
        press_across_(p.number("press_across")) {}

  int basis_size() const noexcept override { return 3; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 3, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      basis.col(column++).head<3>() = C.n;
      basis.col(column++).tail<3>() = axes.x;
      basis.col(column++).tail<3>() = axes.y;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto F = push(contacts[i], contact_plane_axes(contacts[i]), press_along_, press_across_);
      F_C_O[i] = Wrench::from_vector(F);
    }
  }

  int primitive_count(int) const noexcept override { return 4; }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) throw InputError("resolution: it must be at least 3, got " + std::to_string(resolution));
    preshape::require_size("columns of the wrenches", contacts.size() * 4, static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      const ContactPlaneAxes axes = contact_plane_axes(C);
      for (const double along : {-1.0, 1.0}) {
        for (const double across : {-1.0, 1.0}) wrenches.col(column++) = push(C, axes, along, across);
      }
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const ContactPlaneAxes axes = contact_plane_axes(contact);
    const Eigen::Vector3d f = F_C_O.force(), m = F_C_O.moment();
    const double fn = f.dot(contact.n), missed = tolerance * fn;
    return fn >= 0.0 && (f - fn * contact.n).norm() <= missed && std::abs(m.dot(contact.n)) <= missed &&
           std::abs(m.dot(axes.x)) <= half_width_ * fn + missed && std::abs(m.dot(axes.y)) <= half_length_ * fn + missed;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  /// A unit normal force at a point of the rectangle, given by its shares of the half sides.
  Eigen::Matrix<double, 6, 1> push(const ContactFrame& C, const ContactPlaneAxes& axes, double along, double across) const {
    const Eigen::Vector3d p = along * half_length_ * axes.x + across * half_width_ * axes.y;
    return (Eigen::Matrix<double, 6, 1>() << C.n, p.cross(C.n)).finished();
  }

  double half_length_, half_width_, press_along_, press_across_;
};

}  // namespace

PRESHAPE_PLUGIN(({"frictionless_plane", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Frictionless plane contact over a rectangle"}),
                ({"contact/frictionless_plane"}),
                preshape::component<FrictionlessPlane>("frictionless_plane",
                                        "Rectangle that only pushes along its normal, its cone included"))
