#pragma once

#include <functional>
#include <string>
#include <vector>

#include "preshape/io/comparison.h"
#include "preshape/workbench/session.h"

namespace preshape {

/// One combination of a description that gives lists where it gives one.
struct Variant {
  Value description;           ///< with one choice everywhere
  std::vector<Value> choices;  ///< what was chosen for each key of the Variants; nil where the key does not apply
};

struct Variants {
  std::vector<std::string> keys;  ///< none: the description chooses one of everything itself
  std::vector<Variant> all;
};

/// Most combinations of one comparison.
inline constexpr std::size_t kMostVariants = 1000;

/// All combinations, the last key turning fastest. A list counts as choices where a scenario takes one: of an object,
/// hand, task, component or seed; of a parameter or setting that is no list itself; of lists where it is.
/// @throws InputError when there are more than kMostVariants
PRESHAPE_API Variants variants_of(const Value& description, const Registry& registry);

/// Runs every combination, each from a copy of its memory: nothing that a comparison learns is kept. What is refused
/// when it is run (a threshold beyond a measure's range, say) is told in its row.
/// @param control meta control, as Session::run takes it, or empty
/// @throws ScriptError with every mistake of every combination before any is run
PRESHAPE_API Comparison compare(const Variants& variants, const std::filesystem::path& file, const Registry& registry,
                                const Catalogue& catalogue, const Session::Options& options,
                                const std::function<Value(const Value& report)>& control);

}  // namespace preshape
