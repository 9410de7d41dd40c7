#include "preshape/workbench/variants.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/agent/settings.h"
#include "preshape/base/error.h"
#include "scenario_parts.h"

namespace preshape {

namespace {

/// A key that gives a list where it gives one.
struct Axis {
  std::string key, parameter;  ///< "contact" and "mu", or "contact" and ""
  std::vector<Value> choices;
  std::string name() const { return parameter.empty() ? key : key + "." + parameter; }
};

bool all_items(const Value& list, bool (*holds)(const Value&)) {
  return list.is_list() && !list.items().empty() && std::all_of(list.items().begin(), list.items().end(), holds);
}

bool is_list(const Value& value) { return value.is_list(); }
bool is_integer(const Value& value) { return value.is_integer(); }
bool is_choice_of_planes(const Value& value) { return value.is_list() || value.find("directions") || value.find("rolls"); }
bool is_no_number(const Value& value) { return !value.is_number(); }

/// Whether the value of a scenario's key is a list of such values.
bool gives_choices(const ScenarioPart& part, const Value& value) {
  switch (part.takes) {
    case ScenarioPart::Takes::kName: return value.is_list() && value.items().size() > 1;
    case ScenarioPart::Takes::kTask: return all_items(value, is_no_number);
    case ScenarioPart::Takes::kList: return all_items(value, is_list);
    case ScenarioPart::Takes::kPlanes: return all_items(value, is_choice_of_planes);
    case ScenarioPart::Takes::kInteger: return all_items(value, is_integer);
    case ScenarioPart::Takes::kOther: return false;
  }
  return false;
}

/// The first parameter of a table that is given a list where it is declared to take one value.
std::optional<Axis> parameter_axis(const std::string& key, const Value& table, const ParameterSchema& schema) {
  if (!table.is_table()) return std::nullopt;
  for (const auto& [name, value] : table.entries()) {
    const ParameterDeclaration* declared = schema.find(name);
    if (!declared || declared->type == ParameterType::kTable) continue;
    const bool takes_list = declared->type == ParameterType::kNumbers;
    if (takes_list ? all_items(value, is_list) : value.is_list() && !value.items().empty()) return Axis{key, name, value.items()};
  }
  return std::nullopt;
}

class Expansion {
 public:
  Expansion(const Registry& registry, Variants& variants) : registry_(registry), variants_(variants) {}

  void expand(const Value& description) {
    const auto axis = first_axis(description);
    if (!axis) {
      if (variants_.all.size() == kMostVariants) {
        throw InputError(fmt::format("the scenario's lists give more than {} combinations; shorten them", kMostVariants));
      }
      variants_.all.push_back({description, chosen_});
      return;
    }
    const std::size_t at = index_of(axis->name());
    for (const Value& choice : axis->choices) {
      Value one = description;
      if (axis->parameter.empty()) one.set(axis->key, choice);
      else one.find(axis->key)->set(axis->parameter, choice);
      chosen_.resize(variants_.keys.size());
      chosen_[at] = choice;
      expand(one);
      chosen_[at] = {};
    }
  }

 private:
  std::size_t index_of(const std::string& name) {
    auto& keys = variants_.keys;
    const auto found = std::find(keys.begin(), keys.end(), name);
    if (found != keys.end()) return static_cast<std::size_t>(found - keys.begin());
    keys.push_back(name);
    return keys.size() - 1;
  }

  std::optional<Axis> first_axis(const Value& description) const {
    for (const ScenarioPart& part : scenario_parts()) {
      const Value* value = description.find(part.key);
      if (!value) continue;
      if (gives_choices(part, *value)) return Axis{part.key, "", value->items()};
      if (auto axis = parameter_axis(part.key, *value, schema_of(part, *value))) return axis;
    }
    return std::nullopt;
  }

  /// The declared parameters of what stands at a key; none where nothing of that name can be loaded.
  ParameterSchema schema_of(const ScenarioPart& part, const Value& value) const {
    if (part.schema) return part.schema();
    if (part.kind.empty() || !value.is_table()) return {};
    const Value* name = value.find("name");
    try {
      const auto& own = registry_.describe(part.kind, name && name->is_string() ? name->string() : part.standard).schema;
      std::vector<ParameterDeclaration> all(own.declarations().begin(), own.declarations().end());
      if (part.kind == "explorer") {
        for (const auto& declaration : exploration_schema().declarations()) {
          if (!own.find(declaration.name)) all.push_back(declaration);
        }
      }
      return ParameterSchema(own.owner(), std::move(all));
    } catch (const PluginError&) {
      return {};
    }
  }

  const Registry& registry_;
  Variants& variants_;
  std::vector<Value> chosen_;
};

/// What the combination starts from: what the memory's file holds, in no file.
std::shared_ptr<Memory> copy_of_memory(const std::string& name) {
  const auto path = memory_path(name);
  std::error_code error;
  if (path.string().starts_with(":memory:") || !std::filesystem::exists(path, error)) {
    return std::make_shared<Memory>(Memory::in_memory());
  }
  return std::make_shared<Memory>(Memory::copy_of(path));
}

std::vector<Scenario> checked(const Variants& variants, const std::filesystem::path& file, const Registry& registry,
                              const Catalogue& catalogue) {
  std::vector<Scenario> scenarios;
  std::vector<std::string> mistakes;
  for (const Variant& variant : variants.all) {
    auto reading = read_scenario(variant.description, file, ScenarioUse::kRun, registry, catalogue);
    for (const auto& mistake : reading.mistakes) {
      if (std::find(mistakes.begin(), mistakes.end(), mistake.text()) == mistakes.end()) mistakes.push_back(mistake.text());
    }
    scenarios.push_back(std::move(reading.scenario));
  }
  if (!mistakes.empty()) throw ScriptError(fmt::format("{}", fmt::join(mistakes, "\n")));
  return scenarios;
}

}  // namespace

Variants variants_of(const Value& description, const Registry& registry) {
  Variants variants;
  if (description.is_table()) Expansion(registry, variants).expand(description);
  else variants.all.push_back({description, {}});
  for (auto& variant : variants.all) variant.choices.resize(variants.keys.size());
  return variants;
}

Comparison compare(const Variants& variants, const std::filesystem::path& file, const Registry& registry,
                   const Catalogue& catalogue, const Session::Options& options,
                   const std::function<Value(const Value& report)>& control) {
  std::vector<Scenario> scenarios = checked(variants, file, registry, catalogue);
  Comparison comparison{file.string(), variants.keys, {}};
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (options.progress) {
      options.progress->advance("comparing", static_cast<double>(i) / static_cast<double>(scenarios.size()),
                                fmt::format("{} of {}", i + 1, scenarios.size()));
    }
    ComparedRun run{variants.all[i].choices, {}, {}};
    try {
      const std::string& memory = options.memory.empty() ? scenarios[i].memory : options.memory;
      Session session(std::move(scenarios[i]), registry, catalogue, {options.memory, nullptr, copy_of_memory(memory)});
      session.pretrain_if_empty();
      run.record = std::move(session.run(control).back());
    } catch (const InputError& refusal) {
      run.refusal = refusal.what();
    } catch (const PluginError& refusal) {
      run.refusal = refusal.what();
    }
    comparison.runs.push_back(std::move(run));
  }
  return comparison;
}

}  // namespace preshape
