// The files of `run` that show a scene.
#include <filesystem>

#include <nlohmann/json.hpp>

#include "command.h"

using namespace preshape::test;
namespace fs = std::filesystem;

TEST_SUITE_BEGIN("app");

namespace {

constexpr const char* kCube =
    "return preshape.scenario { object = 'cube', task = 'T1_2', memory = ':memory:' }\n";

bool has_template() {
  return fs::exists(fs::path(PRESHAPE_BINARY_DIR) / "share/preshape/page/template.html");
}

}  // namespace

TEST_CASE("run: --scene writes a glTF binary of the run, with the hand's links where one was simulated") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  CHECK(cli.run("run s.lua -q --scene bare.glb --set simulator=none").exit_code == 0);
  CHECK(cli.run("run s.lua -q --scene hand.glb").exit_code == 0);
  for (const bool hand : {false, true}) {
    const std::string file = read_text(cli / (hand ? "hand.glb" : "bare.glb"));
    CHECK(file.starts_with("glTF"));
    CHECK(contains(file, "\"name\":\"cube, T1_2\""));
    CHECK(contains(file, "\"name\":\"contact thumb\""));
    CHECK(contains(file, "\"name\":\"thumb link 1\"") == hand);
    CHECK(contains(file, "\"animations\":") == hand);
  }
}

TEST_CASE(
    "run: --page writes a page with the report of --json, or says in one sentence that this build has none") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  const auto result = cli.run("run s.lua -q --page page.html --json out.json");
  if (!has_template()) {
    CHECK(result.exit_code == 5);
    CHECK(result.err.starts_with("preshape: this build has no page template, so --page cannot be served; "));
    CHECK(result.out.empty());  // before anything was run
    CHECK_FALSE(fs::exists(cli / "page.html"));
    return;
  }
  CHECK(result.exit_code == 0);
  const std::string page = read_text(cli / "page.html"),
                    mark = "<script type=\"application/json\" id=\"report\">";
  const auto begin = page.find(mark) + mark.size();
  CHECK(nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin)) ==
        nlohmann::json::parse(read_text(cli / "out.json")));
  CHECK_FALSE(contains(page, "<!--preshape:"));
  CHECK_FALSE(contains(page, " src="));
  CHECK(page.size() < 2'000'000);
}

TEST_CASE("doctor: says whether pages can be written, and that a damaged template is to be mended") {
  const CommandLine cli;
  const auto whole = cli.run("doctor");
  INFO(whole.out);
  CHECK(whole.exit_code == 0);
  CHECK(contains(whole.out, has_template() ? "  ok    template " : "  note  no page can be written: "));
  fs::create_directories(cli / "user/preshape/page");
  write_text(cli / "user/preshape/page/template.html", "<html></html>\n");
  const auto damaged = cli.run("doctor");
  INFO(damaged.out);
  CHECK(damaged.exit_code == 1);
  CHECK(contains(damaged.out, "  BAD   " + (cli / "user/preshape/page/template.html").string() + "\n        "));
  CHECK(contains(damaged.out, "build it again, or take the file away"));
}

TEST_CASE("run: a scene or page that cannot be written, or of several runs, is refused with exit code 5") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  const auto nowhere = cli.run("run s.lua -q --scene no_such_folder/s.glb");
  CHECK(nowhere.exit_code == 5);
  CHECK(contains(nowhere.err, "'no_such_folder/s.glb' cannot be written"));
  const auto several = cli.run("run s.lua --scene s.glb --set 'task={ \"T1_1\", \"T1_2\" }'");
  CHECK(several.exit_code == 5);
  CHECK(contains(
      several.err,
      "--scene shows one run, and this is a comparison or a study; choose one combination with --set"));
  write_text(cli / "study.lua", "return { answer = 42 }\n");
  const auto study = cli.run("run study.lua --page s.html");
  CHECK(study.exit_code == 5);
  CHECK(contains(study.err, "--page shows one run"));
  CHECK_FALSE(fs::exists(cli / "s.glb"));
}

TEST_SUITE_END();
