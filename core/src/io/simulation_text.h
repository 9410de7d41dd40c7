#pragma once

#include "io/text_writer.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// simulation_status_name as a reader of a report has it.
std::string_view in_words(Simulation::Status status);

/// How the hand carried the result of a run out, which has a simulation.
/// @param other what was carried out in its place, as a line; not read where nothing was
void write_simulation(TextWriter& out, const RunRecord& record, const std::string& other);

/// What became of the next-best stations; nothing where none were tried.
void write_second_try(TextWriter& out, const RunRecord& record, const std::string& other);

}  // namespace preshape
