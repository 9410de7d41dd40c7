#pragma once

#include <string>
#include <vector>

#include "preshape/fuzzy/membership.h"

namespace preshape {

/// A shape by the word that a script uses for it.
struct SetShape {
  Membership::Shape shape;
  std::string word;
  std::size_t points;     ///< how many
  std::string meaning;    ///< of the points
};

const std::vector<SetShape>& set_shapes();

/// What is wrong with a set's points, as the end of a sentence; "" if nothing.
std::string set_fault(const Membership& set);

}  // namespace preshape
