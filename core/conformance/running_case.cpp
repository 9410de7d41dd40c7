#include "running_case.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "context.h"

namespace preshape::conformance {

void RunningCase::begin(std::span<const double> case_numbers) {
  count = std::min(case_numbers.size(), kMostNumbers);
  std::copy_n(case_numbers.begin(), count, numbers);
}

std::string RunningCase::text() const {
  if (count == 0) return "";
  std::vector<Block> parts;
  std::istringstream lines(blocks);
  std::string name;
  std::size_t total = 0;
  for (int size = 0; lines >> name >> size; total += static_cast<std::size_t>(size)) parts.push_back({name, size});
  return total == count ? case_text(parts, {numbers, count}) : "";
}

}  // namespace preshape::conformance
