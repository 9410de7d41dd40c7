#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "preshape/base/error.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

struct Numbers {
  double smallest = -1.0, condition = -1.0, volume = -1.0;
};

/// Of a wrench union alone; nothing else of a grasp is looked at.
Numbers numbers(const WrenchUnion& wrench_union) {
  static const Wrench nothing(Eigen::Vector3d::Constant(NAN), Eigen::Vector3d::Constant(NAN));
  const auto measure = registry().create<QualityMeasure>("grasp_matrix");
  std::array<double, 3> values;
  measure->evaluate({{}, {}, wrench_union, nothing, std::numeric_limits<double>::quiet_NaN()}, values);
  return {values[0], values[1], values[2]};
}

WrenchUnion random_union(Random& random, Eigen::Index count) {
  WrenchUnion wrenches(count, 6);
  for (Eigen::Index i = 0; i < count; ++i) wrenches.row(i) = random_wrench(random).vector().transpose();
  return wrenches;
}

}  // namespace

TEST_CASE("Grasp matrix: six wrenches along the axes have their strengths for singular values") {
  const WrenchUnion wrenches = Eigen::Matrix<double, 6, 1>(3, 2, 5, 0.5, 1, 4).asDiagonal();
  const Numbers found = numbers(wrenches);
  CHECK_NEAR(found.smallest, 0.5, 1e-15);
  CHECK_NEAR(found.condition, 10.0, 1e-13);
  CHECK_NEAR(found.volume, 60.0, 1e-12);
}

TEST_CASE(
    "Grasp matrix: two opposed soft fingers a quarter of L from O have twice sqrt(2)/4 and four times "
    "sqrt(2)") {
  // Both bear each force and the moment about their line: sqrt(2). Across the line moments come from forces
  // at 1/4.
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  const std::vector<ContactFrame> contacts = {ContactFrame::at({0, -0.2, 0}, {0, 1, 0}, {1, 0, 0}),
                                              ContactFrame::at({0, 0.2, 0}, {0, -1, 0}, {1, 0, 0})};
  const Numbers found = numbers(wrench_union(*model, contacts, 0.8));
  CHECK_NEAR(found.smallest, std::sqrt(2.0) / 4, 1e-14);
  CHECK_NEAR(found.condition, 4.0, 1e-13);
  CHECK_NEAR(found.volume, 0.5, 1e-14);
  const Numbers one = numbers(wrench_union(*model, std::span(contacts).first(1), 0.8));
  CHECK(one.smallest == 0.0);
  CHECK(one.condition == 1e6);
  CHECK(one.volume == 0.0);
}

TEST_CASE(
    "Grasp matrix: on random wrenches the numbers are those of the eigenvalues and the determinant of G G'") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const WrenchUnion wrenches = random_union(random, 6 + static_cast<Eigen::Index>(random.below(12)));
    const Eigen::Matrix<double, 6, 6> gram = wrenches.transpose() * wrenches;
    const Eigen::Matrix<double, 6, 1> squares =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(gram).eigenvalues();
    const Numbers found = numbers(wrenches);
    // The products' rounding, beside squares of the smallest singular value.
    CHECK_NEAR(found.smallest * found.smallest, squares[0], 100 * kEps * squares[5]);
    CHECK_NEAR(found.volume * found.volume, gram.determinant(), 1e-11 * gram.diagonal().prod());
    CHECK_NEAR(1.0 / (found.condition * found.condition), squares[0] / squares[5], 100 * kEps);
  }
}

TEST_CASE(
    "Grasp matrix: twice the wrenches' strength doubles the smallest singular value and leaves the "
    "condition") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const WrenchUnion wrenches = random_union(random, 8);
    const Numbers once = numbers(wrenches), twice = numbers(2.0 * wrenches);
    CHECK_NEAR(twice.smallest, 2 * once.smallest, 1e-14);
    CHECK_NEAR(twice.condition, once.condition, 1e-12 * once.condition);
    CHECK_NEAR(twice.volume, 64 * once.volume, 1e-12 * twice.volume);
  }
}

TEST_CASE(
    "Grasp matrix: a small singular value is told to its digits, which G G' would lose, and a tiny one as "
    "singular") {
  Random random(3);
  const Eigen::Matrix3d R = random_rotation(random), S = random_rotation(random);
  Eigen::Matrix<double, 6, 6> turn = Eigen::Matrix<double, 6, 6>::Zero(), other = turn;
  turn.topLeftCorner<3, 3>() = R, turn.bottomRightCorner<3, 3>() = S;
  other.topRightCorner<3, 3>() = S, other.bottomLeftCorner<3, 3>() = R;
  const auto with = [&](double least) -> WrenchUnion {
    return turn * Eigen::Matrix<double, 6, 1>(1, 1, 1, 1, 1, least).asDiagonal() * other;
  };
  CHECK_NEAR(numbers(with(1e-5)).condition, 1e5, 1e-3);
  CHECK_NEAR(numbers(with(1e-9)).smallest, 1e-9, 1e-14);
  for (const double least : {0.9e-6, 1e-9, 1e-20, 0.0}) CHECK(numbers(with(least)).condition == 1e6);
}

TEST_CASE("Grasp matrix: no wrenches, few wrenches and zero wrenches are singular") {
  for (const Eigen::Index count : {0, 1, 5, 12}) {
    const Numbers found = numbers(WrenchUnion::Zero(count, 6));
    CHECK(found.smallest == 0.0);
    CHECK(found.condition == 1e6);
    CHECK(found.volume == 0.0);
  }
  Random random(4);
  CHECK(numbers(random_union(random, 5)).smallest == 0.0);
}

TEST_CASE("Grasp matrix: a wrench that is not finite is refused") {
  Random random(5);
  WrenchUnion wrenches = random_union(random, 8);
  wrenches(3, 4) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_SAYING(numbers(wrenches), InputError, "a wrench of the union is not finite");
}

TEST_SUITE_END();
