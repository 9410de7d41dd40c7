// The verb that looks at fuzzy sets, and what `check` says of them.
#include "command.h"

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

namespace {

constexpr const char* kGappy =
    "return { object = 'cube', task = 'T1_2',\n"
    "  fuzzy = { { name = 'low', trapezoid = { -1, -1, -0.5, 0 } }, { name = 'high', trapezoid = { 0.25, 0.5, 1, 1 } } } }\n";

constexpr const char* kGapNote = "between -0.25 and 0.375 no set reaches 0.5; the best one's degree falls to 0 there\n";

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The words of the row that begins with `name`.
std::vector<std::string> row_of(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::string> row;
    for (std::string word; words >> word;) row.push_back(word);
    if (!row.empty() && row.front() == name) return row;
  }
  return {};
}

}  // namespace

TEST_CASE("sets: without a script the thesis's seven, with their crossings and nothing amiss") {
  const CommandLine cli;
  const auto result = cli.run("sets");
  CHECK(result.exit_code == 0);
  CHECK(row_of(result.out, "RwdH") ==
        std::vector<std::string>{"RwdH", "trapezoid", "-1.2", "-1.2", "-0.9", "-0.75", "-1.050", "-0.840", "0.600"});
  CHECK(row_of(result.out, "FwdH").back() == "-");
  CHECK(contains(result.out, "-1.2 to 1.2: the degrees of a number add up to 1.000 .. 1.333; 0.5 is everywhere reached by some set\n"));
  CHECK_FALSE(contains(result.out, "note:"));
}

TEST_CASE("sets: a gap of a script's sets is noted, --bound moves it, and the exit code stays 0") {
  const CommandLine cli;
  write_text(cli / "s.lua", kGappy);
  const auto result = cli.run("sets s.lua");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "0.5 is not everywhere reached by some set\n"));
  CHECK(contains(result.out, std::string("note: ") + kGapNote));
  CHECK(contains(cli.run("sets s.lua --bound 0.2").out, "between -0.1 and 0.3 no set reaches 0.2"));
  CHECK_FALSE(contains(cli.run("sets s.lua --symbols").out, "note:"));  // those are the thesis's
  CHECK(contains(cli.run("sets s.lua --set symbols='{ { name = \"one\", triangle = { 0, 1, 2 } } }' --symbols").out, "one  triangle"));
}

TEST_CASE("sets: --svg writes a drawing, with - to standard output alone") {
  const CommandLine cli;
  write_text(cli / "s.lua", kGappy);
  const auto result = cli.run("sets s.lua --svg sets.svg");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "note: "));
  const std::string svg = read_text(cli / "sets.svg");
  CHECK(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(count_of(svg, "<path ") == 2);
  const auto piped = cli.run("sets s.lua --svg -");
  CHECK(piped.out == svg);
  CHECK(piped.err == std::string("note: ") + kGapNote);
  const auto nowhere = cli.run("sets --svg no_such_folder/sets.svg");
  CHECK(nowhere.exit_code == 5);
  CHECK(contains(nowhere.err, "'no_such_folder/sets.svg' cannot be written"));
}

TEST_CASE("sets: wrong sets exit 5 with every mistake, a wrong bound exits 2") {
  const CommandLine cli;
  write_text(cli / "s.lua", "return {\n  fuzzy = {\n    { name = 'a', triangle = { 1, 0, 2 } },\n    { name = 'b' },\n  } }\n");
  const auto result = cli.run("sets s.lua");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "s.lua:3: fuzzy sets: a triangle needs 3 numbers (a <= b <= c)"));
  CHECK(contains(result.err, "s.lua:4: fuzzy sets: set 'b' has no shape"));
  CHECK(cli.run("sets --bound 0").exit_code == 2);
  write_text(cli / "c.lua", "local a = { { name = 'a', triangle = { 0, 1, 2 } } }\nreturn { fuzzy = { a, a } }\n");
  const auto choices = cli.run("sets c.lua");
  CHECK(choices.exit_code == 5);
  CHECK(contains(choices.err, "'fuzzy' gives 2 families of sets to compare; look at one at a time"));
  const auto point = cli.run("sets --set 'fuzzy={ { name = \"one\", triangle = { 1, 1, 1 } } }'");
  CHECK(point.exit_code == 5);
  CHECK(contains(point.err, "an interval of a finite width"));
}

TEST_CASE("check: sets that leave gaps are noted by their key, and are no mistake") {
  const CommandLine cli;
  write_text(cli / "s.lua", kGappy);
  const auto result = cli.run("check s.lua");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "s.lua: no mistakes\nnote: fuzzy: " + std::string(kGapNote)));
  CHECK_FALSE(contains(result.out, "symbols"));
  const auto compared = cli.run("check s.lua --set 'similarity={ \"tfvadi\", \"tfdist\" }'");
  INFO(compared.err);
  CHECK(contains(compared.out, "no mistakes in 2 combinations\n"));
  CHECK(count_of(compared.out, kGapNote) == 1);
  write_text(cli / "t.lua", "return { object = 'cube', task = 'T1_2' }\n");
  CHECK_FALSE(contains(cli.run("check t.lua").out, "note:"));
}

TEST_SUITE_END();
