#include "frames.h"

#include <cmath>
#include <limits>

#include "preshape/base/value.h"

namespace preshape::conformance {

namespace {

constexpr double kShortest = 1e-3;  // direction that is normalised

std::optional<Eigen::Vector3d> direction_of(Case three) {
  const Eigen::Vector3d v(three[0], three[1], three[2]);
  if (v.norm() < kShortest) return std::nullopt;
  return v.normalized();
}

/// An orthonormal basis of the columns' span: Gram-Schmidt, the longest that is left first.
std::vector<Eigen::Matrix<double, 6, 1>> orthonormal(WrenchBasis columns, double tolerance) {
  std::vector<Eigen::Matrix<double, 6, 1>> axes;
  const double smallest = columns.cols() ? tolerance * columns.colwise().norm().maxCoeff() : 0.0;
  while (columns.cols() > 0 && axes.size() < 6) {
    Eigen::Index longest = 0;
    const double length = columns.colwise().norm().maxCoeff(&longest);
    if (!(length > smallest)) break;
    const Eigen::Matrix<double, 6, 1> axis = columns.col(longest) / length;
    axes.push_back(axis);
    // Twice, so that what rounding left of the first pass goes too.
    for (int pass = 0; pass < 2; ++pass) columns -= axis * (axis.transpose() * columns).eval();
  }
  return axes;
}

}  // namespace

std::vector<Block> frame_blocks() {
  return {{"point", 3, -1.0, 1.0},
          {"normal", 3, -1.0, 1.0, {-1.0, 0.0, 1.0}},
          {"approach", 3, -1.0, 1.0, {-1.0, 0.0, 1.0}}};
}

std::optional<ContactFrame> frame_of(Case nine) {
  const auto n = direction_of(nine.subspan(3, 3)), a = direction_of(nine.subspan(6, 3));
  if (!n || !a) return std::nullopt;
  return ContactFrame::at({nine[0], nine[1], nine[2]}, *n, *a);
}

std::optional<ContactFrame> square_frame_of(Case nine) {
  const auto frame = frame_of(nine);
  if (!frame || frame->t.norm() < 0.1) return std::nullopt;
  return ContactFrame::at(frame->p_OC, frame->n, frame->t.cross(frame->n).normalized());
}

Block rotation_block() { return {"rotation", 4, -1.0, 1.0, {-1.0, 0.0, 1.0}}; }

Eigen::Matrix3d rotation_of(Case four) {
  const Eigen::Quaterniond q(four[0], four[1], four[2], four[3]);
  return q.norm() < kShortest ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : q.normalized().toRotationMatrix();
}

ContactFrame rotated(const Eigen::Matrix3d& R, const ContactFrame& contact) {
  return {R * contact.p_OC, R * contact.n, R * contact.a, R * contact.t};
}

WrenchBasis rotated(const Eigen::Matrix3d& R, const WrenchBasis& wrenches) {
  WrenchBasis turned(6, wrenches.cols());
  turned.topRows<3>() = R * wrenches.topRows<3>();
  turned.bottomRows<3>() = R * wrenches.bottomRows<3>();
  return turned;
}

WrenchBasis basis_of(const ContactModel& model, std::span<const ContactFrame> contacts) {
  const auto columns = static_cast<Eigen::Index>(contacts.size()) * model.basis_size();
  WrenchBasis basis = WrenchBasis::Constant(6, columns, std::numeric_limits<double>::quiet_NaN());
  model.wrench_basis(contacts, basis);
  return basis;
}

WrenchBasis pattern_of(const ContactModel& model, std::span<const ContactFrame> contacts) {
  const Eigen::Vector3d unset = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<Wrench> wrenches(contacts.size(), Wrench(unset, unset));
  model.pattern_wrenches(contacts, wrenches);
  WrenchBasis pattern(6, static_cast<Eigen::Index>(wrenches.size()));
  for (std::size_t i = 0; i < wrenches.size(); ++i) pattern.col(static_cast<Eigen::Index>(i)) = wrenches[i].vector();
  return pattern;
}

WrenchBasis edges_of(const ContactLimits& limits, std::span<const ContactFrame> contacts, int resolution) {
  const auto columns = static_cast<Eigen::Index>(contacts.size()) * limits.primitive_count(resolution);
  WrenchBasis edges = WrenchBasis::Constant(6, columns, std::numeric_limits<double>::quiet_NaN());
  limits.primitive_wrenches(contacts, resolution, edges);
  return edges;
}

double apart(const WrenchBasis& a, const WrenchBasis& b) {
  if (a.cols() != b.cols() || !a.allFinite() || !b.allFinite()) return std::numeric_limits<double>::infinity();
  if (a.cols() == 0) return 0.0;
  return (a - b).cwiseAbs().maxCoeff() / std::max({1.0, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
}

double outside(const WrenchBasis& columns, const Eigen::Matrix<double, 6, 1>& vector) {
  if (vector.norm() == 0.0) return 0.0;
  Eigen::Matrix<double, 6, 1> left = vector / vector.norm();
  for (const auto& axis : orthonormal(columns, 1e-12)) left -= axis * axis.dot(left);
  return left.norm();
}

int rank_of(const WrenchBasis& columns, double tolerance) {
  return static_cast<int>(orthonormal(columns, tolerance).size());
}

std::string wrench_text(const Eigen::Matrix<double, 6, 1>& wrench) {
  std::string text = "(";
  for (int i = 0; i < 6; ++i) text += (i ? " " : "") + number_text(wrench[i]);
  return text + ")";
}

}  // namespace preshape::conformance
