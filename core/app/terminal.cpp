#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace preshape::app {

namespace {

constexpr auto kPatience = std::chrono::seconds(1);        // before anything is drawn
constexpr auto kRefresh = std::chrono::milliseconds(100);  // between two drawings
constexpr int kBarWidth = 30;

}  // namespace

bool output_takes_colour() {
  const char* no_colour = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) && !(no_colour && *no_colour);
}

TerminalProgress::TerminalProgress(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO)), begin_(std::chrono::steady_clock::now()), last_(begin_) {}

TerminalProgress::~TerminalProgress() { clear(); }

void TerminalProgress::clear() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
  drawn_ = false;
}

void TerminalProgress::advance(std::string_view stage, double fraction, std::string_view detail) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  if (stage != stage_) {
    clear();
    stage_ = stage;
    begin_ = now;
    told_ = false;
  }
  if (now - begin_ < kPatience) return;
  if (!terminal_) {
    if (!std::exchange(told_, true)) fmt::print(stderr, "{} ...\n", stage);
    return;
  }
  if (drawn_ && now - last_ < kRefresh) return;
  last_ = now;
  const int filled = std::clamp(static_cast<int>(fraction * kBarWidth), 0, kBarWidth);
  fmt::print(stderr, "\r\x1b[K{:<12} [{:#<{}}{:.<{}}] {:3.0f} %  {}", stage, "", filled, "", kBarWidth - filled,
             std::max(fraction, 0.0) * 100, detail);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace preshape::app
