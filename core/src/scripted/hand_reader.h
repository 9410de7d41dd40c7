#pragma once

#include <string>
#include <vector>

#include "preshape/base/value.h"
#include "preshape/hand/chain.h"
#include "preshape/hand/hand_model.h"

namespace preshape::scripted {

/// Everything that a hand's instance says, checked.
struct HandData {
  HandDimensions dimensions;
  std::vector<Finger> fingers;
  std::vector<Joint> joints;
  std::vector<Chain> chains;
  std::vector<LinkSolid> solids;
};

/// @throws ScriptError with the first mistake
HandData read_hand(const Value& instance, const std::string& owner);

}  // namespace preshape::scripted
