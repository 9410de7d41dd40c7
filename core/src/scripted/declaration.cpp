#include "declaration.h"

#include <algorithm>

#include <fmt/format.h>

#include "keys.h"
#include "parameter_reader.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/plugin/capabilities.h"
#include "script/convert.h"

namespace preshape::scripted {

namespace {

/// A declaration is a table; what takes longer than this is a mistake.
constexpr std::int64_t kScanInstructions = 20'000'000;

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all(kKinds.begin(), kKinds.end());
    std::erase(all, "collision");
    return all;
  }();
  return kinds;
}

Keys declaration_keys() {
  Keys keys;
  keys.owner = "component";
  keys.data = {required_choice("kind", kinds(), "what it is: contact, similarity, ..."),
               required_text("name", "its name, that of its file"),
               required_text("version", "such as \"1.0.0\""),
               required_text("licence", "such as \"BSD-3-Clause\""),
               required_text("author", "who wrote it"),
               required_text("summary", "one line"),
               optional_table("capabilities", "what it promises"),
               optional_table("parameters", "what can be set")};
  keys.functions = {"new"};
  return keys;
}

/// A manifest of nobody, made by this host.
Manifest blank_manifest() {
  Manifest manifest{};
  std::copy(std::begin(kManifestMagic), std::end(kManifestMagic), manifest.magic);
  manifest.size = sizeof(Manifest);
  manifest.format = kManifestFormat;
  manifest.fingerprint = host_fingerprint();
  return manifest;
}

/// The whole table with its places.
class Reader {
 public:
  Reader(const ComponentSource& source, Value table)
      : source_(source), table_(std::move(table)), place_(table_.place()) {
    declaration_.manifest = blank_manifest();
    if (!place_.known()) place_ = {source.shown, 0};
  }

  Declaration read() {
    // A kind that may not be scripted is told as such, before the list of those that may.
    if (const Value* kind = table_.find("kind"); kind && *kind == Value("collision")) {
      refuse(place_of(*kind, place_), "component",
             "a collision backend cannot be written in Lua; write it in C++ (docs/architecture.md)");
    }
    values_ = declaration_keys().check(table_, place_);
    read_identity();
    read_capabilities();
    auto& parameters = declaration_.component.parameters;
    for (const Value& parameter : list("parameters")) {
      parameters.push_back(read_parameter(parameter, place_at("parameters"), parameters));
    }
    return std::move(declaration_);
  }

 private:
  SourcePlace place_at(std::string_view key) const {
    const Value* value = table_.find(key);
    return value ? place_of(*value, place_) : place_;
  }

  std::span<const Value> list(const char* key) const {
    const Value& value = values_.value(key);
    if (!value.is_list()) refuse(place_at(key), "component", fmt::format("'{}' must be a list", key));
    return value.items();
  }

  template <std::size_t N>
  void fill(char (&to)[N], const char* key, std::string_view text) const {
    if (text.empty()) refuse(place_at(key), "component", fmt::format("'{}' is empty", key));
    if (text.size() >= N) {
      refuse(place_at(key), "component",
             fmt::format("'{}' has {} bytes, there is room for {}; shorten it", key, text.size(), N - 1));
    }
    detail::copy_text(to, text);
  }

  void read_identity() {
    Manifest& manifest = declaration_.manifest;
    ComponentDeclaration& component = declaration_.component;
    component.kind = values_.text("kind");
    component.name = values_.text("name");
    component.summary = values_.text("summary");
    if (!is_name(component.name)) {
      refuse(place_at("name"), "component",
             fmt::format("'{}' is no name: letters, digits and '_' make one", component.name));
    }
    if (component.name != name_of(source_.file)) {
      refuse(place_at("name"), "component",
             fmt::format("its name is '{}' but its file is '{}'; call the file '{}{}'", component.name,
                         source_.file.filename().string(), component.name, kFileEnding));
    }
    fill(manifest.name, "name", component.name);
    fill(manifest.version, "version", values_.text("version"));
    fill(manifest.licence, "licence", values_.text("licence"));
    fill(manifest.author, "author", values_.text("author"));
    fill(manifest.summary, "summary", values_.text("summary"));
    manifest.component_count = 1;
    fill(manifest.components[0], "name", fmt::format("{}/{}", component.kind, component.name));
  }

  void read_capabilities() {
    const std::string& kind = declaration_.component.kind;
    std::vector<std::string> known;
    for (const Capability& c : capabilities()) {
      if (c.kind.empty() || c.kind == kind) known.emplace_back(c.name);
    }
    for (const Value& capability : list("capabilities")) {
      const SourcePlace place = place_of(capability, place_at("capabilities"));
      if (!capability.is_string()) {
        refuse(place, "component", fmt::format("a capability is a text, got {}", capability.text()));
      }
      if (!is_capability(kind, capability.string())) {
        refuse(place, "component",
               fmt::format("a {} cannot promise '{}'{}", kind, capability.string(),
                           did_you_mean(capability.string(), known)));
      }
      if (capability.string() == "propagates_nonfinite") {
        refuse(place, "component", "Lua is given finite numbers alone; promise 'rejects_nonfinite' instead");
      }
      declaration_.component.capabilities.push_back(capability.string());
    }
  }

  const ComponentSource& source_;
  const Value table_;
  SourcePlace place_;
  Parameters values_;
  Declaration declaration_;
};

/// The table that the file returns; nil where it does not come so far.
Value run_file(const ComponentSource& source) {
  const auto host = open_host(source, true);
  host->instructions.limit = kScanInstructions;
  Value table;
  host->enter([&](lua_State* L) {
    push_component(L, source);
    table = lua::to_value(L, -1, {source.shown, 0});
  });
  return table;
}

Manifest manifest_of_faulty(const std::string& kind, const std::string& name) {
  Manifest manifest = blank_manifest();
  detail::copy_text(manifest.name, name.substr(0, sizeof manifest.name - 1));
  detail::copy_text(manifest.version, "-");
  manifest.component_count = 1;
  detail::copy_text(manifest.components[0], fmt::format("{}/{}", kind, name.substr(0, 60)));
  return manifest;
}

}  // namespace

std::string name_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.size() - std::min(name.size(), kFileEnding.size()));
}

Declaration read_declaration(const ComponentSource& source) {
  return Reader(source, run_file(source)).read();
}

ManifestReading read_manifest_of(const std::filesystem::path& file,
                                 std::vector<std::filesystem::path> module_roots) {
  using Status = ManifestReading::Status;
  std::string kind;
  try {
    const auto source = ComponentSource::read(file, std::move(module_roots));
    const Value table = run_file(source);
    const Value* told = table.find("kind");
    if (told && told->is_string() && std::count(kinds().begin(), kinds().end(), told->string()))
      kind = told->string();
    return {Status::kFound, "", Reader(source, table).read().manifest};
  } catch (const Error& mistake) {
    return {Status::kBroken, mistake.what(), manifest_of_faulty(kind, name_of(file))};
  }
}

}  // namespace preshape::scripted
