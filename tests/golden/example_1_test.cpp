#include "preshape/contact/wrench_union.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("golden");

TEST_CASE("Example 1 of section 3.6: four unit contacts of a rectangle add up to the printed wrench") {
  const std::vector<Eigen::Vector3d> p_OC = {
      {-0.538, 1.423, 0.712}, {0.538, 1.423, 0.712}, {0.538, 1.423, -0.288}, {0.538, 1.423, -1.288}};
  std::vector<ContactFrame> contacts(4);
  std::vector<Wrench> F_C;
  std::vector<Wrench> W_O;
  for (std::size_t i = 0; i < 4; ++i) {
    contacts[i].p_OC = p_OC[i];
    const double side = i == 0 ? -1.0 : 1.0;
    F_C.emplace_back(Eigen::Vector3d(side, 1, 1), Eigen::Vector3d(side, 0, 0));
    W_O.push_back(F_C.back().shifted(-p_OC[i]));
  }
  using Six = Eigen::Matrix<double, 6, 1>;
  // Printed to three digits.
  CHECK_NEAR(W_O[0].vector(), (Six() << -1, 1, 1, -0.289, -0.174, 0.885).finished(), 1e-9);
  CHECK_NEAR(W_O[1].vector(), (Six() << 1, 1, 1, 1.711, 0.174, -0.885).finished(), 1e-9);
  CHECK_NEAR(W_O[2].vector(), (Six() << 1, 1, 1, 2.711, -0.826, -0.885).finished(), 1e-9);
  CHECK_NEAR(W_O[3].vector(), (Six() << 1, 1, 1, 3.711, -1.826, -0.885).finished(), 1e-9);
  CHECK_NEAR(resultant_wrench(contacts, F_C, 1.0).vector(), (Six() << 2, 4, 4, 7.844, -2.652, -1.77).finished(), 1e-9);
}

TEST_SUITE_END();
