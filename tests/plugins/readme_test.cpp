// Each shipped component's page has the parameter table that its declaration says.
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

/// The page of a shipped component: a plugin's README, or the comment at the head of a component in Lua.
std::string page_of(const ComponentRecord& record) {
  if (record.language == "C++") return read(source_file("plugins") / record.kind / record.name / "README.md");
  std::istringstream lines(read(record.file));
  std::string page, line;
  while (std::getline(lines, line) && line.starts_with("--")) page += line.substr(line.starts_with("-- ") ? 3 : 2) + "\n";
  return page;
}

}  // namespace

TEST_CASE("READMEs: every parameter of every shipped component stands in its table with unit, range, default and meaning") {
  for (const auto& key : registry().components()) {
    INFO(key.kind, " ", key.name);
    const ComponentRecord& record = registry().describe(key.kind, key.name);
    const std::string page = page_of(record);
    CHECK(page.starts_with(fmt::format("{}{} `{}`\n", record.language == "C++" ? "# " : "", key.kind, key.name)));
    for (const char* part : {record.language == "C++" ? "## " : "Use:", "Known "}) CHECK(page.find(part) != std::string::npos);
    for (const auto& declaration : record.schema.declarations()) {
      const auto cells = row_of(page, declaration.name);
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
