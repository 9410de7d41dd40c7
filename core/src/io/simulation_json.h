#pragma once

#include "io/json_numbers.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// A simulation as a run's report tells it (docs/report-schema.md).
/// @param judged what was carried out; none in a report whose result was taken out
Json simulation_json(const RunRecord& record, const std::optional<JudgedGrasp>& judged, const Simulation& simulation,
                     const std::optional<ImpartedTwists>& imparted);

}  // namespace preshape
