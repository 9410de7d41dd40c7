// A scenario with a simulator: what it is told, and that its verdict stands in the report.
#include <fstream>

#include <Eigen/QR>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "preshape/hand/manipulability.h"
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

TEST_CASE("Simulator: a hand that holds the object imparts motions to it at which every fingertip goes along with what its contact transmits") {
  const TemporaryDirectory folder;
  const RunRecord record = run_with(folder, "");
  REQUIRE(record.simulation);
  REQUIRE(record.simulation->status == Simulation::Status::kReached);
  REQUIRE(record.imparted);
  CHECK_FALSE(record.imparted->twists_O.empty());
  // A soft finger carries its point along: some rates of the finger's drives move the tip as the object moves there.
  const HandModel& hand = *record.hand_model;
  const VirtualGrasp& grasp = record.report.result->grasp;
  for (const Twist& V : record.imparted->twists_O) {
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      const Eigen::Vector3d p_OC = grasp.contacts[i].p_OC / record.object->length_m;
      const Eigen::Vector3d wanted = V.linear() + V.angular().cross(p_OC);
      const Eigen::MatrixXd J_H = drive_jacobian(hand, record.simulation->fingers[i].finger, record.simulation->path.back()).topRows<3>();
      const Eigen::MatrixXd J_O = record.simulation->X_OH.R * J_H / record.object->length_m;
      CHECK_NEAR(J_O * J_O.completeOrthogonalDecomposition().solve(wanted), wanted, 1e-6);
    }
  }
  CHECK(report_text(record).find(fmt::format("imparts        {} of 6", record.imparted->twists_O.size())) != std::string::npos);
  CHECK_FALSE(run_with(folder, ", simulator = 'told'").imparted);
}

TEST_CASE("Simulator: with none nothing is carried out, and a table without a name is of the default one") {
  const TemporaryDirectory folder;
  const RunRecord record = run_with(folder, ", simulator = 'none'");
  CHECK_FALSE(record.simulation);
  CHECK(report_text(record).find("Carried out") == std::string::npos);
  CHECK(nlohmann::json::parse(report_json(record))["simulation"].is_null());
  const auto reading = read_text("return { object = 'cube', task = 'T1_2', simulator = { tolerance = 1 } }");
  CHECK(mistakes_of(reading).find("'tolerance' must be in") != std::string::npos);
  CHECK(mistakes_of(read_text("return { object = 'cube', task = 'T1_2', simulator = 'none', execution = { reachable = true } }")).find("'reachable' asks a simulator") != std::string::npos);
}

