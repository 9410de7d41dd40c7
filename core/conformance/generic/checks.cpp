// The table of the checks of every kind.
#include "generic.h"

namespace preshape::conformance {

namespace {

constexpr Check kChecks[] = {
    {"G01", "", "the manifest is complete: name, version, licence, author, summary, components named once", g01_manifest},
    {"G02", "", "it declares the same in memory as in its file, at every loading and in every process", g02_same_everywhere, "",
     Tier::kQuick, 20.0, g02_declaration},
    {"G03", "", "the library exports one symbol, none that pins it, and looks in no folder of one machine", g03_symbols},
    {"G04", "", "the library names every library that it uses, and brings no interpreter", g04_needed_libraries},
    {"G05", "", "describing it is quick and opens no file, socket or thread", g05_describe_is_light},
    {"G06", "", "what does not exist is refused: components, extensions, numbers beyond the last", g06_unknown_asked},
    {"G07", "", "each parameter has name, type, unit, text and a default in its bounds; each promise is known", g07_declarations},
    {"G09", "", "parameters that are unknown, out of bounds, of a wrong type or no number are refused by name", g09_bad_parameters},
    {"G10", "", "whatever its parameters in their bounds, its answers are finite or it says why not", g10_fuzz},
    {"G12", "", "inputs that are not finite are treated as promised and leave no trace", g12_nonfinite},
    {"G13", "", "buffers of a wrong size are refused by their sizes and leave no trace", g13_wrong_sizes},
    {"G14", "", "only exceptions of the preshape::Error family come out of it, with a message", g14_exceptions},
    {"G15", "", "it prints nothing", g15_silent},
    {"G16", "", "it leaves locale, rounding, signals, working directory, environment and threads as they were", g16_process_state},
    {"G17", "", "it neither writes to its inputs nor keeps them after the call", g17_inputs},
    {"G19", "", "the same question gets the same bits: again, after others, in another component and process", g19_repeats, "",
     Tier::kQuick, 20.0, g19_answers},
    {"G20", "", "two components of it with other parameters do not disturb one another", g20_instances},
    {"G21", "", "its const calls from eight threads at once give the answers of one", g21_threads},
    {"G22", "", "made, used and destroyed again and again it leaves no memory behind", g22_leaks},
    {"G23", "", "the library leaves memory each time that nothing of it is alive", g23_unloads},
    {"G25", "", "questions asked together get the answers that they get one by one", g25_batches},
    {"G26", "", "an allocation that fails ends in an exception and leaves no trace", g26_allocation_fails, "", Tier::kFull, 60.0},
    {"G27", "", "subnormal inputs take no more than ten times as long", g27_subnormal},
    {"G28", "", "a scenario runs with it in its place", g28_scenario, "", Tier::kQuick, 60.0},
    {"G29", "", "it works the same when nobody is told its progress", g29_no_progress},
    {"G30", "", "stopped by an exception of the progress it lets that through and answers as before", g30_stopped},
};

}  // namespace

std::span<const Check> generic_checks() { return kChecks; }

}  // namespace preshape::conformance
