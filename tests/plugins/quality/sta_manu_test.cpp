#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

/// Stability and manipulability of contacts under the soft finger; W overrides the resultant.
std::array<double, 2> measure(const std::vector<ContactFrame>& contacts, const Wrench& W) {
  const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  const auto quality = registry().create<QualityMeasure>("sta_manu");
  const auto WU = wrench_union(*model, contacts, 1.0);
  const std::vector<Wrench> F(contacts.size());
  std::array<double, 2> values;
  quality->evaluate({contacts, F, WU, W, 1.0}, values);
  return values;
}

const ContactFrame kBelow = ContactFrame::at({0, -0.2, 0}, {0, 1, 0}, {1, 0, 0});
const ContactFrame kAbove = ContactFrame::at({0, 0.2, 0}, {0, -1, 0}, {1, 0, 0});

}  // namespace

TEST_CASE("Stability: one soft finger constrains four motions, two opposed ones all six") {
  CHECK(measure({kBelow}, {})[0] == 4.0);
  CHECK(measure({kBelow, kAbove}, {})[0] == 6.0);
}

TEST_CASE("Manipulability: it counts the components of at least 0.1, by magnitude") {
  CHECK(measure({kBelow}, Wrench({1, -1, 0.0999}, {0.1, -0.5, 0}))[1] == 4.0);
  CHECK(measure({kBelow}, {})[1] == 0.0);
}

TEST_SUITE_END();
