// `preshape new-plugin`: what it refuses, and that it overwrites nothing.
#include "app/command.h"
#include "preshape/plugin/kind.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("sdk");

TEST_CASE("new-plugin: it lists what it wrote, and no placeholder is left in it") {
  const CommandLine cli;
  for (const auto kind : kKinds) {
    const auto result = cli.run(fmt::format("new-plugin {0} fresh_{0}", kind));
    INFO(kind, ": ", result.err);
    CHECK(result.exit_code == 0);
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(cli / fmt::format("fresh_{}", kind))) {
      ++files;
      INFO(entry.path().string());
      CHECK(contains(result.out, entry.path().filename().string() + "\n"));
      const std::string text = read_text(entry.path());
      CHECK_FALSE(text.empty());
      for (const char* word : {"@NAME@", "@CLASS@", "@KIND@", "@VERSION@"}) CHECK_FALSE(contains(text, word));
    }
    CHECK(files == 5);
  }
}

TEST_CASE("new-plugin: a wrong kind or name is wrong use, told with the mend, and nothing is written") {
  const CommandLine cli;
  const auto kind = cli.run("new-plugin contakt mine");
  CHECK(kind.exit_code == 2);
  CHECK(contains(kind.err, "there is no kind 'contakt'; did you mean 'contact'?"));
  for (const char* name : {"Mine", "2nd", "my-model", "my__model", "mine_", "_mine", "../mine", "a/b", "''",
                           "a23456789012345678901234567890123456789012345678x"}) {
    const auto result = cli.run(fmt::format("new-plugin contact {}", name));
    INFO(name, ": ", result.err);
    CHECK(result.exit_code == 2);
    CHECK(contains(result.err, "a component's name is of small letters, digits and single underscores"));
  }
  const auto lua = cli.run("new-plugin collision mine --lua");
  CHECK(lua.exit_code == 2);
  CHECK(contains(lua.err, "cannot be written in Lua"));
  CHECK_FALSE(std::filesystem::exists(cli / "mine"));
}

TEST_CASE("new-plugin: what is there already is left as it is, also a link to nowhere") {
  const CommandLine cli;
  write_text(cli / "mine", "precious");
  const auto result = cli.run("new-plugin contact mine");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "is there already and is left as it is"));
  CHECK(read_text(cli / "mine") == "precious");
  std::filesystem::create_symlink("nowhere", cli / "link");
  CHECK(cli.run("new-plugin contact link").exit_code == 5);
  CHECK_FALSE(std::filesystem::exists(cli / "nowhere"));
}

TEST_CASE("new-plugin: --folder says where, and a folder that is not there is bad input") {
  const CommandLine cli;
  std::filesystem::create_directory(cli / "models");
  CHECK(cli.run("new-plugin quality even --folder models").exit_code == 0);
  CHECK(std::filesystem::exists(cli / "models" / "even" / "even.cpp"));
  const auto result = cli.run("new-plugin quality even --folder nowhere");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "cannot be made; check that its folder exists"));
}

TEST_CASE("new-plugin: a name that is taken is told, and written all the same") {
  const CommandLine cli;
  const auto result = cli.run("new-plugin collision brute");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "there is a collision 'brute' already; the one that is found first is used"));
}

TEST_SUITE_END();
