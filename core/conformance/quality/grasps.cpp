#include "grasps.h"

namespace preshape::conformance {

namespace {

constexpr double kApart = 1e-2;  // share of the box that points are drawn from

Eigen::Vector3d direction(Case three) {
  const Eigen::Vector3d v(three[0], three[1], three[2]);
  return v.norm() < 1e-3 ? Eigen::Vector3d(Eigen::Vector3d::UnitX()) : v.normalized();
}

/// Force and moment about the contact, about O as a row.
Eigen::Matrix<double, 1, 6> row(const Eigen::Vector3d& force, const Eigen::Vector3d& moment, const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 1, 6> row;
  row << force.transpose(), (moment + p.cross(force)).transpose();
  return row;
}

}  // namespace

Grasp grasp_of(std::vector<ContactFrame> contacts, Transmits transmits, double length_m) {
  const SuiteContact& model = suite_contact(transmits);
  const auto each = static_cast<Eigen::Index>(transmits);
  Grasp grasp{std::move(contacts), {}, {}, {}, length_m, &model};
  WrenchBasis basis(6, std::ssize(grasp.contacts) * each);
  model.wrench_basis(grasp.contacts, basis);
  grasp.F_C_O.resize(grasp.contacts.size());
  model.pattern_wrenches(grasp.contacts, grasp.F_C_O);
  grasp.wrench_union.resize(basis.cols(), 6);
  Eigen::Matrix<double, 1, 6> sum = Eigen::Matrix<double, 1, 6>::Zero();
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const Eigen::Vector3d p = grasp.contacts[i].p_OC / length_m;
    for (Eigen::Index k = static_cast<Eigen::Index>(i) * each; k < static_cast<Eigen::Index>(i + 1) * each; ++k) {
      grasp.wrench_union.row(k) = row(basis.col(k).head<3>(), basis.col(k).tail<3>(), p);
    }
    sum += row(grasp.F_C_O[i].force(), grasp.F_C_O[i].moment(), p);
  }
  grasp.resultant = Wrench::from_vector(sum.transpose());
  if (grasp.contacts.empty()) return grasp;
  grasp.approach_O = grasp.contacts.front().a;
  const Eigen::Vector3d across = grasp.approach_O.cross(grasp.contacts.front().n).cross(grasp.approach_O);
  grasp.opposition_O = across.norm() < 1e-3 ? grasp.approach_O.unitOrthogonal() : (-across).normalized();
  return grasp;
}

std::vector<Block> grasp_blocks(int contacts) {
  return {{"points", 3 * contacts, -1.0, 1.0},
          {"normals", 3 * contacts, -1.0, 1.0, {-1.0, 0.0, 1.0}},
          {"approach", 3, -1.0, 1.0, {-1.0, 0.0, 1.0}},
          {"transmits", 1, 0.0, 2.0, {}, true}};
}

GraspCase grasp_case(Case numbers, int contacts) {
  constexpr Transmits kAll[] = {Transmits::kNormal, Transmits::kForce, Transmits::kForceAndSpin};
  const auto count = static_cast<std::size_t>(contacts);
  const Eigen::Vector3d a = direction(numbers.subspan(6 * count, 3));
  GraspCase made{{}, kAll[static_cast<std::size_t>(numbers[6 * count + 3])]};
  for (std::size_t i = 0; i < count; ++i) {
    const Case p = numbers.subspan(3 * i, 3);
    made.contacts.push_back(ContactFrame::at({p[0], p[1], p[2]}, direction(numbers.subspan(3 * (count + i), 3)), a));
  }
  return made;
}

bool GraspCase::degenerate() const {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].t.norm() < kApart) return true;
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3d edge = contacts[i].p_OC - contacts[j].p_OC;
      if (edge.norm() < kApart) return true;
      for (std::size_t k = 0; k < j; ++k) {
        if (edge.cross(contacts[k].p_OC - contacts[j].p_OC).norm() < kApart * kApart) return true;
      }
    }
  }
  return false;
}

std::vector<double> evaluated(const QualityMeasure& measure, const Grasp& grasp, double before) {
  std::vector<double> values(measure.numbers().size(), before);
  measure.evaluate(grasp.view(), values);
  return values;
}

}  // namespace preshape::conformance
