#include <cmath>

#include "measured.h"
#include "preshape/base/error.h"
#include "preshape/contact/grasp_wrench_space.h"
#include "support/enumerated.h"
#include "support/qhull.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

Value loaded(const std::vector<double>& load, double finger_force = 10.0, int resolution = 8) {
  return Value::table({{"load", Value::numbers(load)}, {"finger_force", finger_force}, {"resolution", resolution}});
}

std::shared_ptr<ContactModel> rough(double mu) { return contact("hard_finger", Value::table({{"mu", mu}})); }

/// A joint at `pivot` that turns a fingertip about y.
JointAction hinge(int contact, const ContactFrame& tip, const Eigen::Vector3d& pivot, double limit) {
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  return {contact, Twist(y.cross(tip.p_OC - pivot), y), limit};
}

/// The largest load by Qhull: where its ray leaves the space of forces that each contact bounds.
double by_qhull(const MeasuredGrasp& grasp, const WrenchVector& load, int resolution) {
  const auto primitives = grasp_primitives(grasp.model.get(), grasp.contacts, resolution, grasp.length_m, "the test");
  const Hull hull = qhull(enumerated({primitives.wrenches, primitives.per_contact, ForceBound::kEach}));
  REQUIRE(hull.made);
  double factor = INFINITY;
  for (std::size_t i = 0; i < hull.normals.size(); ++i) {
    const double along = -load.dot(hull.normals[i]), offset = std::max(0.0, hull.offsets[i]);
    if (along > 1e-9) factor = std::min(factor, (offset < 1e-12 ? 0.0 : offset) / along);
  }
  return factor;
}

}  // namespace

TEST_CASE("Largest load: two opposed fingers hold the weight 2 mu F by friction, and are in equilibrium up to it") {
  for (const double mu : {0.2, 1.0}) {
    const MeasuredGrasp grasp = {opposed_contacts(0.03), rough(mu), 0.1};
    CHECK_NEAR(measured("largest_load", loaded({0, 0, -1, 0, 0, 0}, 5.0), grasp)[0], 2 * mu * 5.0, 1e-12);
    for (const double share : {0.99, 1.01}) {
      const auto values = measured("largest_load", loaded({0, 0, -share * 2 * mu * 5.0, 0, 0, 0}, 5.0), grasp);
      CHECK_NEAR(values[0], 2 * mu * 5.0, 1e-12);
      CHECK(values[1] == (share < 1.0 ? 1.0 : 0.0));
    }
  }
}

TEST_CASE("Largest load: along their line one finger alone pushes with F, and a moment about z is held by 2 mu F r") {
  const MeasuredGrasp grasp = {opposed_contacts(0.03), rough(0.5), 0.1};
  CHECK_NEAR(measured("largest_load", loaded({-3, 0, 0, 0, 0, 0}), grasp)[0], 10.0, 1e-12);
  CHECK_NEAR(measured("largest_load", loaded({0, 0, 0, 0, 0, 1}), grasp)[0], 2 * 0.5 * 10.0 * 0.03, 1e-13);  // [N m]
  CHECK(measured("largest_load", loaded({0, 0, 0, 1, 0, 0}), grasp)[0] == 0.0);  // nothing turns about their line
  CHECK_NEAR(measured("largest_load", {opposed_contacts(0.03), contact("frictionless_point")})[0], 0.0, 1e-12);
}

TEST_CASE("Largest load: a weight that hangs off the fingers' line needs friction for its moment") {
  // The load at x = b about O adds the moment b about y: with mu (N1 + N2) upwards, mu (N1 - N2) r turns against it, so
  // for N1 = F the other gives s = (r - b) / (r + b) of it.
  const double r = 0.03, b = 0.01;
  const auto values = measured("largest_load", loaded({0, 0, -1, 0, b, 0}), {opposed_contacts(r), rough(0.5), 0.1});
  CHECK_NEAR(values[0], 0.5 * 10.0 * (1.0 + (r - b) / (r + b)), 1e-12);
}

