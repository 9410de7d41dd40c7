#pragma once

#include <map>
#include <string>
#include <vector>

#include "description.h"
#include "preshape/hand/chain.h"
#include "tree.h"

namespace preshape::urdf_hand {

/// What a link of the URDF moves with: a link of a finger, or the palm.
struct Carrier {
  int finger = -1;  ///< -1: the palm
  int link = 0;     ///< moved by the finger's first `link` joints
};

/// The fingers of a URDF as chains. chains[i] belongs to fingers[i].
struct Fingers {
  std::vector<Finger> fingers;
  std::vector<Joint> joints;
  std::vector<Chain> chains;
  std::map<std::string, Carrier> moved_by;  ///< what is behind a joint of the URDF, by the joint's name
};

/// Follows the URDF from the base's link to every finger's tip. Fixed joints are folded into their
/// neighbours, mimic joints follow the joint that has a drive, and a joint that several fingers share is the
/// first one's: the others have a joint of their own that follows it.
/// @throws InputError on a link that is unknown or not beyond the base's link, a finger that does not move, a
/// circle of
///         mimic joints
Fingers build_fingers(const Description& description, const Document& document);

}  // namespace preshape::urdf_hand
