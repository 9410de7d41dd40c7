#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace preshape::conformance {

/// What a check's process is busy with, in memory that it shares with its parent: when it crashes or hangs, the
/// parent can still say on which input.
struct RunningCase {
  static constexpr std::size_t kMostNumbers = 1000, kMostText = 2000;

  std::size_t count = 0;         ///< 0: no case is running
  double numbers[kMostNumbers];  ///< of the case
  char blocks[kMostText];        ///< "name size\n" of each block

  void begin(std::span<const double> case_numbers);
  /// The running case in words, or "".
  std::string text() const;
};

}  // namespace preshape::conformance
