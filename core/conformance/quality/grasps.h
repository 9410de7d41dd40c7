#pragma once

#include <vector>

#include "../context.h"
#include "preshape/grasp/quality.h"
#include "suite_contact.h"

namespace preshape::conformance {

/// A virtual grasp with everything that a measure is shown, made by the suite's own formulas.
struct Grasp {
  std::vector<ContactFrame> contacts;
  std::vector<Wrench> F_C_O;
  WrenchUnion wrench_union;
  Wrench resultant;
  double length_m = 1.0;
  const ContactModel* contact_model = nullptr;
  Eigen::Vector3d approach_O = Eigen::Vector3d::UnitX(), opposition_O = Eigen::Vector3d::UnitY();
  GraspView view() const {
    return {contacts, F_C_O, wrench_union, resultant, length_m, contact_model, approach_O, opposition_O, {}};
  }
};

/// Unit wrenches n, two tangents and the moment about n, as far as transmitted; pattern wrenches of the thesis's
/// weights.
Grasp grasp_of(std::vector<ContactFrame> contacts, Transmits transmits, double length_m = 0.3);

/// Numbers of a grasp of that many contacts: points, normals, approach axis, and what is transmitted.
std::vector<Block> grasp_blocks(int contacts);
/// The contacts and what they transmit; too short directions stand along x.
struct GraspCase {
  std::vector<ContactFrame> contacts;
  Transmits transmits;
  Grasp grasp() const { return grasp_of(contacts, transmits); }
  /// Two contacts at one point, three on a line, or a normal along the approach axis, which leaves no tangents.
  bool degenerate() const;
};
GraspCase grasp_case(Case numbers, int contacts);

/// The measure's numbers, written over `before`.
std::vector<double> evaluated(const QualityMeasure& measure, const Grasp& grasp, double before = 0.0);

}  // namespace preshape::conformance
