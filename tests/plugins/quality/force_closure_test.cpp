#include "measured.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

Value four_edges() { return Value::table({{"resolution", 4}}); }

}  // namespace

TEST_CASE("Force closure: two opposed soft fingers close whatever their friction, two opposed hard ones do not") {
  for (const double mu : {0.05, 0.5, 2.0}) {
    const Value friction = Value::table({{"mu", mu}});
    const auto soft = measured("force_closure", {opposed_contacts(0.5), contact("soft_finger_elliptic", friction)});
    CHECK(soft[0] == 1.0);
    CHECK_NEAR(soft[1], 1.0, 1e-12);  // all their wrenches added up are 0
    CHECK(measured("force_closure", {opposed_contacts(0.5), contact("hard_finger", friction)}) == std::vector<double>{0.0, 0.0});
  }
}

TEST_CASE("Force closure: it ends where two fingers' line leaves a friction cone (Nguyen)") {
  // A second normal turned by an angle; four edges in the plane of the turn and across it.
  const double mu = 0.5;
  for (const double share : {0.5, 0.99, 1.01, 1.5}) {
    const double angle = share * std::atan(mu);
    auto contacts = opposed_contacts(0.5);
    contacts[1] = ContactFrame::at(contacts[1].p_OC, {-std::cos(angle), 0, std::sin(angle)}, {0, 0, 1});
    const MeasuredGrasp grasp = {contacts, contact("soft_finger_elliptic", Value::table({{"mu", mu}}))};
    CHECK(measured("force_closure", four_edges(), grasp)[0] == (share < 1.0 ? 1.0 : 0.0));
  }
}

TEST_CASE("Force closure: its margin is 1 when all wrenches push alike, and 13/14 when one of thirteen stands twice") {
  // The four wrenches (+-1, +-d) of a pair of faces balance when those across are alike. Doubling one doubles what the one
  // across must give: 2 t beside t for each of the other twelve.
  auto contacts = pushed_cube(0.5, 1.0);
  CHECK_NEAR(measured("force_closure", {contacts, contact("frictionless_point")})[1], 1.0, 1e-12);
  contacts.push_back(contacts[4]);
  CHECK_NEAR(measured("force_closure", {contacts, contact("frictionless_point")})[1], 13.0 / 14, 1e-12);
  contacts.resize(11);  // the last pair of faces lacks one of its four
  CHECK(measured("force_closure", {contacts, contact("frictionless_point")})[0] == 0.0);
}

TEST_CASE("Force closure: the programme and the lazy hull agree on thousands of random grasps") {
  Random random(1);
  int closed = 0, open = 0, near = 0;
  for (int i = 0; i < 4000; ++i) {
    const int count = 1 + i % 5;
    const double mu = random.uniform(0.2, 1.0);
    const MeasuredGrasp grasp = {random_contacts(random, count),
                                 contact(i % 2 ? "soft_finger_elliptic" : "hard_finger", Value::table({{"mu", mu}}))};
    const auto closure = measured("force_closure", grasp);
    const double epsilon = measured("ferrari_canny", grasp)[0];
    // A grasp within 1e-7 of the edge is for neither to decide.
    if ((epsilon > 0.0 && epsilon < 1e-7) || (closure[1] > 0.0 && closure[1] < 1e-6)) {
      ++near;
      continue;
    }
    CHECK((closure[0] == 1.0) == (epsilon > 0.0));
    ++(closure[0] == 1.0 ? closed : open);
  }
  MESSAGE(closed, " grasps closed, ", open, " not, ", near, " left out");
  CHECK(closed > 800);
  CHECK(open > 800);
  CHECK(near < 20);
}

TEST_CASE("Force closure: they agree on symmetric rings of contacts, whole and disturbed a little") {
  Random random(2);
  for (int i = 0; i < 400; ++i) {
    std::vector<ContactFrame> contacts;
    const int count = 2 + i % 4;
    const double off = std::pow(10.0, -1.0 - i % 13) * (i % 3 > 0);
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0.0);
      contacts.push_back(ContactFrame::at(p + off * random_vector(random), -p, Eigen::Vector3d::UnitZ()));
    }
    const MeasuredGrasp grasp = {contacts, contact(count == 2 ? "soft_finger_elliptic" : "hard_finger")};
    const auto closure = measured("force_closure", grasp);
    const double epsilon = measured("ferrari_canny", grasp)[0];
    INFO(count, " contacts, off by ", off, ": margin ", closure[1], ", epsilon ", epsilon);
    CHECK((closure[0] == 1.0) == (epsilon > 0.0));
  }
}

TEST_CASE("Force closure: a model without limits is refused with the mend") {
  CHECK_THROWS_SAYING(measured("force_closure", {opposed_contacts(0.1), contact("salisbury_soft_finger")}), InputError,
                      "quality 'force_closure': the contact model does not say what a contact can bear; choose one");
}

TEST_SUITE_END();
