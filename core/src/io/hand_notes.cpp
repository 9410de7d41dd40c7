#include "preshape/io/hand_notes.h"

#include <fmt/format.h>

namespace preshape {

namespace {

constexpr std::size_t kTold = 5;

}  // namespace

std::vector<std::string> hand_notes(const HandModel& hand) {
  const auto* notes = static_cast<const std::vector<std::string>*>(hand.extension("hand/urdf/notes"));
  return notes ? *notes : std::vector<std::string>{};
}

std::vector<std::string> hand_notes_in_short(const HandModel& hand) {
  auto notes = hand_notes(hand);
  if (notes.size() <= kTold) return notes;
  const std::size_t more = notes.size() - kTold;
  notes.resize(kTold);
  notes.push_back(fmt::format("and {} more of the kind", more));
  return notes;
}

}  // namespace preshape
