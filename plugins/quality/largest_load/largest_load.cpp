#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "preshape/base/require.h"
#include "preshape/contact/grasp_wrench_space.h"
#include "preshape/contact/linear_program.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::GraspPrimitives;
using preshape::GraspView;
using preshape::JointAction;
using preshape::ParameterDeclaration;
using preshape::Wrench;

/// The normal force that a contact's joints are never asked beyond [N]: a finger that stands in line with the
/// load has no torque to stop it.
constexpr double kFirm = 1e6;

Wrench load_of(const preshape::Parameters& p) {
  const auto given = p.numbers("load");
  if (given.size() != 6) {
    throw preshape::InputError(
        "quality 'largest_load': load takes 6 numbers, three of force and three of moment, got " +
        std::to_string(given.size()));
  }
  const Wrench load = Wrench::from_vector(Eigen::Map<const preshape::WrenchVector>(given.data()));
  if (load.vector().norm() < 1e-9)
    throw preshape::InputError("quality 'largest_load': load is 0, which every grasp holds");
  return load;
}

bool limits_finger(const JointAction& joint) {
  return std::isfinite(joint.limit);
}

/// The torque on the joint of each primitive wrench of its contact [N m or N].
Eigen::RowVectorXd torques(const GraspView& grasp, const GraspPrimitives& primitives,
                           const JointAction& joint) {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(primitives.wrenches.cols());
  if (joint.contact < 0 || joint.contact >= std::ssize(grasp.contacts)) {
    throw preshape::InputError("quality 'largest_load': a joint acts at contact " +
                               std::to_string(joint.contact) + ", and the grasp has " +
                               std::to_string(grasp.contacts.size()));
  }
  const auto& contact = grasp.contacts[static_cast<std::size_t>(joint.contact)];
  preshape::WrenchVector V_O = joint.V_C_O.shifted(-contact.p_OC).vector();
  V_O.tail<3>() *= grasp.length_m;  // the wrenches' moments are over it
  const Eigen::Index first = joint.contact * primitives.per_contact;
  row.segment(first, primitives.per_contact) =
      V_O.transpose() * primitives.wrenches.middleCols(first, primitives.per_contact);
  return row;
}

/// A row for each contact's normal force, two for each joint whose limit is known.
void bound_forces(const GraspView& grasp, const GraspPrimitives& primitives, double finger_force,
                  preshape::EquilibriumProgram& programme) {
  const auto contacts = static_cast<Eigen::Index>(grasp.contacts.size());
  const auto joints = std::count_if(grasp.joints.begin(), grasp.joints.end(), limits_finger);
  programme.A.setZero(contacts + 2 * joints, programme.c.size());
  programme.b.setConstant(contacts + 2 * joints, finger_force);
  for (Eigen::Index i = 0; i < contacts; ++i) {
    programme.A.row(i).segment(i * primitives.per_contact, primitives.per_contact).setOnes();
  }
  Eigen::Index row = contacts;
  for (const JointAction& joint : grasp.joints) {
    if (!limits_finger(joint)) continue;
    const Eigen::RowVectorXd tau = torques(grasp, primitives, joint);
    programme.b[joint.contact] = kFirm;
    for (const double sign : {1.0, -1.0}) {
      programme.A.row(row).head(tau.size()) = sign * tau;
      programme.b[row++] = std::abs(joint.limit);
    }
  }
}

/// Equilibrium under a load with limited forces: the largest lambda such that forces within the contacts'
/// cones balance lambda times the load while no joint, or where no joint's limit is known no finger, is asked
/// for more than it has [KerrRoth1986]. By a linear programme over the coefficients of the primitive
/// wrenches.
class LargestLoad final : public preshape::QualityMeasure {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::list("load", {0, 0, -1, 0, 0, 0}, -1e6, 1e6, "N or N m",
                                       "external wrench on the object about O, in O: force, moment"),
            ParameterDeclaration::number("finger_force", 10.0, 1e-3, 1e5, "N",
                                         "most normal force of a contact where no joint's limit is known"),
            ParameterDeclaration::integer("resolution", 8, 3, 64, "1", "edges of a friction cone")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "permutation_invariant", "force_scale_invariant"};
  }

  explicit LargestLoad(const preshape::Parameters& p)
      : load_(load_of(p)),
        finger_force_(p.number("finger_force")),
        resolution_(static_cast<int>(p.integer("resolution"))) {
    const bool pure_moment = load_.force().norm() == 0.0;
    size_ = pure_moment ? load_.moment().norm() : load_.force().norm();
    numbers_ = {preshape::QualityNumber{"largest_load", pure_moment ? "N m" : "N", 0, kInfinity, true},
                preshape::QualityNumber{"equilibrium", "1", 0, 1, true}};
  }

  std::span<const preshape::QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    const GraspPrimitives primitives = preshape::grasp_primitives(
        grasp.contact_model, grasp.contacts, resolution_, grasp.length_m, "quality 'largest_load'");
    preshape::WrenchVector load = load_.vector() / size_;
    load.tail<3>() /= grasp.length_m;
    preshape::EquilibriumProgram programme;
    programme.E.resize(6, primitives.wrenches.cols() + 1);
    programme.E << primitives.wrenches, load;
    programme.c = Eigen::VectorXd::Unit(programme.E.cols(), programme.E.cols() - 1);
    bound_forces(grasp, primitives, finger_force_, programme);
    values[0] = std::max(0.0, preshape::maximise(programme).value);
    values[1] = values[0] >= size_ * (1.0 - 1e-9) ? 1.0 : 0.0;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Wrench load_;
  double finger_force_, size_ = 1.0;
  int resolution_;
  std::array<preshape::QualityNumber, 2> numbers_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"largest_load", "1.0.0", "BSD-3-Clause", "the preshape developers",
      "Equilibrium and the largest load under friction and joint torques"}),
    ({"quality/largest_load"}),
    preshape::component<LargestLoad>(
        "largest_load",
        "The largest load that friction and joint torques can hold, and equilibrium under a given one"))
