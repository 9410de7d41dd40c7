// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cstdio>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/contact/contact_limits.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const auto model = registry.create<ContactModel>("@NAME@", Value::table({{"mu", 0.5}, {"pull", 1.0}}));
  const ContactFrame C = ContactFrame::at({0.01, 0, 0}, {0, 1, 0}, {1, 0, 0});

  std::vector<Wrench> F_C_O(1);
  model->pattern_wrenches({&C, 1}, F_C_O);
  check((F_C_O[0].force() - Eigen::Vector3d(0.5, 1, 0)).norm() < 1e-15, "pull = 1 uses all friction along the approach");
  check(F_C_O[0].moment().isZero(), "a hard finger passes no moment");

  const ContactLimits* limits = contact_limits(*model);
  check(limits->admits(C, F_C_O[0], 1e-12), "the pattern wrench is within the model's own limits");
  check(!limits->admits(C, Wrench({0.6, 1, 0}, {0, 0, 0}), 1e-12), "a force outside the cone slips");
  check(!limits->admits(C, Wrench({0, -1, 0}, {0, 0, 0}), 1e-12), "a contact does not pull");

  WrenchBasis edges(6, 8);
  limits->primitive_wrenches({&C, 1}, 8, edges);
  for (int k = 0; k < 8; ++k) {
    check(limits->admits(C, Wrench::from_vector(edges.col(k)), 1e-12), "every edge lies on the cone");
  }

  bool refused = false;
  try {
    registry.create<ContactModel>("@NAME@", Value::table({{"mu", -1}}));
  } catch (const InputError&) {
    refused = true;
  }
  check(refused, "a negative friction coefficient is refused");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
