// The table of the checks of classifiers.
#include "classifier.h"

namespace preshape::conformance {

namespace {

constexpr Check kChecks[] = {
    {"K01", "classifier", "before it has learned anything it says so and refuses to predict", k01_untrained},
    {"K02", "classifier", "the same rows and seed give the same state, byte for byte; any seed does if it promises 'seedless'", k02_seeds},
    {"K04", "classifier", "it learns two sides of a line, and exclusive or if it promises 'nonlinear'", k04_separable},
    {"K05", "classifier", "of heaps ten deviations apart it tells 99 % of new rows, and each row it has learned if it promises 'interpolating'",
     k05_held_out},
    {"K06", "classifier", "its state, loaded anywhere, predicts bit for bit the same and is saved as the same bytes", k06_round_trip, "",
     Tier::kQuick, 20.0, k06_answers},
    {"K07", "classifier", "bytes that are no state of it are refused, take little memory and leave it as it was", k07_bad_states},
    {"K08", "classifier", "every bit that it predicts is a probability, however far the question", k08_probabilities},
    {"K09", "classifier", "bits in another order and rows given twice change no decision, rows in another order nothing if it promises "
                          "'order_invariant'", k09_relabelled},
    {"K10", "classifier", "multiplying a feature by a positive number changes no decision", k10_scaled, "scale_invariant"},
    {"K11", "classifier", "one row, one code, constant features and the like are learned or refused, and no rows are refused", k11_degenerate},
    {"K12", "classifier", "a second fit forgets the first", k12_forgets},
    {"K13", "classifier", "a copy, made by save and load, learns without changing the original", k13_copies},
    {"K14", "classifier", "targets that are not 0 or 1 and rows that do not exist are refused and leave it as it was", k14_bad_rows},
    {"K15", "classifier", "between two heaps it is the surer the nearer to one of them", k15_confidence},
    {"K17", "classifier", "predict allocates nothing after its first call", k17_realtime, "realtime"},
    {"K18", "classifier", "extend knows old and new rows, and without a fit before it is a fit", k18_extends},
    {"K19", "classifier", "extend keeps what was learned before when the old rows are not shown again", k19_incremental, "incremental"},
    {"K20", "classifier", "the outcome counts the rows with a bit on the wrong side of 0.5 as they are predicted", k20_outcome},
};

}  // namespace

std::span<const Check> classifier_checks() { return kChecks; }

}  // namespace preshape::conformance
