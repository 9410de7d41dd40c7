// What the command says of components to machines and on pages; the pages in the tree are what it writes.
#include <nlohmann/json.hpp>

#include "command.h"
#include "preshape/plugin/capabilities.h"
#include "preshape/plugin/kind.h"
#include "preshape/workbench/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("app");

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("Pages: docs/reference.md and scripts/meta/preshape.lua are what the command writes; ninja preshape_pages mends them") {
  const CommandLine cli;
  const auto json = nlohmann::json::parse(cli.run("plugins --json").out);
  const std::string page = read_text(source_file("docs/reference.md"));
  bool whole = true;  // not where a library is absent and the plugin that needs it was left out
  for (const auto& line : lines_of(page)) {
    if (!line.starts_with("### ")) continue;
    const std::string key = line.substr(4, line.find(' ', 4) - 4) + "/" + line.substr(line.find('`') + 1, line.rfind('`') - line.find('`') - 1);
    if (cli.run(fmt::format("plugins {} --exists", key)).exit_code == 0) continue;
    MESSAGE("skipped: ", key, " is not built here, so the pages cannot be compared");
    whole = false;
  }
  if (!whole) return;
  CHECK(cli.run("plugins --markdown").out == page);
  CHECK(cli.run("lua-meta").out == read_text(source_file("scripts/meta/preshape.lua")));
}

TEST_CASE("Pages: the reference has every component with its promises and every parameter") {
  const CommandLine cli;
  const std::string page = cli.run("plugins --markdown").out;
  const auto json = nlohmann::json::parse(cli.run("plugins --json").out);
  REQUIRE(json["components"].size() >= 10);
  for (const auto& component : json["components"]) {
    const std::string kind = component["kind"], name = component["name"];
    const auto begin = page.find(fmt::format("### {} `{}`\n", kind, name));
    INFO(kind, " ", name);
    REQUIRE(begin != std::string::npos);
    const std::string section = page.substr(begin, page.find("\n### ", begin + 1) - begin);
    for (const auto& capability : component["capabilities"]) {
      CHECK(is_capability(kind, capability.get<std::string>()));
      CHECK(contains(section, fmt::format("- `{}`: ", capability.get<std::string>())));
    }
    for (const auto& parameter : component["parameters"]) {
      CHECK(contains(section, fmt::format("\n| {} | {} | ", parameter["name"].get<std::string>(), parameter["unit"].get<std::string>())));
    }
  }
  for (const auto kind : kKinds) CHECK(contains(page, fmt::format("\n| {} | ", kind)));
}

TEST_CASE("plugins: a component that throws when it is made is listed and shown, for none is made") {
  const CommandLine cli;
  const std::string path = fmt::format("--plugin-path '{}/tests/core/plugin/fixtures/throws' ", PRESHAPE_BINARY_DIR);
  for (const char* how : {"plugins", "plugins --json", "plugins --markdown", "plugins similarity/throws", "plugins similarity/throws --json"}) {
    const auto result = cli.run(path + how);
    INFO(how, ": ", result.err);
    CHECK(result.exit_code == 0);
    CHECK(contains(result.out, "throws"));
  }
}

TEST_CASE("plugins: --exists says nothing, exits 0 or 5, and loads nothing") {
  const CommandLine cli;
  CHECK(cli.run("plugins contact/salisbury_soft_finger --exists").exit_code == 0);
  CHECK(cli.run("plugins tfvadi --exists").exit_code == 0);
  const auto absent = cli.run("plugins contact/tfvadi --exists");
  CHECK(absent.exit_code == 5);
  CHECK(absent.out + absent.err == "");
  CHECK(cli.run("plugins --exists").exit_code == 2);
  CHECK(cli.run("plugins tfvadi --exists --json").exit_code == 2);
  // Loading this one would find that its entry is missing.
  const std::string path = fmt::format("--plugin-path '{}/tests/core/plugin/fixtures/no_entry' ", PRESHAPE_BINARY_DIR);
  CHECK(cli.run(path + "plugins similarity/no_entry --exists").exit_code == 0);
  const auto json = nlohmann::json::parse(cli.run(path + "plugins --json").out);
  REQUIRE(json["unusable"].size() == 1);
  CHECK(json["unusable"][0]["name"] == "no_entry");
  CHECK(contains(json["unusable"][0]["reason"], "does not export 'preshape_entry'"));
}

TEST_CASE("plugins: --json has bounds and choices as data, and every library with why it is not used") {
  const CommandLine cli;
  const std::string path = fmt::format("--plugin-path '{}/tests/core/plugin/fixtures/other_sdk' ", PRESHAPE_BINARY_DIR);
  const auto json = nlohmann::json::parse(cli.run(path + "plugins --json").out);
  CHECK(json["schema"] == "preshape-plugins/1");
  nlohmann::json soft;
  for (const auto& component : json["components"]) {
    if (component["name"] == "salisbury_soft_finger") soft = component;
  }
  REQUIRE(soft["parameters"].size() == 5);
  CHECK(soft["language"] == "C++");
  CHECK(soft["parameters"][0]["minimum"] == 0.0);
  CHECK(soft["parameters"][0]["maximum"] == 10.0);
  CHECK(soft["parameters"][0]["choices"].empty());
  CHECK(soft["parameters"][4]["minimum"].is_null());
  bool refused = false;
  for (const auto& library : json["libraries"]) {
    if (library["name"] != "marks") continue;
    refused = library["status"] == "refused" && contains(library["reasons"][0], "SDK major version: plugin 7, host 0") &&
              library["components"][0] == "similarity/marks" && library["found_in"] == "--plugin-path";
  }
  CHECK(refused);
}

