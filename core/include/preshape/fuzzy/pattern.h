#pragma once

#include <array>
#include <vector>

#include "preshape/fuzzy/partition.h"

namespace preshape {

/// Number of components of a task or a wrench.
inline constexpr int kComponents = 6;

/// Many 6-vectors with their memberships, contiguous, as they cross into a similarity plugin; not owning.
struct PatternView {
  int count = 0;
  int sets = 0;
  const double* crisp = nullptr;        ///< count x 6, row-major
  const double* memberships = nullptr;  ///< count x 6 x sets, row-major

  /// The i-th pattern alone.
  PatternView operator[](int i) const {
    return {1, sets, crisp + i * kComponents, memberships + static_cast<std::ptrdiff_t>(i) * kComponents * sets};
  }
};

/// Fuzzified 6-vectors (thesis fig. 3.19: a 6 x 7 matrix each).
class PRESHAPE_API Patterns {
 public:
  /// @param partition must outlive the patterns
  explicit Patterns(const FuzzyPartition& partition) : partition_(&partition) {}
  explicit Patterns(FuzzyPartition&&) = delete;
  Patterns(const FuzzyPartition& partition, const std::array<double, kComponents>& vector)
      : partition_(&partition) {
    add(vector);
  }
  Patterns(FuzzyPartition&&, const std::array<double, kComponents>&) = delete;

  void add(const std::array<double, kComponents>& vector);
  void clear();
  int count() const { return static_cast<int>(crisp_.size()) / kComponents; }
  PatternView view() const;

 private:
  const FuzzyPartition* partition_;
  std::vector<double> crisp_, memberships_;
};

}  // namespace preshape
