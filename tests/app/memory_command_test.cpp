#include "command.h"

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

TEST_CASE("pretrain: 24 rows on the cube, none wrong; again adds nothing") {
  const CommandLine cli;
  const auto first = cli.run("pretrain --memory m.memory");
  INFO(first.err);
  CHECK(first.exit_code == 0);
  CHECK(contains(first.out, "24 of 24 stations taught on the cube, 24 new rows; training arrived"));
  CHECK(contains(first.out, "0 rows wrong"));
  CHECK(contains(cli.run("pretrain --memory m.memory").out, "0 new rows"));
}

TEST_CASE("memory: export, import into another, export again: the same bytes") {
  const CommandLine cli;
  REQUIRE(cli.run("pretrain --memory a.memory").exit_code == 0);
  CHECK(cli.run("memory export --memory a.memory a.csv").exit_code == 0);
  CHECK(contains(cli.run("memory import --memory b.memory a.csv").out, "24 samples imported"));
  CHECK(cli.run("memory export --memory b.memory b.csv").exit_code == 0);
  CHECK(read_text(cli / "a.csv") == read_text(cli / "b.csv"));
  CHECK(contains(cli.run("memory export --memory b.memory").out, "kilotriangles"));
}

TEST_CASE("memory: a broken CSV is refused whole, with line and column, and the memory stays as it was") {
  const CommandLine cli;
  REQUIRE(cli.run("pretrain --memory a.memory").exit_code == 0);
  REQUIRE(cli.run("memory export --memory a.memory a.csv").exit_code == 0);
  std::string text = read_text(cli / "a.csv");
  const auto last_line = text.rfind('\n', text.size() - 2);
  text.insert(text.find(',', last_line) + 1, "x");
  write_text(cli / "broken.csv", text);
  const auto result = cli.run("memory import --memory b.memory broken.csv");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "broken.csv:"));
  CHECK(contains(cli.run("memory show --memory b.memory").out, "0 samples"));
}

TEST_CASE("memory: an object is forgotten by name with its samples; a misspelt name suggests the right one") {
  const CommandLine cli;
  REQUIRE(cli.run("pretrain --memory a.memory").exit_code == 0);
  const auto wrong = cli.run("memory forget --memory a.memory cbue");
  CHECK(wrong.exit_code == 5);
  CHECK(contains(wrong.err, "did you mean 'cube'?"));
  CHECK(contains(cli.run("memory forget --memory a.memory cube").out, "24 samples"));
  CHECK(contains(cli.run("memory show --memory a.memory").out, "0 samples"));
}

TEST_CASE("memory: a file that is no memory is refused and left as it is") {
  const CommandLine cli;
  write_text(cli / "notes.memory", "these are notes\n");
  const auto result = cli.run("pretrain --memory notes.memory");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "notes.memory"));
  CHECK(read_text(cli / "notes.memory") == "these are notes\n");
  CHECK(cli.run("memory show --memory absent.memory").exit_code == 5);
}

TEST_CASE("memory list: names what is in the user's folder") {
  const CommandLine cli;
  CHECK(contains(cli.run("memory list").out, "There is no memory"));
  REQUIRE(cli.run("pretrain").exit_code == 0);
  CHECK(contains(cli.run("memory list").out, "default"));
}

TEST_SUITE_END();
