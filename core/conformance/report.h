#pragma once

#include <span>
#include <string>

#include "runner.h"

namespace preshape::conformance {

struct ReportStyle {
  bool colour = false;
  bool quiet = false;  ///< only what does not pass
};

/// What became of one component, for a terminal: a line a check, and the way to run a bad one alone.
std::string component_text(const ComponentReport& report, const Plan& plan, const ReportStyle& style);

/// A line a component.
std::string summary_text(std::span<const ComponentReport> reports);

/// The outcomes as JUnit XML: a test suite a component, a test case a check.
std::string junit_text(std::span<const ComponentReport> reports, const Plan& plan);

/// The outcomes as pages show them: a table a kind, a row a check, a column a component; what was left out.
std::string markdown_text(std::span<const ComponentReport> reports);

/// The outcomes as JSON (docs/conformance.md).
std::string json_text(std::span<const ComponentReport> reports, const Plan& plan);

}  // namespace preshape::conformance
