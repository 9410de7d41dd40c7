#pragma once

#include <span>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/contact/contact_frame.h"

namespace preshape {

/// Unit axes of the contact plane in O: x along the approach axis' part in it, y = n x x.
struct ContactPlaneAxes {
  Eigen::Vector3d x, y;
};

/// They turn with the contact, unless the approach axis runs along the normal: then any pair does.
/// @param contact with unit n and a
PRESHAPE_API ContactPlaneAxes contact_plane_axes(const ContactFrame& contact);

/// Unit axes of a line contact in O: u along the line, v = n x u.
struct ContactLineAxes {
  Eigen::Vector3d u, v;
};

/// @param across the line lies along t = n x a, not along the approach axis' part in the contact plane
PRESHAPE_API ContactLineAxes contact_line_axes(const ContactFrame& contact, bool across);

/// The check that a contact model makes of what it is asked.
/// @throws InputError, naming the contact, unless n and a are unit vectors (1e-6) and all else is finite
PRESHAPE_API void require_contact_frames(std::span<const ContactFrame> contacts);

}  // namespace preshape
