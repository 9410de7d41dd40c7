#pragma once

#include <string>
#include <utility>

#include "preshape/script/script.h"
#include "preshape/workbench/scenario.h"
#include "preshape/workbench/session.h"
#include "support/data.h"
#include "support/registry.h"

namespace preshape::test {

/// The objects, hands and scripts of the source tree.
inline const Catalogue& catalogue() {
  static const Catalogue catalogue({PRESHAPE_SOURCE_DIR});
  return catalogue;
}

/// What a script called scenario.lua describes, checked.
inline ScenarioReading read_text(const std::string& text, ScenarioUse use = ScenarioUse::kRun,
                                 const std::filesystem::path& file = "scenario.lua") {
  return read_scenario(Script::from_text(text, "scenario.lua").run(), file, use, registry(), catalogue());
}

/// All mistakes, a line each.
inline std::string mistakes_of(const ScenarioReading& reading) {
  std::string text;
  for (const Mistake& mistake : reading.mistakes) text += mistake.text() + "\n";
  return text;
}

/// A session on the scenario of a script without mistakes.
inline Session session_of(const std::string& text, Session::Options options = {}) {
  ScenarioReading reading = read_text(text);
  REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
  return Session(std::move(reading.scenario), registry(), catalogue(), std::move(options));
}

}  // namespace preshape::test
