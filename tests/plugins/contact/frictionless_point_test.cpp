#include "contact_samples.h"
#include "preshape/base/error.h"
#include "preshape/contact/wrench_union.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

TEST_CASE("Frictionless point: basis, pattern and edge are the unit normal force, whatever the approach") {
  const auto model = contact_model("frictionless_point");
  Random random(21);
  for (int i = 0; i < 20; ++i) {
    const ContactFrame C = random_contact(random);
    const Vector6 push = (Vector6() << C.n, 0, 0, 0).finished();
    CHECK_NEAR(basis_of(*model, C), push, 0);
    CHECK_NEAR(pattern_of(*model, C).vector(), push, 0);
    CHECK_NEAR(edges_of(*model, C, 8), push, 0);
  }
}

TEST_CASE("Frictionless point: it bears pushes along the normal alone") {
  const auto model = contact_model("frictionless_point");
  CHECK(admits(*model, plain_contact(), wrench(0, 0, 7, 0, 0, 0)));
  CHECK(admits(*model, plain_contact(), wrench(0, 0, 0, 0, 0, 0)));
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, -1, 0, 0, 0)));
  CHECK(!contact_limits(*model)->admits(plain_contact(), Wrench({0, 0, -1}, {0, 0, 0}), 0.0));
  CHECK(!admits(*model, plain_contact(), wrench(1e-6, 0, 1, 0, 0, 0)));
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, 1, 1e-6, 0, 0)));
}

TEST_CASE("Frictionless point: on a ball any number of contacts has rank three, for all normals meet in its centre") {
  const auto model = contact_model("frictionless_point");
  Random random(22);
  std::vector<ContactFrame> contacts;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d n = random_unit(random);
    contacts.push_back(ContactFrame::at(-0.05 * n, n, random_unit(random)));
  }
  const WrenchUnion WU = wrench_union(*model, contacts, 0.1);
  CHECK(WU.rows() == 8);
  CHECK(Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(WU).rank() == 3);
}

TEST_CASE("Frictionless point: a normal that is not unit is refused, and so is a resolution below three") {
  const auto model = contact_model("frictionless_point");
  CHECK_THROWS_SAYING(pattern_of(*model, ContactFrame::at({0, 0, 0}, {0, 0, 0}, {1, 0, 0})), InputError,
                      "contact 0: its normal must be a unit vector");
  CHECK_THROWS_SAYING(edges_of(*model, plain_contact(), 2), InputError, "at least 3, got 2");
}

TEST_SUITE_END();
