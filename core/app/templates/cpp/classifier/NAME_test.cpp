// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cstdio>

#include "preshape/base/error.h"
#include "preshape/grasp/classifier.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

bool refuses(preshape::Classifier& classifier, const std::string& state) {
  try {
    classifier.load(state);
  } catch (const preshape::InputError&) {
    return true;
  }
  return false;
}

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const auto classifier = registry.create<Classifier>("@NAME@");
  RowMatrix inputs(4, 2), targets(4, 1), bits(4, 1);
  inputs << 0, 0, 0, 1, 1, 0, 1, 1;
  targets << 0, 1, 1, 0;  // exclusive or

  const TrainingOutcome outcome = classifier->fit(inputs, targets, 1, nullptr);
  check(outcome.status == TrainingOutcome::Status::kArrived && outcome.wrong_rows == 0, "four different rows are learned");
  classifier->predict(inputs, bits);
  check(bits == targets, "every learned row is reproduced");
  classifier->predict((inputs.array() * 0.9 + 0.05).matrix(), bits);
  check(bits == targets, "what is near to a row has its bits");

  const std::string state = classifier->save();
  const auto other = registry.create<Classifier>("@NAME@");
  other->load(state);
  other->predict(inputs, bits);
  check(bits == targets && other->save() == state, "a state that was loaded predicts and saves the same");
  std::string damaged = state;
  damaged.back() ^= 1;
  check(refuses(*other, damaged) && refuses(*other, state.substr(0, state.size() - 1)) && refuses(*other, ""),
        "what is damaged, cut off or empty is refused");
  check(other->save() == state, "and the classifier is as before");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
