// A scenario with a simulator: what it is told, and that its verdict stands in the report.
#include <fstream>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "preshape/io/report_json.h"
#include "preshape/io/report_text.h"
#include "preshape/workbench/components.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

constexpr const char* kTold = R"(
return { kind = "simulator", name = "told", version = "1.0.0", licence = "BSD-3-Clause", author = "a test",
         summary = "tells what it was told",
         new = function()
           return { simulate = function(task, seed)
             local thumb = task.contacts[1]
             return { status = "unreachable", contact_error_m = task.clearance, path = {},
                      X_OH = { p = { thumb.p[1], thumb.p[2], thumb.p[3] } },
                      reason = table.concat(task.fingers, " ") .. ", joints " .. #task.hand.joints .. ", approach " ..
                               task.approach[1] .. " " .. task.approach[2] .. " " .. task.approach[3] .. ", push " ..
                               task.opposition[1] .. " " .. task.opposition[2] .. " " .. task.opposition[3] .. ", seed " .. seed }
           end }
         end }
)";

/// A run of the cube with a simulator of that name, from a folder that has `told`.
RunRecord run_with(const TemporaryDirectory& folder, const std::string& simulator) {
  std::ofstream(folder / "told.plugin.lua") << kTold;
  const std::filesystem::path folders[] = {std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", folder.path()};
  static std::unique_ptr<Registry> registry;  // outlives what is made from it
  registry = open_registry(catalogue(), folders);
  const std::string text = "return { object = 'cube', task = 'T1_2', memory = ':memory:', seed = 5" + simulator + " }";
  auto reading = read_scenario(Script::from_text(text, "scenario.lua").run(), "scenario.lua", ScenarioUse::kRun, *registry, catalogue());
  REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
  Session session(std::move(reading.scenario), *registry, catalogue(), {});
  session.pretrain_if_empty();
  return session.run();
}

}  // namespace

TEST_CASE("Simulator: it is told the grasp that serves, in O, and its verdict is in the record, in words and in JSON") {
  const TemporaryDirectory folder;
  const RunRecord record = run_with(folder, ", simulator = 'told'");
  REQUIRE(record.simulation);
  REQUIRE(record.report.result);
  const VirtualGrasp& grasp = record.report.result->grasp;
  const ApproachPlane& plane = record.planes[static_cast<std::size_t>(grasp.plane)];
  const auto axis = [](const Eigen::Vector3d& v) { return fmt::format("{:.1f} {:.1f} {:.1f}", v.x(), v.y(), v.z()); };
  const std::string fingers = fmt::format("{}", fmt::join(grasp.fingers, " "));
  CHECK(record.simulation->reason ==
        fmt::format("{}, joints 16, approach {}, push {}, seed 5", fingers, axis(plane.a), axis(plane.n_f)));
  CHECK(record.simulation->X_OH.p == grasp.contacts[0].p_OC);
  CHECK_NEAR(record.simulation->contact_error_m, 0.5 * record.hand_dimensions.unit_length_m, 1e-15);

  CHECK(report_text(record).find("Carried out by the hand\n  unreachable") != std::string::npos);
  const auto json = nlohmann::json::parse(report_json(record));
  CHECK(json["simulation"]["status"] == "unreachable");
  CHECK(json["simulation"]["reason"] == record.simulation->reason);
  CHECK(json["simulation"]["hand_pose_O"]["R"] == std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
}

TEST_CASE("Simulator: without one nothing is carried out, and a table has to say which") {
  const TemporaryDirectory folder;
  const RunRecord record = run_with(folder, "");
  CHECK_FALSE(record.simulation);
  CHECK(report_text(record).find("Carried out") == std::string::npos);
  CHECK(nlohmann::json::parse(report_json(record))["simulation"].is_null());
  const auto reading = read_text("return { object = 'cube', task = 'T1_2', simulator = { tolerance = 1 } }");
  CHECK(mistakes_of(reading).find("'simulator' does not say which: simulator = { \"name\", key = value }") != std::string::npos);
}

TEST_SUITE_END();
