#pragma once

#include <vector>

#include "preshape/hand/chain.h"
#include "preshape/hand/hand_model.h"

namespace preshape {
class Value;
}

namespace preshape::dh {

/// A hand as its description tells it, in metres and radians. chains[i] belongs to fingers[i].
struct HandDescription {
  HandDimensions dimensions;
  std::vector<Finger> fingers;
  std::vector<Joint> joints;
  std::vector<LinkSolid> solids;
  std::vector<Chain> chains;
};

/// Reads the table of a hand's Lua file; the keys are explained in this plugin's README.
/// @throws InputError on the first mistake: file:line, what, which key, the nearest right key or the mend
HandDescription read_hand(const Value& table);

}  // namespace preshape::dh
