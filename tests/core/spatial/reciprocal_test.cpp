#include <Eigen/SVD>

#include "preshape/spatial/reciprocal.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/spatial");

namespace {

using Stack = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// rows x 6 of exactly the given rank, plus noise.
Stack stack_of_rank(Random& random, int rows, int rank, double noise) {
  Eigen::MatrixXd left(rows, rank), right(rank, 6);
  for (auto* m : {&left, &right}) {
    for (Eigen::Index i = 0; i < m->size(); ++i) m->data()[i] = random.uniform(-1, 1);
  }
  Stack stack = left * right;
  for (Eigen::Index i = 0; i < stack.size(); ++i) stack.data()[i] += noise * random.uniform(-1, 1);
  return stack;
}

}  // namespace

TEST_CASE("Rank: it agrees with singular values wherever these leave no doubt") {
  Random random(6);
  int clear = 0;
  for (int i = 0; i < 3000; ++i) {
    const int rank = static_cast<int>(random.below(7)), rows = 1 + static_cast<int>(random.below(16));
    const double noise = (i % 3 == 0) ? 0.0 : 1e-11;
    const Stack stack = stack_of_rank(random, rows, rank, noise);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(stack)};
    const auto& s = svd.singularValues();
    int expected = 0;
    bool doubtful = false;
    for (Eigen::Index k = 0; k < s.size(); ++k) {
      const double share = s[0] > 0 ? s[k] / s[0] : 0.0;
      if (share > kRankTolerance) ++expected;
      doubtful = doubtful || (share > kRankTolerance / 10 && share < kRankTolerance * 10);
    }
    if (doubtful) continue;
    ++clear;
    CHECK(wrench_rank(stack) == expected);
  }
  CHECK(clear > 2500);
}

TEST_CASE("Reciprocal twists: no wrench of the union does work on them, and they span what is left") {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const int rank = static_cast<int>(random.below(7));
    const Stack stack = stack_of_rank(random, 12, rank, 0.0);
    const auto twists = reciprocal_twists(stack);
    CHECK(static_cast<int>(twists.size()) == 6 - wrench_rank(stack));
    Eigen::MatrixXd span(6, twists.size());
    for (std::size_t k = 0; k < twists.size(); ++k) {
      span.col(static_cast<Eigen::Index>(k)) = twists[k].vector();
      for (int row = 0; row < stack.rows(); ++row) {
        CHECK_NEAR(reciprocal_product(Wrench::from_vector(stack.row(row).transpose()), twists[k]), 0.0, 1e-12 * 6);
      }
    }
    CHECK_NEAR(Eigen::MatrixXd(span.transpose() * span),
               Eigen::MatrixXd(Eigen::MatrixXd::Identity(span.cols(), span.cols())), 1e-10);
  }
}

TEST_CASE("Reciprocal twists: an empty union leaves all six motions free") {
  CHECK(reciprocal_twists(Stack(0, 6)).size() == 6);
  CHECK(wrench_rank(Stack(0, 6)) == 0);
}

TEST_CASE("Reciprocal twists: a pure force along z leaves every motion but the one along its line") {
  Stack stack(1, 6);
  stack << 0, 0, 1, 0, 0, 0;
  const auto twists = reciprocal_twists(stack);
  REQUIRE(twists.size() == 5);
  for (const auto& twist : twists) CHECK_NEAR(twist.linear().z(), 0.0, kEps);
}

TEST_SUITE_END();
