#include "preshape/contact/grasp_wrench_space.h"

#include "preshape/base/error.h"
#include "preshape/contact/contact_limits.h"
#include "support/cones.h"
#include "support/near.h"
#include "support/enumerated.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/contact");

namespace {

WrenchVector random_direction(Random& random) {
  WrenchVector u;
  for (double& x : u) x = random.normal();
  return u.normalized();
}

/// A contact that says nothing of what it bears.
class Mute final : public ContactModel {
 public:
  int basis_size() const noexcept override { return 1; }
  void wrench_basis(std::span<const ContactFrame>, Eigen::Ref<WrenchBasis>) const override {}
  void pattern_wrenches(std::span<const ContactFrame>, std::span<Wrench>) const override {}
};

}  // namespace

TEST_CASE("Grasp wrench space: its support is that of the enumerated points, under either bound") {
  Random random(1);
  for (const ForceBound bound : {ForceBound::kSum, ForceBound::kEach}) {
    for (int i = 0; i < 50; ++i) {
      const auto space = wrench_space(random_grasp(random, 3, 0.5, 0.2), 5, bound);
      const WrenchBasis points = enumerated(space);
      const WrenchVector u = random_direction(random);
      CHECK_NEAR(u.dot(space.support(u)), (u.transpose() * points).maxCoeff(), 20 * kEps);
      CHECK(points.colwise().norm().maxCoeff() <= space.radius() * (1 + 10 * kEps));
    }
  }
}

TEST_CASE("Grasp wrench space: where every contact pulls back, no force is the farthest") {
  const GraspWrenchSpace space(WrenchBasis::Identity(6, 6), 2, ForceBound::kEach);
  CHECK(space.support(-WrenchVector::Ones()) == WrenchVector::Zero());
  CHECK(space.support(WrenchVector(3, 1, 0, 0, -1, -2)) == WrenchVector(1, 0, 0, 0, 0, 0));
}

TEST_CASE("Grasp wrench space: wrenches that are not finite and models that say nothing of limits are refused") {
  WrenchBasis wrenches = WrenchBasis::Identity(6, 6);
  wrenches(2, 3) = NAN;
  CHECK_THROWS_SAYING(GraspWrenchSpace(wrenches, 1, ForceBound::kSum), InputError, "a primitive wrench is not finite");
  const ContactFrame contact = ContactFrame::at({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  CHECK_THROWS_SAYING(grasp_primitives(nullptr, {&contact, 1}, 8, 1.0, "quality 'x'"), InputError,
                      "quality 'x': the grasp's contact model is not known; choose one");
  const Mute mute;
  CHECK_THROWS_SAYING(grasp_primitives(&mute, {&contact, 1}, 8, 1.0, "quality 'x'"), InputError,
                      "quality 'x': the contact model does not say what a contact can bear; choose one that has limits");
}

TEST_SUITE_END();
