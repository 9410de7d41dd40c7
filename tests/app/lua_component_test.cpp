#include <nlohmann/json.hpp>

#include "command.h"

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

namespace {

/// The negative sum of the differences of the crisp components: another measure than any that is shipped.
constexpr const char* kNear = R"(return {
  kind = "similarity", name = "near", version = "0.1.0", licence = "MIT", author = "A. Author",
  summary = "One minus the mean difference of the components",
  capabilities = { "symmetric" },
  parameters = { { name = "width", type = "number", default = 2, minimum = 0.1, maximum = 10, text = "difference that counts as all" } },
  new = function(p)
    return {
      scale = { farthest = 0, nearest = 6 },
      component = function(q, w)
        return math.max(0, 1 - math.abs(q.crisp - w.crisp) / p.width)
      end,
    }
  end,
}
)";

constexpr const char* kScenario =
    "return { object = 'cube', task = 'T1_2', similarity = { 'near', width = 2.5 }, memory = ':memory:',\n"
    "  thresholds = { estimation = 4, recognition = 5 } }\n";

}  // namespace

TEST_CASE("run: a whole scenario with a similarity in Lua that lies beside it") {
  const CommandLine cli;
  std::filesystem::create_directories(cli / "work");
  write_text(cli / "work/near.plugin.lua", kNear);
  write_text(cli / "work/s.lua", kScenario);
  const auto run = cli.run("run work/s.lua --json a.json");
  INFO(run.err);
  CHECK(run.exit_code == 0);
  CHECK(contains(run.out, "near"));
  const auto report = nlohmann::json::parse(read_text(cli / "a.json"));
  CHECK(report["pipeline"]["description"]["similarity"]["width"] == 2.5);
  REQUIRE(cli.run("run work/s.lua --json b.json").exit_code == 0);
  auto a = report, b = nlohmann::json::parse(read_text(cli / "b.json"));
  a.erase("timings"), b.erase("timings");
  CHECK(a.dump() == b.dump());
  bool told = false;
  for (const auto& component : report["pipeline"]["components"]) {
    told = told || (component["name"] == "near" && component["fingerprint"].get<std::string>().starts_with("Lua, SHA-256 "));
  }
  CHECK(told);
}

TEST_CASE("check and run: a component in Lua is held to its declaration, and its faults name its file and line") {
  const CommandLine cli;
  write_text(cli / "near.plugin.lua", kNear);
  write_text(cli / "s.lua", kScenario);
  CHECK(cli.run("check s.lua").exit_code == 0);
  const auto misspelt = cli.run("check s.lua --set similarity.widht=3");
  CHECK(misspelt.exit_code == 5);
  CHECK(contains(misspelt.err, "similarity 'near': unknown key 'widht'; did you mean 'width'?"));

  std::string broken = kNear;
  write_text(cli / "near.plugin.lua", broken.replace(broken.find("q.crisp -"), 9, "q.crips -"));
  const auto failed = cli.run("run s.lua");
  CHECK(failed.exit_code == 5);
  CHECK(contains(failed.err, "near.plugin.lua:10: attempt to perform arithmetic on a nil value (field 'crips')"));

  std::string torn = kNear;
  write_text(cli / "near.plugin.lua", torn.replace(torn.find("summary ="), 9, "sumary ="));
  const auto refused = cli.run("run s.lua");
  CHECK(refused.exit_code == 5);
  CHECK(contains(refused.err, "near.plugin.lua:3: component: unknown key 'sumary'; did you mean 'summary'?"));
}

TEST_CASE("plugins: components in Lua are listed, shown and explained like any other") {
  const CommandLine cli;
  const auto shown = cli.run("plugins cosine");
  CHECK(contains(shown.out, "similarity 'cosine'"));
  CHECK(contains(shown.out, "cosine.plugin.lua (Lua)"));
  CHECK(contains(shown.out, "sharpness"));
  CHECK(contains(cli.run("plugins").out, "grasp_isotropy"));
  std::filesystem::create_directories(cli / "mine");
  write_text(cli / "mine/torn.plugin.lua", "return {");
  const auto why = cli.run("--plugin-path mine plugins torn --why");
  CHECK(why.exit_code == 5);
  CHECK(contains(why.out, "mine/torn.plugin.lua:1: unexpected symbol near <eof>"));
  CHECK(contains(cli.run("--plugin-path mine plugins").out, "refused"));
  std::filesystem::create_directories(cli / "user/preshape/scripts/components");
  write_text(cli / "user/preshape/scripts/components/near.plugin.lua", kNear);
  CHECK(contains(cli.run("plugins near").out, "One minus the mean difference"));
}

TEST_SUITE_END();
