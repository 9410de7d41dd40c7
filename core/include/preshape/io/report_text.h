#pragma once

#include <string>

#include "preshape/io/run_record.h"

namespace preshape {

struct ReportTextOptions {
  bool colour = false;
  bool quiet = false;  ///< the verdict and the preshape, a line each
  bool timings = true;
};

/// A run in words and numbers for a terminal of 100 columns.
PRESHAPE_API std::string report_text(const RunRecord& record, const ReportTextOptions& options = {});

}  // namespace preshape
