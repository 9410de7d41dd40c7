// docs/plugin-authors.md does what it says, block by block; and the templates in Lua.
#include "installation.h"
#include "preshape/plugin/kind.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("sdk");

namespace {

struct Block {
  std::string language, text;
};

std::vector<Block> blocks_of(const std::string& markdown) {
  std::vector<Block> blocks;
  for (auto at = markdown.find("```"); at != std::string::npos; at = markdown.find("```", at + 3)) {
    const auto line = markdown.find('\n', at), end = markdown.find("```", line);
    blocks.push_back({markdown.substr(at + 3, line - at - 3), markdown.substr(line + 1, end - line - 1)});
    at = end;
  }
  return blocks;
}

/// "// sorensen/sorensen.cpp" -> "sorensen/sorensen.cpp": a file's first line names it.
std::string name_of(const Block& block) {
  const std::string line = block.text.substr(0, block.text.find('\n'));
  return line.substr(line.find(' ') + 1);
}

}  // namespace

TEST_CASE("Walk-through: every file and command of plugin-authors.md, in order, in an empty folder") {
  const fs::path folder = installation().parent_path() / "walk_through";
  fs::create_directories(folder);
  int files = 0, commands = 0;
  for (const Block& block : blocks_of(read_file(source_file("docs/plugin-authors.md")))) {
    INFO(block.text);
    if (block.language == "sh") {
      const auto result = shell(folder, block.text);
      INFO(result.output);
      REQUIRE(result.exit_code == 0);
      ++commands;
    } else {
      const fs::path file = folder / name_of(block);
      REQUIRE(file.has_extension());
      fs::create_directories(file.parent_path());
      std::ofstream(file) << block.text;
      ++files;
    }
  }
  CHECK(files == 5);
  CHECK(commands >= 8);
}

TEST_CASE("Templates in Lua: the commands of every kind's README do what they say") {
  const fs::path folder = installation().parent_path() / "lua";
  fs::create_directories(folder);
  for (const auto kind : kKinds) {
    if (kind == "collision") continue;
    const auto made = shell(folder, fmt::format("preshape new-plugin {0} my_{0} --lua", kind));
    INFO(kind, ": ", made.output);
    REQUIRE(made.exit_code == 0);
    const fs::path own = folder / fmt::format("my_{}", kind);
    const std::string readme = read_file(own / "README.md");
    const auto blocks = fenced_blocks(readme, "sh");
    REQUIRE(blocks.size() == 1);
    const auto result = shell(own, blocks[0]);
    INFO(result.output);
    CHECK(result.exit_code == 0);
    const auto told = shell(own, fmt::format("preshape --plugin-path . plugins {0}/my_{0} --markdown", kind));
    const auto table = told.output.find("| name | unit |");
    REQUIRE(table != std::string::npos);
    CHECK(readme.find(told.output.substr(table, told.output.find("\n\n", table) - table)) != std::string::npos);
  }
}

TEST_SUITE_END();
