#pragma once

#include <chrono>
#include <string>

#include "preshape/base/progress.h"

namespace preshape::app {

/// Whether standard output may be coloured: a terminal, and NO_COLOR unset.
bool output_takes_colour();

/// Progress on standard error for what takes over a second: a bar on a terminal, a plain line a stage elsewhere.
class TerminalProgress final : public Progress {
 public:
  /// @param quiet draws nothing
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress() override;
  void advance(std::string_view stage, double fraction, std::string_view detail) override;

 private:
  void clear();

  bool quiet_, terminal_, drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point begin_, last_;
  bool told_ = false;
};

}  // namespace preshape::app