TEST_CASE("Scripts: preshape.components gives records of one kind or of all, and refuses a kind that is none") {
  const CommandLine cli;
  write_text(cli / "s.lua", "local c = preshape.components('contact')\n"
                            "assert(#preshape.components() > #c)\n"
                            "local soft\n"
                            "for _, one in ipairs(c) do assert(one.kind == 'contact') if one.name == 'salisbury_soft_finger' then soft = one end end\n"
                            "assert(soft.parameters[1].name == 'ka' and soft.parameters[1].maximum == 10)\n"
                            "print(pcall(preshape.components, 'contct'))\n"
                            "return { count = #c }\n");
  const auto result = cli.run("run s.lua");
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "there is no kind \"contct\"; did you mean 'contact'?"));
}

TEST_CASE("lua-meta: it is Lua, and the names of the module are those that a script sees, in both directions") {
  const CommandLine cli;
  REQUIRE(cli.run("lua-meta meta.lua").exit_code == 0);
  write_text(cli / "annotated.lua", "dofile(arg[1]) local names = {} for name in pairs(preshape) do names[#names + 1] = name end\n"
                                    "table.sort(names) print(table.concat(names, '\\n'))\n");
  const std::string run = fmt::format("lua5.4 '{}' '{}' > '{}' 2>&1", (cli / "annotated.lua").string(), (cli / "meta.lua").string(),
                                      (cli / "annotated").string());
  REQUIRE(std::system(run.c_str()) == 0);
  write_text(cli / "seen.lua", "for name, value in pairs(preshape) do if type(value) == 'function' then print(name) end end return {}\n");
  const auto seen = cli.run("run seen.lua");
  INFO(seen.err);
  REQUIRE(seen.exit_code == 0);
  CHECK(read_text(cli / "annotated") == seen.out);
  CHECK(contains(seen.out, "components\n"));
}

TEST_CASE("lua-meta: the scenario has every key with a type, and no other; every component its parameters") {
  const CommandLine cli;
  const std::string meta = cli.run("lua-meta").out;
  const auto begin = meta.find("---@class (exact) preshape.Scenario\n");
  REQUIRE(begin != std::string::npos);
  const auto fields = lines_of(meta.substr(begin, meta.find("\n\n", begin) - begin));
  CHECK(fields.size() == scenario_keys().size() + 1);
  for (const auto& key : scenario_keys()) {
    INFO(key.name);
    CHECK((contains(meta, "\n---@field " + key.name + " ") || contains(meta, "\n---@field " + key.name + "? ")));
    CHECK_FALSE(contains(meta, "---@field " + key.name + "? any "));  // a kind of value that key_type does not know
  }
  const auto json = nlohmann::json::parse(cli.run("plugins --json").out);
  for (const auto& component : json["components"]) {
    const std::string kind = component["kind"], name = component["name"];
    const auto at = meta.find(fmt::format("preshape.{}.{}\n", kind, name));
    INFO(kind, " ", name);
    REQUIRE(at != std::string::npos);
    const std::string text = meta.substr(at, meta.find("\n\n", at) - at);
    if (kind == "hand" && contains(text, "[string] any")) continue;
    for (const auto& parameter : component["parameters"]) CHECK(contains(text, "\n---@field " + parameter["name"].get<std::string>()));
  }
}

TEST_CASE("lua-meta: a component's file may say what its class has, and a template in Lua says nothing else") {
  const CommandLine cli;
  const std::string meta = cli.run("lua-meta").out;
  for (const auto kind : kKinds) {
    if (kind == "collision") continue;
    const std::string big = std::string(1, static_cast<char>(kind[0] - 'a' + 'A')) + std::string(kind.substr(1));
    const auto fields_of = [&](const std::string& name) {
      const auto begin = meta.find("---@class (exact) preshape." + big + name + "\n");
      REQUIRE(begin != std::string::npos);
      return meta.substr(begin, meta.find("\n\n", begin) - begin);
    };
    const std::string file = fields_of("Component"), instance = fields_of("Instance");
    bool in_file = false, in_instance = false;  // by the templates' own indentation
    int keys = 0;
    for (const auto& line : lines_of(read_text(source_file(fmt::format("core/app/templates/lua/{}/NAME.plugin.lua", kind))))) {
      if (line == "return {") in_file = true;
      if (line == "    return {") in_instance = true;
      if (line == "    }") in_instance = false;
      const auto indent = line.find_first_not_of(' ');
      const auto equals = line.find(" = ");
      const bool is_key = equals != std::string::npos && ((in_file && indent == 2) || (in_instance && indent == 6));
      if (!is_key || line[indent] == '-') continue;
      const std::string key = line.substr(indent, equals - indent);
      INFO(kind, ": ", key);
      const std::string& known = indent == 2 ? file : instance;
      CHECK((contains(known, "---@field " + key + " ") || contains(known, "---@field " + key + "? ")));
      ++keys;
    }
    CHECK(keys >= 10);
  }
}

TEST_CASE("lua-meta: with --plugin-path a person's own components are in it") {
  const CommandLine cli;
  const std::string path = fmt::format("--plugin-path '{}/tests/core/plugin/fixtures/family' ", PRESHAPE_BINARY_DIR);
  CHECK(contains(cli.run(path + "lua-meta").out, "---@class (exact) preshape.contact.normal\n"));
  CHECK_FALSE(contains(cli.run("lua-meta").out, "preshape.contact.normal\n"));
}

TEST_SUITE_END();
