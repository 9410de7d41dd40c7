#include "preshape/contact/wrench_union.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

namespace {

std::vector<ContactFrame> random_contacts(Random& random, int count) {
  std::vector<ContactFrame> contacts;
  const Eigen::Vector3d a = random_unit(random);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = random_vector(random);
    contacts.push_back(ContactFrame::at(p, random_unit(random), a));
  }
  return contacts;
}

Wrench resultant(const ContactModel& model, const std::vector<ContactFrame>& contacts, double length_m) {
  std::vector<Wrench> wrenches(contacts.size());
  model.pattern_wrenches(contacts, wrenches);
  return resultant_wrench(contacts, wrenches, length_m);
}

}  // namespace

TEST_CASE("Soft finger: the force is Ka a + Kn n + Ko t and the moment Mn n") {
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  const auto C = ContactFrame::at({0, 0, 0}, {0, 1, 0}, {1, 0, 0});  // t = y x x = -z
  std::vector<Wrench> W(1);
  model->pattern_wrenches({&C, 1}, W);
  CHECK_NEAR(W[0].force(), Eigen::Vector3d(0.45, 1.0, -0.25), 0);
  CHECK_NEAR(W[0].moment(), Eigen::Vector3d(0, 0.8, 0), 0);
}

TEST_CASE("Soft finger: turning the contacts turns the resultant wrench with them") {
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    auto contacts = random_contacts(random, 4);
    const Wrench before = resultant(*model, contacts, 0.2);
    const Eigen::Matrix3d R = random_rotation(random);
    for (auto& C : contacts) C = ContactFrame::at(R * C.p_OC, R * C.n, R * C.a);
    CHECK_NEAR(resultant(*model, contacts, 0.2).vector(), before.rotated(R).vector(), 200 * kEps);
  }
}

TEST_CASE("Soft finger: scaling the scene and the characteristic length together changes nothing") {
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  Random random(4);
  auto contacts = random_contacts(random, 3);
  const auto W = resultant(*model, contacts, 0.18);
  const auto WU = wrench_union(*model, contacts, 0.18);
  for (auto& C : contacts) C.p_OC *= 1000.0;
  CHECK_NEAR(resultant(*model, contacts, 180.0).vector(), W.vector(), 64 * kEps * 10);
  CHECK_NEAR(wrench_union(*model, contacts, 180.0), WU, 64 * kEps * 10);
}

TEST_CASE("Soft finger: the union has four rows a contact and the pattern lies in its span") {
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  Random random(5);
  const auto contacts = random_contacts(random, 1);
  const auto WU = wrench_union(*model, contacts, 1.0);
  REQUIRE(WU.rows() == 4);
  std::vector<Wrench> W(1);
  model->pattern_wrenches(contacts, W);
  const Eigen::Vector4d weights(0.45, 0.25, 1.0, 0.8);  // rows a, t, n, moment
  CHECK_NEAR(Eigen::VectorXd(WU.transpose() * weights), Eigen::VectorXd(resultant(*model, contacts, 1.0).vector()), 32 * kEps);
}

TEST_CASE("Soft finger: with the approach projected, no force of it pushes along the normal") {
  const auto model = registry().create<ContactModel>(
      "salisbury_soft_finger", Value::table({{"project_approach", true}, {"kn", 0.0}, {"ko", 0.0}, {"mn", 0.0}}));
  Random random(6);
  const auto contacts = random_contacts(random, 5);
  std::vector<Wrench> W(5);
  model->pattern_wrenches(contacts, W);
  for (std::size_t i = 0; i < 5; ++i) CHECK_NEAR(W[i].force().dot(contacts[i].n), 0.0, 8 * kEps);
}

TEST_SUITE_END();
