#pragma once

#include <string>
#include <vector>

#include "preshape/hand/hand_model.h"

namespace preshape {

/// What a hand's plugin left out of the files that it read, such as meshes that are not there, a sentence each; empty
/// where it left nothing out or tells nothing. [any thread]
PRESHAPE_API std::vector<std::string> hand_notes(const HandModel& hand);

/// The first of them, and how many more there are: what a person is told.
PRESHAPE_API std::vector<std::string> hand_notes_in_short(const HandModel& hand);

}  // namespace preshape