namespace {

/// A simulator that reaches only where the hand comes along that axis with the thumb's contact on that side of x.
std::string picky(const char* condition) {
  return std::string(R"(
return { kind = "simulator", name = "picky", version = "1.0.0", licence = "BSD-3-Clause", author = "a test",
         summary = "carries out some grasps only",
         new = function()
           return { simulate = function(task)
             if )") + condition + R"( then return { status = "reached", path = {} } end
             return { status = "collision", reason = "the hand does not like it", path = {} }
           end }
         end }
)";
}

RunRecord run_picky(const char* condition, const std::string& scenario) {
  const TemporaryDirectory folder;
  std::ofstream(folder / "picky.plugin.lua") << picky(condition);
  const std::filesystem::path folders[] = {std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", folder.path()};
  static std::unique_ptr<Registry> registry;
  registry = open_registry(catalogue(), folders);
  const std::string text = "return { object = 'cube', task = 'T1_2', memory = ':memory:', simulator = 'picky', " + scenario + " }";
  auto reading = read_scenario(Script::from_text(text, "scenario.lua").run(), "scenario.lua", ScenarioUse::kRun, *registry, catalogue());
  REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
  Session session(std::move(reading.scenario), *registry, catalogue(), {});
  session.pretrain_if_empty();
  RunRecord record = session.run();
  return record;
}

}  // namespace

TEST_CASE("Second try: the best other station that serves and that the hand carries out is told, and how many were tried") {
  const RunRecord all = run_picky("true", "execution = {}");
  REQUIRE(all.simulation);
  CHECK(all.simulation->status == Simulation::Status::kReached);
  CHECK_FALSE(all.second_try);
  const Preshape first = all.report.result->preshape;
  // Only the hand's coming along another axis is liked.
  const auto& plane = all.planes[static_cast<std::size_t>(first.plane - 1)];
  const std::string other = fmt::format("math.abs(task.approach[1] - {}) + math.abs(task.approach[2] - {}) > 0.5", plane.a.x(), plane.a.y());
  const RunRecord record = run_picky(other.c_str(), "execution = { attempts = 100 }");
  CHECK(record.simulation->status == Simulation::Status::kCollision);
  REQUIRE(record.second_try);
  REQUIRE(record.second_try->grasp);
  CHECK(record.second_try->simulation.status == Simulation::Status::kReached);
  CHECK(record.second_try->grasp->criticism.first >= record.report.thresholds.estimation);
  CHECK(record.planes[static_cast<std::size_t>(record.second_try->grasp->grasp.plane)].a != plane.a);
  CHECK(record.second_try->attempts >= 1);
  const auto json = nlohmann::json::parse(report_json(record));
  CHECK(json["second_try"]["simulation"]["status"] == "reached");
  CHECK(report_text(record, {false, false, false}).find("second try") != std::string::npos);
}

TEST_CASE("Second try: no more stations are tried than allowed, and none when none are") {
  const RunRecord three = run_picky("false", "execution = { attempts = 3 }");
  REQUIRE(three.second_try);
  CHECK_FALSE(three.second_try->grasp);
  CHECK(three.second_try->attempts == 3);
  CHECK(run_picky("false", "execution = { attempts = 0 }").second_try->attempts == 0);
}

TEST_CASE("Reachable: explorers find the best station of those that the hand carries out, or none") {
  const auto best = [](const char* condition, const char* execution) {
    const TemporaryDirectory folder;
    std::ofstream(folder / "picky.plugin.lua") << picky(condition);
    const std::filesystem::path folders[] = {std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", folder.path()};
    const auto registry = open_registry(catalogue(), folders);
    const std::string text = std::string("return { object = 'cube', task = 'T1_2', memory = ':memory:', simulator = 'picky', explorer = 'exhaustive', ") + execution + " }";
    auto reading = read_scenario(Script::from_text(text, "scenario.lua").run(), "scenario.lua", ScenarioUse::kRun, *registry, catalogue());
    REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
    const Session session(std::move(reading.scenario), *registry, catalogue(), {});
    const auto found = session.best();
    return found.best ? std::pair(found.best->grasp.plane, found.best->criticism.first) : std::pair(-1, 0.0);
  };
  const auto free = best("true", "execution = { reachable = true }");
  CHECK(free == best("false", "execution = {}"));
  CHECK(best("false", "execution = { reachable = true }").first == -1);
  const auto along_y = best("task.approach[2] > 0.5", "execution = { reachable = true }");
  CHECK(thesis_planes()[static_cast<std::size_t>(along_y.first)].a == Eigen::Vector3d(0, 1, 0));
  CHECK(along_y.second <= free.second);
}

TEST_CASE("Reachable: what is recalled counts only when the hand carries it out, and what it can is learned in its place") {
  const RunRecord recalled = run_picky("true", "learning = { policy = 'learn' }, execution = { reachable = true }");
  CHECK(recalled.report.mode == 0);
  const RunRecord learned = run_picky("task.approach[2] > 0.5", "learning = { policy = 'learn' }, execution = { reachable = true }");
  REQUIRE(learned.report.served());
  CHECK(learned.report.mode == 3);
  CHECK(learned.report.attempts[0].words.find("which serves the task, but the hand does not carry it out") != std::string::npos);
  REQUIRE(learned.simulation);
  CHECK(learned.simulation->status == Simulation::Status::kReached);
  CHECK(learned.planes[static_cast<std::size_t>(learned.report.result->grasp.plane)].a == Eigen::Vector3d(0, 1, 0));
  const RunRecord none = run_picky("false", "learning = { policy = 'learn' }, execution = { reachable = true }");
  CHECK_FALSE(none.report.served());
  for (const auto& attempt : none.report.attempts) CHECK((attempt.mode == 2 || !attempt.rewarded));
  CHECK(none.report.verdict.find("no grasp of it that the hand carries out serves this task") != std::string::npos);
}

TEST_SUITE_END();
