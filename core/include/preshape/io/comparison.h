#pragma once

#include <optional>
#include <string>
#include <vector>

#include "preshape/io/run_record.h"

namespace preshape {

/// One combination of what a scenario lets choose from.
struct ComparedRun {
  std::vector<Value> choices;       ///< one for each key of the comparison; nil where it does not apply
  std::optional<RunRecord> record;  ///< none where the combination was refused
  std::string refusal;              ///< why, in one sentence
};

/// A scenario that gives lists where it gives one, run once for each combination.
struct Comparison {
  std::string scenario;           ///< file, as given
  std::vector<std::string> keys;  ///< what is chosen: "contact", "thresholds.estimation"
  std::vector<ComparedRun> runs;
};

/// A table for a terminal, a row a combination: the choices, then mode, plane, approach, fingers, scores, those quality
/// numbers that are not the same everywhere, and time. What differs from the first row is marked with a star.
/// @param colour also paints it
PRESHAPE_API std::string comparison_text(const Comparison& comparison, bool colour);

/// The same as data (docs/report-schema.md): keys, and rows with choices, refusal, seconds and the report.
PRESHAPE_API Value comparison_value(const Comparison& comparison);

}  // namespace preshape
