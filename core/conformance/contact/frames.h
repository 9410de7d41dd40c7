#pragma once

#include <optional>
#include <vector>

#include "../context.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/contact/contact_model.h"

namespace preshape::conformance {

/// Numbers of one contact frame: a point [m] and two directions, which are normalised.
constexpr int kFrameNumbers = 9;
std::vector<Block> frame_blocks();

/// The frame, or none where a direction is too short to be one. The approach axis may be parallel to the normal.
std::optional<ContactFrame> frame_of(Case nine);

/// The frame with its approach axis moved into the contact plane, or none where that is nearly parallel to the
/// normal.
std::optional<ContactFrame> square_frame_of(Case nine);

/// Four numbers as a rotation, by the quaternion of their direction; near zero: none.
Block rotation_block();
Eigen::Matrix3d rotation_of(Case four);
ContactFrame rotated(const Eigen::Matrix3d& R, const ContactFrame& contact);
/// The same wrenches, one a column, expressed in another frame.
WrenchBasis rotated(const Eigen::Matrix3d& R, const WrenchBasis& wrenches);

/// What a model gives for contacts; what it leaves out stays NaN.
WrenchBasis basis_of(const ContactModel& model, std::span<const ContactFrame> contacts);
/// The pattern wrenches, one a column.
WrenchBasis pattern_of(const ContactModel& model, std::span<const ContactFrame> contacts);
WrenchBasis edges_of(const ContactLimits& limits, std::span<const ContactFrame> contacts, int resolution);

/// The largest entry of a - b over the largest of both or 1; infinite where one is NaN.
double apart(const WrenchBasis& a, const WrenchBasis& b);

/// The vector's part outside the columns' span, as a share of its length; 0 of a zero vector.
double outside(const WrenchBasis& columns, const Eigen::Matrix<double, 6, 1>& vector);
/// Dimension of the columns' span; what is below `tolerance` of the longest column counts as zero.
int rank_of(const WrenchBasis& columns, double tolerance = 1e-8);

/// "(1 0 0 0 0 0.5)".
std::string wrench_text(const Eigen::Matrix<double, 6, 1>& wrench);

}  // namespace preshape::conformance
