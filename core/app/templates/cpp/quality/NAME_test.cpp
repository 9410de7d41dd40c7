// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cmath>
#include <cstdio>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/grasp/quality.h"
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
  const auto measure = registry.create<QualityMeasure>("@NAME@");
  const Wrench resultant;
  std::vector<double> values(measure->numbers().size());
  const auto evaluate = [&](const WrenchUnion& wrenches) { measure->evaluate({{}, {}, wrenches, resultant, 0.18}, values); };

  WrenchUnion wrenches = WrenchUnion::Identity(6, 6);
  wrenches(2, 2) = 0.5;
  evaluate(wrenches);
  check(std::abs(values[0] - 0.5) < 1e-14 && std::abs(values[1] - 0.5) < 1e-14, "it is the value of the weakest direction");
  wrenches(2, 2) = 0.0;
  evaluate(wrenches);
  check(std::abs(values[0]) < 1e-14, "a grasp that lacks a direction has 0");
  evaluate(WrenchUnion::Identity(4, 6));
  check(values[0] == 0.0 && values[1] == 0.0, "so has one of fewer than six wrenches");

  bool refused = false;
  try {
    wrenches(0, 0) = std::nan("");
    evaluate(wrenches);
  } catch (const InputError&) {
    refused = true;
  }
  check(refused, "a wrench that is not a number is refused");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
