#pragma once

#include <string>

#include "preshape/io/run_record.h"

namespace preshape {

/// A run as JSON (docs/report-schema.md). The same run gives the same bytes, except for the member "timings", which
/// `timings = false` leaves out.
PRESHAPE_API std::string report_json(const RunRecord& record, bool timings = true);

/// The same as a Value, for scripts.
PRESHAPE_API Value report_value(const RunRecord& record);

/// A Value as JSON text; functions become null.
PRESHAPE_API std::string value_json(const Value& value, int indent = -1);

}  // namespace preshape
