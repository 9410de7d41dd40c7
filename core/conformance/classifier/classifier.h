#pragma once

#include "../context.h"

namespace preshape::conformance {

// learning.cpp: what it learns from which rows
void k02_seeds(Context& context);
void k04_separable(Context& context);
void k05_held_out(Context& context);
void k09_relabelled(Context& context);
void k10_scaled(Context& context);
void k11_degenerate(Context& context);
void k12_forgets(Context& context);
void k18_extends(Context& context);
void k19_incremental(Context& context);
void k20_outcome(Context& context);

// answering.cpp: what it says and refuses
void k01_untrained(Context& context);
void k08_probabilities(Context& context);
void k14_bad_rows(Context& context);
void k15_confidence(Context& context);
void k17_realtime(Context& context);

// state.cpp: its state as bytes
void k06_round_trip(Context& context);
std::string k06_answers(Context& context, std::string_view state);
void k07_bad_states(Context& context);
void k13_copies(Context& context);

}  // namespace preshape::conformance
