// Each shipped plugin's README has the parameter table that its declaration says.
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "support/data.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins");

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string default_text(const ParameterDeclaration& declaration) {
  const Value& value = declaration.default_value;
  if (value.is_nil()) return "must be given";
  if (value.is_number()) return number_text(value.number());
  return value.is_string() ? value.string() : value.text();
}

/// The cells of the table row that begins with `name`, trimmed; a bar in a cell is written \|.
std::vector<std::string> row_of(const std::string& readme, const std::string& name) {
  std::istringstream lines(readme);
  std::string line;
  while (std::getline(lines, line)) {
    if (!line.starts_with("| " + name + " |")) continue;
    std::vector<std::string> cells(1);
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') cells.back() += line[++i];
      else if (line[i] == '|') cells.emplace_back();
      else cells.back() += line[i];
    }
    for (auto& cell : cells) {
      while (!cell.empty() && cell.front() == ' ') cell.erase(0, 1);
      while (!cell.empty() && cell.back() == ' ') cell.pop_back();
    }
    return cells;
  }
  return {};
}

}  // namespace

TEST_CASE("READMEs: every parameter of every shipped component stands in its table with unit, range, default and meaning") {
  for (const auto& key : registry().components()) {
    const auto path = source_file("plugins") / key.kind / key.name / "README.md";
    INFO(path.string());
    REQUIRE(std::filesystem::exists(path));
    const std::string readme = read(path);
    CHECK(readme.starts_with(fmt::format("# {} `{}`", key.kind, key.name)));
    for (const auto& declaration : registry().describe(key.kind, key.name).schema.declarations()) {
      const auto cells = row_of(readme, declaration.name);
      INFO("parameter ", declaration.name);
      REQUIRE(cells.size() >= 5);
      CHECK(cells[1] == declaration.unit);
      CHECK(cells[2] == declaration.bounds_text());
      CHECK(cells[3] == default_text(declaration));
      CHECK(cells[4] == declaration.text);
    }
  }
}

TEST_SUITE_END();
