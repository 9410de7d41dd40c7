#pragma once

#include <string>
#include <string_view>

#include "layers.h"

namespace preshape::fann_plugin {

/// All of what `predict` depends on.
struct State {
  bool asinh = true;  ///< how inputs are put in
  Layers layers;
};

/// Little-endian bytes: magic, version, scaling, sizes, weights, and the SHA-256 of all that. FANN's own
/// format is a text file.
std::string state_bytes(const State& state);
/// @throws InputError when the bytes are not what state_bytes gave; no more is allocated than the bytes hold
State state_from(std::string_view bytes);

}  // namespace preshape::fann_plugin
