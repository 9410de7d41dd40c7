#include <cmath>
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

/// Frictionless line of thesis table 2.1: a straight piece of line, u, in the contact plane pushes along the inward
/// normal n, with its pressure anywhere along it: a force fn n and the moment of n at a point of the line,
///   fn >= 0,  |m . v| <= half_length fn,  v = n x u
/// [MasonSalisbury1985]. It is what two frictionless points at the ends bear. The pattern wrench is a unit normal force
/// at the centre of pressure.
class FrictionlessLine final : public preshape::ContactModel, public preshape::ContactLimits {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("half_length", 0.05, 0.001, 1.0, "1", "half of the length of the line, over L"),
            D::choice("line", "along", {"along", "across"}, "it lies along the approach axis or along t"),
            D::number("press", 0.0, -1.0, 1.0, "1", "where on the line the pattern presses, share of half_length")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant"}; }

  explicit FrictionlessLine(const preshape::Parameters& p)
      : half_length_(p.number("half_length")), across_(p.text("line") == "across"), press_(p.number("press")) {}

  int basis_size() const noexcept override { return 2; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<preshape::WrenchBasis> basis) const override {
    preshape::require_size("columns of the basis", contacts.size() * 2, static_cast<std::size_t>(basis.cols()));
    require_contact_frames(contacts);
    basis.setZero();
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      basis.col(column++).head<3>() = C.n;
      basis.col(column++).tail<3>() = contact_line_axes(C, across_).v;
    }
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    preshape::require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_contact_frames(contacts);
    for (std::size_t i = 0; i < contacts.size(); ++i) F_C_O[i] = Wrench::from_vector(push(contacts[i], press_));
  }

  int primitive_count(int) const noexcept override { return 2; }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<preshape::WrenchBasis> wrenches) const override {
    if (resolution < 3) throw InputError("resolution: it must be at least 3, got " + std::to_string(resolution));
    preshape::require_size("columns of the wrenches", contacts.size() * 2, static_cast<std::size_t>(wrenches.cols()));
    require_contact_frames(contacts);
    Eigen::Index column = 0;
    for (const ContactFrame& C : contacts) {
      for (const double end : {-1.0, 1.0}) wrenches.col(column++) = push(C, end);
    }
  }

  bool admits(const ContactFrame& contact, const Wrench& F_C_O, double tolerance) const override {
    require_contact_frames({&contact, 1});
    if (!F_C_O.vector().allFinite()) throw InputError("wrench: its six components must be finite numbers");
    const ContactLineAxes axes = contact_line_axes(contact, across_);
    const double fn = F_C_O.force().dot(contact.n), mv = F_C_O.moment().dot(axes.v), missed = tolerance * fn;
    return fn >= 0.0 && (F_C_O.force() - fn * contact.n).norm() <= missed && std::abs(mv) <= half_length_ * fn + missed &&
           (F_C_O.moment() - mv * axes.v).norm() <= missed;
  }

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const preshape::ContactLimits*>(this) : nullptr;
  }

 private:
  /// A unit normal force at a share of the half length from the middle.
  Eigen::Matrix<double, 6, 1> push(const ContactFrame& C, double share) const {
    const ContactLineAxes axes = contact_line_axes(C, across_);
    return (Eigen::Matrix<double, 6, 1>() << C.n, -share * half_length_ * axes.v).finished();
  }

  double half_length_;
  bool across_;
  double press_;
};

}  // namespace

PRESHAPE_PLUGIN(({"frictionless_line", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Frictionless line contact"}),
                ({"contact/frictionless_line"}),
                preshape::component<FrictionlessLine>("frictionless_line",
                                        "Piece of line that only pushes along its normal, its cone included"))
