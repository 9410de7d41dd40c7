#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coding.h"
#include "network.h"

namespace preshape::mlp {

/// How inputs are put into the network.
enum class Scaling { kNone, kAsinh };

/// A trained classifier: networks whose bit probabilities are averaged. Its numbers are all of what `predict`
/// depends on.
struct State {
  int features = 0;
  Scaling scaling = Scaling::kAsinh;
  Coding coding;
  std::vector<Network> committee;
};

/// Little-endian bytes: magic, version, sizes, patterns, weights, and the SHA-256 of all that.
std::string state_bytes(const State& state);
/// @throws InputError when the bytes are not what state_bytes gave; no more is allocated than the bytes hold
State state_from(std::string_view bytes);

}  // namespace preshape::mlp
