#pragma once

#include <memory>
#include <numbers>
#include <vector>

#include "preshape/grasp/quality.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

namespace preshape::test {

/// A grasp by contacts under a contact model, with what a measure is shown of it.
struct MeasuredGrasp {
  std::vector<ContactFrame> contacts;
  std::shared_ptr<ContactModel> model = registry().create<ContactModel>("hard_finger", Value::table({}));
  double length_m = 1.0;
  std::vector<JointAction> joints = {};
  Eigen::Vector3d approach_O = Eigen::Vector3d::UnitX(), opposition_O = Eigen::Vector3d::UnitY();
};

inline std::shared_ptr<ContactModel> contact(const char* name, const Value& parameters = Value::table({})) {
  return registry().create<ContactModel>(name, parameters);
}

/// The numbers of a measure of that name and parameters.
inline std::vector<double> measured(const char* name, const Value& parameters, const MeasuredGrasp& grasp) {
  const auto measure = registry().create<QualityMeasure>(name, parameters);
  std::vector<double> values(measure->numbers().size());
  // None of these measures looks at the pattern wrenches, their union or their sum.
  static const WrenchUnion wrenches = WrenchUnion::Constant(1, 6, NAN);
  static const Wrench resultant(Eigen::Vector3d::Constant(NAN), Eigen::Vector3d::Constant(NAN));
  measure->evaluate({grasp.contacts, {}, wrenches, resultant, grasp.length_m, grasp.model.get(), grasp.approach_O,
                     grasp.opposition_O, grasp.joints},
                    values);
  return values;
}
inline std::vector<double> measured(const char* name, const MeasuredGrasp& grasp) {
  return measured(name, Value::table({}), grasp);
}

/// Two contacts at (-+r, 0, 0) that press on each other, the hand coming along z.
inline std::vector<ContactFrame> opposed_contacts(double r) {
  return {ContactFrame::at({-r, 0, 0}, {1, 0, 0}, {0, 0, 1}), ContactFrame::at({r, 0, 0}, {-1, 0, 0}, {0, 0, 1})};
}

/// A cube of half edge L with twelve contacts: on the faces across x two that are d L off along y, so that they turn about
/// z without friction, and so on round the axes.
inline std::vector<ContactFrame> pushed_cube(double d, double L) {
  std::vector<ContactFrame> contacts;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      for (const double off : {d, -d}) {
        Eigen::Vector3d p = side * Eigen::Vector3d::Unit(axis);
        const Eigen::Vector3d n = -p;
        p[(axis + 1) % 3] = off;
        contacts.push_back(ContactFrame::at(L * p, n, Eigen::Vector3d::Unit((axis + 2) % 3)));
      }
    }
  }
  return contacts;
}

/// Contacts on a sphere about O whose normals point inwards but for a tilt.
inline std::vector<ContactFrame> random_contacts(Random& random, int count, double radius = 1.0) {
  std::vector<ContactFrame> contacts;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = random_unit(random);
    contacts.push_back(ContactFrame::at(radius * p, (-p + 0.4 * random_vector(random)).normalized(), random_unit(random)));
  }
  return contacts;
}

}  // namespace preshape::test
