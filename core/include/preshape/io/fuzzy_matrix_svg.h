#pragma once

#include <array>
#include <optional>
#include <string>

#include "preshape/fuzzy/pattern.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// A task and a wrench as the similarity measure sees them (thesis fig. 3.19).
struct FuzzyMatrices {
  /// What there is to say of a wrench.
  struct Compared {
    std::array<double, kComponents> wrench{};      ///< crisp
    std::array<double, kComponents> components{};  ///< of the deciding measure, a component each
    double score = 0.0;
  };
  std::string title, measure;
  FuzzyPartition partition;
  std::array<double, kComponents> task{};  ///< crisp
  std::optional<Compared> compared;        ///< none: there was no grasp
};

/// Of a run's task and the resultant wrench of its grasp.
PRESHAPE_API FuzzyMatrices fuzzy_matrices(const RunRecord& record);

/// A drawing of both matrices side by side, a row a component with its crisp number, a column a set, the
/// degrees in the cells, and the similarity of each pair of rows.
PRESHAPE_API std::string fuzzy_matrix_svg(const FuzzyMatrices& matrices);

}  // namespace preshape
