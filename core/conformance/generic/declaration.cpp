// What a library and a component say of themselves.
#include <chrono>
#include <filesystem>
#include <regex>
#include <set>

#include "generic.h"
#include "preshape/plugin/capabilities.h"
#include "preshape/script/setting.h"

namespace preshape::conformance {

namespace {

std::string record_text(const ComponentRecord& record) {
  std::string text = fmt::format("{}/{} {} {} {} {}: {}\n", record.kind, record.name, record.plugin, record.version,
                                 record.licence, record.author, record.summary);
  for (const auto& capability : record.capabilities) text += capability + "\n";
  for (const auto& d : record.schema.declarations()) {
    text += fmt::format("{} {} {} {} [{}] {}\n", d.name, parameter_type_name(d.type), d.default_value.text(),
                        d.bounds_text(), d.unit, d.text);
  }
  return text;
}

/// The open files and the threads of this process.
std::set<std::string> files_and_threads() {
  std::set<std::string> found;
  for (const char* folder : {"/proc/self/fd", "/proc/self/task"}) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      const auto target = std::filesystem::read_symlink(entry.path(), error);
      // The listing itself is one of the open files.
      if (target.string().find("/proc/") == std::string::npos || std::string(folder).ends_with("task")) {
        found.insert(entry.path().string());
      }
    }
  }
  return found;
}

void check_default(Context& context, const ParameterDeclaration& d) {
  const Value& value = d.default_value;
  if (value.is_nil()) return;
  if (value.is_number()) {
    context.require(!(value.number() < d.minimum) && !(value.number() > d.maximum),
                    "parameter '{}': its default {} is outside its bounds {}", d.name, number_text(value.number()),
                    d.bounds_text());
  }
  if (d.type == ParameterType::kChoice) {
    context.require(std::find(d.choices.begin(), d.choices.end(), value.string()) != d.choices.end(),
                    "parameter '{}': its default '{}' is none of its choices", d.name, value.string());
  }
  context.require(parse_value(lua_source(value)) == value, "parameter '{}': its default does not read back as text",
                  d.name);
}

void check_parameter(Context& context, const ParameterDeclaration& d) {
  static const std::regex kName("[a-z][a-z0-9_]*");
  context.require(std::regex_match(d.name, kName), "parameter '{}' is not named in lower_snake_case", d.name);
  context.require(!d.text.empty(), "parameter '{}' has no text; say in a line what it is", d.name);
  context.require(d.text.find('\n') == std::string::npos, "parameter '{}': its text is more than a line", d.name);
  context.require(!d.unit.empty(), "parameter '{}' names no unit; \"-\" stands for none", d.name);
  context.require(d.type != ParameterType::kChoice || !d.choices.empty(), "parameter '{}' has no choices", d.name);
  check_default(context, d);
}

}  // namespace

void g01_manifest(Context& context) {
  static const std::regex kName("[a-z][a-z0-9_.-]*"), kVersion(R"(\d+\.\d+\.\d+([-+].*)?)"), kComponent("[a-z][a-z0-9_]*");
  const Manifest& manifest = context.registry().libraries().front().manifest;
  context.require(std::regex_match(manifest.name, kName), "its name '{}' is not lower case without blanks", manifest.name);
  context.require(std::regex_match(manifest.version, kVersion), "its version '{}' is not like 1.0.0", manifest.version);
  context.require(manifest.licence[0], "it names no licence");
  context.require(manifest.author[0], "it names no author");
  context.require(manifest.summary[0], "it has no summary");
  std::set<std::string> seen;
  for (std::uint32_t i = 0; i < manifest.component_count; ++i) {
    const std::string component = manifest.components[i];
    context.require(seen.insert(component).second, "it lists {} twice", component);
    const std::string name = component.substr(component.find('/') + 1);
    context.require(std::regex_match(name, kComponent), "the component name '{}' is not in lower_snake_case", name);
  }
  context.require(!context.record().summary.empty(), "the component has no summary");
}

std::string g02_declaration(Context& context, std::string_view) { return record_text(context.record()); }

void g02_same_everywhere(Context& context) {
  const std::string first = record_text(context.record());
  context.forget_registry();
  const std::string again = record_text(context.record());
  context.require(first == again, "loaded a second time it declares something else:\n{}\nbefore:\n{}", again, first);
  const std::string elsewhere = context.in_fresh_process("");
  context.require(first == elsewhere, "in another process it declares something else:\n{}\nhere:\n{}", elsewhere, first);
}

void g05_describe_is_light(Context& context) {
  const auto before = files_and_threads();
  const auto begin = std::chrono::steady_clock::now();
  context.record();
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  for (const auto& now : files_and_threads()) {
    context.require(before.contains(now), "loading it opened a file, a socket or a thread: {}", now);
  }
  if (took.count() > 50.0) context.warn(fmt::format("describing it took {:.0f} ms; 50 are plenty", took.count()));
}

void g07_declarations(Context& context) {
  std::set<std::string> names;
  for (const auto& d : context.record().schema.declarations()) {
    context.require(names.insert(d.name).second, "parameter '{}' is declared twice", d.name);
    check_parameter(context, d);
  }
  for (const auto& capability : context.record().capabilities) {
    context.require(is_capability(context.subject().kind, capability),
                    "it promises to be '{}', which no check of kind {} knows; see docs/conformance.md", capability,
                    context.subject().kind);
  }
}

}  // namespace preshape::conformance
