#include "preshape/contact/contact_plane.h"

#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

ContactPlaneAxes contact_plane_axes(const ContactFrame& contact) {
  Eigen::Vector3d y = contact.n.cross(contact.a);
  if (y.norm() < 1e-9) {
    Eigen::Index least;
    contact.n.cwiseAbs().minCoeff(&least);
    y = contact.n.cross(Eigen::Vector3d::Unit(least));
  }
  y.normalize();
  return {y.cross(contact.n), y};
}

ContactLineAxes contact_line_axes(const ContactFrame& contact, bool across) {
  const auto [x, y] = contact_plane_axes(contact);
  if (across) return {y, -x};
  return {x, y};
}

void require_contact_frames(std::span<const ContactFrame> contacts) {
  const auto unit = [](const Eigen::Vector3d& v) { return std::abs(v.norm() - 1.0) <= 1e-6; };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactFrame& C = contacts[i];
    if (unit(C.n) && unit(C.a) && C.p_OC.allFinite() && C.t.allFinite()) continue;
    throw InputError(fmt::format(
        "contact {}: its normal and approach axis must be unit vectors, its point and t finite numbers", i));
  }
}

}  // namespace preshape
