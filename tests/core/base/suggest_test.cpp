#include <string>
#include <vector>

#include "preshape/base/suggest.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/base");

TEST_CASE("Suggestion: one slip finds its name, a swap counts as one slip") {
  const std::vector<std::string> names = {"contact", "similarity", "classifier"};
  CHECK(nearest_name("contcat", names) == "contact");
  CHECK(nearest_name("similarty", names) == "similarity");
  CHECK(nearest_name("clasifier", names) == "classifier");
}

TEST_CASE("Suggestion: a part of a name finds it, also a short one") {
  const std::vector<std::string> names = {"utah_mit", "shadow", "salisbury_soft_finger"};
  CHECK(nearest_name("utah", names) == "utah_mit");
  CHECK(nearest_name("soft_finger", names) == "salisbury_soft_finger");
}

TEST_CASE("Suggestion: a word like nothing known suggests nothing") {
  const std::vector<std::string> names = {"contact", "similarity"};
  CHECK(nearest_name("banana", names).empty());
  CHECK(did_you_mean("banana", names) == "; known: contact, similarity");
}

TEST_SUITE_END();
