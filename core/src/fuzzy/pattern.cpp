#include "preshape/fuzzy/pattern.h"

namespace preshape {

void Patterns::add(const std::array<double, kComponents>& vector) {
  const auto sets = static_cast<std::size_t>(partition_->size());
  const std::size_t first = memberships_.size();
  memberships_.resize(first + kComponents * sets);
  for (std::size_t i = 0; i < kComponents; ++i) {
    crisp_.push_back(vector[i]);
    partition_->fuzzify(vector[i], std::span(memberships_).subspan(first + i * sets, sets));
  }
}

void Patterns::clear() {
  crisp_.clear();
  memberships_.clear();
}

PatternView Patterns::view() const { return {count(), partition_->size(), crisp_.data(), memberships_.data()}; }

}  // namespace preshape
