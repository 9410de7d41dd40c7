#pragma once

#include <map>
#include <memory>
#include <string>

#include "preshape/script/script.h"
#include "preshape/workbench/catalogue.h"
#include "support/data.h"
#include "support/registry.h"

namespace preshape::test {

/// A hand by its description file.
inline std::shared_ptr<const HandModel> hand_of(const std::filesystem::path& file) {
  ScriptOptions options;
  options.module_roots = {source_file("scripts")};
  const Value description = Script(file, options).run();
  return registry().create<HandModel>(description.find("model")->string(), Value::table({{"description", description}}));
}

/// Every hand in hands/, by its name.
inline const std::map<std::string, std::shared_ptr<const HandModel>>& shipped_hands() {
  static const auto hands = [] {
    std::map<std::string, std::shared_ptr<const HandModel>> all;
    for (const auto& name : Catalogue({source_file(".")}).hands()) all[name] = hand_of(source_file("hands") / name / "hand.lua");
    return all;
  }();
  return hands;
}

}  // namespace preshape::test