TEST_CASE("Largest load: two planar two-link fingers hold 2 mu T / (height + mu reach) of the joint that tires first") {
  // Each finger stands beside the object; a joint `reach` out and `height` above its tip must balance the normal force N
  // times height plus mu N times reach.
  const double mu = 0.5;
  for (const auto& [base_torque, middle_torque] : {std::pair{0.4, 0.9}, {0.9, 0.1}}) {
    const auto contacts = opposed_contacts(0.03);
    MeasuredGrasp grasp = {contacts, rough(mu), 0.1};
    for (int i = 0; i < 2; ++i) {
      const double out = i == 0 ? -1.0 : 1.0;
      grasp.joints.push_back(hinge(i, contacts[i], contacts[i].p_OC + Eigen::Vector3d(out * 0.04, 0, 0.09), base_torque));
      grasp.joints.push_back(hinge(i, contacts[i], contacts[i].p_OC + Eigen::Vector3d(out * 0.02, 0, 0.05), middle_torque));
      grasp.joints.push_back({i, Twist({0, 5, 0}, {0, 0, 0}), NAN});  // not known, and not to be looked at
    }
    // The weight pulls the tips down, the grip pushes them out; both turn the joint alike.
    const double N = std::min(base_torque / (0.09 + mu * 0.04), middle_torque / (0.05 + mu * 0.02));
    CHECK_NEAR(measured("largest_load", loaded({0, 0, -1, 0, 0, 0}, 1e-3), grasp)[0], 2 * mu * N, 1e-11);
  }
}

TEST_CASE("Largest load: a prismatic joint's force is a normal force, and a contact that has no joint keeps the finger force") {
  MeasuredGrasp grasp = {opposed_contacts(0.03), rough(0.5), 0.1};
  grasp.joints = {{0, Twist({1, 0, 0}, {0, 0, 0}), 4.0}};
  CHECK_NEAR(measured("largest_load", loaded({0, 0, -1, 0, 0, 0}, 10.0), grasp)[0], 2 * 0.5 * 4.0, 1e-12);
  CHECK_NEAR(measured("largest_load", loaded({0, 0, -1, 0, 0, 0}, 3.0), grasp)[0], 2 * 0.5 * 3.0, 1e-12);
  grasp.joints = {{7, Twist({1, 0, 0}, {0, 0, 0}), 4.0}};
  CHECK_THROWS_SAYING(measured("largest_load", grasp), InputError, "a joint acts at contact 7, and the grasp has 2");
}

TEST_CASE("Largest load: on random grasps of soft fingers it is where the load's ray leaves Qhull's hull of all forces") {
  Random random(1);
  int held = 0;
  for (int i = 0; i < 40; ++i) {
    const MeasuredGrasp grasp = {random_contacts(random, 2 + i % 2, 0.1),
                                 contact("soft_finger_elliptic", Value::table({{"mu", 0.9}, {"radius", 0.3}})), 0.1};
    const Wrench load = random_wrench(random);
    WrenchVector metric = load.vector() / load.force().norm();
    const double expected = by_qhull(grasp, metric, 3);
    metric.tail<3>() *= 0.1;
    const auto values = measured("largest_load", loaded({metric.data(), metric.data() + 6}, 2.0, 3), grasp);
    CHECK_NEAR(values[0], 2.0 * expected, 1e-9);
    held += values[0] > 1e-6;
  }
  CHECK(held > 5);
}

TEST_CASE("Largest load: of symmetric rings of soft fingers, whole and disturbed a little, it is Qhull's too") {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const int count = 2 + i % 2;
    const double off = i < 4 ? 0.0 : std::pow(10.0, -4.0 - i / 4);
    std::vector<ContactFrame> contacts;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0.0);
      contacts.push_back(ContactFrame::at(p + off * random_vector(random), -p, Eigen::Vector3d::UnitZ()));
    }
    const MeasuredGrasp grasp = {contacts, contact("soft_finger_elliptic", Value::table({{"mu", 0.6}, {"radius", 0.3}}))};
    WrenchVector load = random_wrench(random).vector();
    load /= load.head<3>().norm();
    const auto values = measured("largest_load", loaded({load.data(), load.data() + 6}, 1.0, 4), grasp);
    // Qhull merges facets that differ by little and moves them by up to some 1e-8.
    CHECK_NEAR(values[0], by_qhull(grasp, load, 4), 1e-6);
    CHECK(values[0] > 1e-3);
  }
}

TEST_CASE("Largest load: a load of no size, of five numbers, and a model without limits are refused") {
  CHECK_THROWS_SAYING(measured("largest_load", loaded({0, 0, 0, 0, 0, 0}), {opposed_contacts(0.1)}), InputError, "load is 0");
  CHECK_THROWS_SAYING(measured("largest_load", loaded({0, 0, 0, 0, 1}), {opposed_contacts(0.1)}), InputError,
                      "load takes 6 numbers, three of force and three of moment, got 5");
  CHECK_THROWS_SAYING(measured("largest_load", {opposed_contacts(0.1), contact("salisbury_soft_finger")}), InputError,
                      "quality 'largest_load': the contact model does not say what a contact can bear; choose one");
}

TEST_SUITE_END();
