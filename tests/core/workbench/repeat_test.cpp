#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "preshape/io/report_json.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

/// The reports of a few runs that serve, learn and refuse, by a registry and a session of their own.
std::string reports(const std::string& object, int seed) {
  const Registry own({{std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", "build"}});
  const Catalogue catalogue({PRESHAPE_SOURCE_DIR});
  const std::string text = "return { object = \"" + object + "\", task = \"T1_1\", memory = \":memory:\", seed = " +
                           std::to_string(seed) + ", learning = { policy = \"learn\" } }";
  auto reading = read_scenario(Script::from_text(text, "scenario.lua").run(), "scenario.lua", ScenarioUse::kRun, own, catalogue);
  Session session(std::move(reading.scenario), own, catalogue, {});
  session.pretrain_if_empty();
  std::string all;
  for (const char* task : {"T1_1", "T1_2", "T4_1", "T2_5", "T1_2"}) {
    session.change(Value::table({{"task", task}}));
    all += report_json(session.run(), false);
  }
  return all;
}

}  // namespace

TEST_CASE("Repeat: the same scenario and seed give the same reports to the byte") {
  for (const char* object : {"cube", "box", "sphere"}) {
    const std::string first = reports(object, 3);
    CHECK(first == reports(object, 3));
    CHECK(first.find("\"timings\"") == std::string::npos);
    CHECK(first.find("\"seed\": 3") != std::string::npos);
  }
}

TEST_CASE("Repeat: (in a process of its own)" * doctest::skip()) {
  std::ofstream(std::getenv("PRESHAPE_TEST_REPORTS")) << reports("box", 3);
}

TEST_CASE("Repeat: a fresh process gives the same reports to the byte") {
  TemporaryDirectory folder;
  const std::string file = (folder / "reports.json").string();
  const std::string self = std::filesystem::canonical("/proc/self/exe").string();
  const std::string command = "PRESHAPE_TEST_REPORTS='" + file + "' '" + self + "' --no-skip '--test-case=Repeat: (in a process of its own)' > '" +
                              (folder / "log").string() + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  std::ostringstream other;
  other << std::ifstream(file).rdbuf();
  CHECK(other.str().size() > 1000);
  CHECK(other.str() == reports("box", 3));
}

TEST_CASE("Repeat: another seed trains another classifier") {
  const std::regex seed("\"seed\": [0-9]+");
  const auto without_seed = [&](int number) { return std::regex_replace(reports("box", number), seed, ""); };
  CHECK(without_seed(3) == without_seed(3));
  CHECK(without_seed(3) != without_seed(4));
}

TEST_SUITE_END();
