#include "preshape/base/random.h"
#include "preshape/grasp/preshape.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/grasp");

TEST_CASE("Code: twelve planes and seven symbols take nine bits, most significant first") {
  const PreshapeCode code(12, 7);
  CHECK(code.bits() == 9);
  Eigen::VectorXd expected(9);
  expected << 1, 0, 1, 0, 0, 1, 1, 1, 1;  // plane 10, symbol 3, three fingers (figure 3.22)
  CHECK(code.encode({10, 3, 3}) == expected);
}

TEST_CASE("Code: every preshape decodes to itself with certainty") {
  const PreshapeCode code(12, 7);
  for (int plane = 1; plane <= 12; ++plane) {
    for (int symbol = 1; symbol <= 7; ++symbol) {
      for (int fingers = 1; fingers <= 3; ++fingers) {
        const Preshape preshape{plane, symbol, fingers};
        const auto decoding = code.decode(code.encode(preshape));
        CHECK(decoding.preshape == preshape);
        CHECK(decoding.confidence == 1.0);
      }
    }
  }
}

TEST_CASE("Code: whatever the bits, the decoded code is valid and no valid one is likelier") {
  const PreshapeCode code(12, 7);
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd bits(9);
    for (Eigen::Index k = 0; k < 9; ++k) bits[k] = random.uniform();
    const auto decoding = code.decode(bits);
    double best = 0, total = 0;
    Preshape likeliest;
    for (int plane = 1; plane <= 12; ++plane) {
      for (int symbol = 1; symbol <= 7; ++symbol) {
        for (int fingers = 1; fingers <= 3; ++fingers) {
          const Eigen::VectorXd target = code.encode({plane, symbol, fingers});
          double p = 1;
          for (Eigen::Index k = 0; k < 9; ++k) p *= target[k] == 1 ? bits[k] : 1 - bits[k];
          total += p;
          if (p > best) best = p, likeliest = {plane, symbol, fingers};
        }
      }
    }
    CHECK(decoding.preshape == likeliest);
    CHECK_NEAR(decoding.confidence, best / total, 1e-12);
  }
}

TEST_CASE("Code: other numbers of planes take the bits that they need") {
  CHECK(PreshapeCode(24, 7).bits() == 10);
  CHECK(PreshapeCode(3, 3).bits() == 6);
  CHECK(PreshapeCode(24, 7).decode(PreshapeCode(24, 7).encode({24, 7, 1})).preshape == Preshape{24, 7, 1});
}

TEST_CASE("Taxonomy: the finger count names the type") {
  CHECK(taxonomy({1, 1, 1}).type == "thumb-index");
  CHECK(taxonomy({1, 1, 3}).type == "thumb-three-finger");
  CHECK(taxonomy({1, 1, 2}).opposition == "pad opposition");
}

TEST_SUITE_END();
