#pragma once

#include <vector>

#include "../context.h"
#include "../probe.h"

namespace preshape::conformance {

// The checks of every kind, by what they look at. Each is one G of the table in checks.cpp.

// declaration.cpp
void g01_manifest(Context& context);
void g02_same_everywhere(Context& context);
std::string g02_declaration(Context& context, std::string_view);
void g05_describe_is_light(Context& context);
void g07_declarations(Context& context);

// library.cpp
void g03_symbols(Context& context);
void g04_needed_libraries(Context& context);
void g06_unknown_asked(Context& context);
void g23_unloads(Context& context);

// parameters.cpp
void g09_bad_parameters(Context& context);
void g10_fuzz(Context& context);

// input.cpp
void g12_nonfinite(Context& context);
void g13_wrong_sizes(Context& context);
void g14_exceptions(Context& context);
void g17_inputs(Context& context);
void g25_batches(Context& context);
void g27_subnormal(Context& context);

// process.cpp
void g15_silent(Context& context);
void g16_process_state(Context& context);
void g22_leaks(Context& context);
void g26_allocation_fails(Context& context);

// answers.cpp
void g19_repeats(Context& context);
std::string g19_answers(Context& context, std::string_view seed);
void g20_instances(Context& context);
void g21_threads(Context& context);
void g29_no_progress(Context& context);
void g30_stopped(Context& context);

// scenario.cpp
void g28_scenario(Context& context);

/// A component with the context's parameters.
struct Specimen {
  const Probe& probe;
  std::shared_ptr<void> component;
  std::vector<double> use(std::uint64_t seed = 7) const { return probe.use(component.get(), seed); }
};
Specimen specimen(Context& context);
Specimen specimen(Context& context, const Value& parameters);

/// Bit for bit, NaN like NaN.
bool same_bits(std::span<const double> a, std::span<const double> b);
/// "the 3rd of 12 numbers was 1, is 2": where two answers part.
std::string difference(std::span<const double> before, std::span<const double> now);

/// Random parameters within their declared bounds; what has none stays as it is.
Value drawn_parameters(Context& context, Random& random);

}  // namespace preshape::conformance
