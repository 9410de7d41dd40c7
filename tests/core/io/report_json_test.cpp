#include <limits>

#include <nlohmann/json.hpp>

#include "preshape/grasp/approach_volume.h"
#include "preshape/io/grasp_scene.h"
#include "preshape/io/report_json.h"
#include "preshape/version.h"
#include "reports.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;
using Json = nlohmann::json;

TEST_SUITE_BEGIN("core/io");

namespace {

Json parsed(const RunRecord& record, bool timings = true) { return Json::parse(report_json(record, timings)); }

void check_members(const Json& object, const std::vector<std::string>& names) {
  for (const auto& name : names) CHECK_MESSAGE(object.contains(name), "no member '", name, "'");
  CHECK(object.size() == names.size());
}

void check_grasp(const Json& grasp) {
  check_members(grasp, {"plane", "plane_text", "approach_m", "approach_fraction", "transverse_fraction", "approach_normalised", "approach_symbol",
                        "approach_symbol_name", "virtual_fingers", "recalled_virtual_fingers", "confidence", "taxonomy",
                        "depth_m", "opening_m", "opens_wide_enough", "contacts", "resultant_wrench", "screw", "stability",
                        "manipulability", "reciprocal_twists", "quality", "similarity", "fuzzy_wrench"});
  CHECK(grasp["contacts"].size() == grasp["virtual_fingers"].get<std::size_t>() + 1);
  CHECK(grasp["contacts"][0]["finger"] == "thumb");
  CHECK(grasp["resultant_wrench"].size() == 6);
  CHECK(grasp["fuzzy_wrench"].size() == 6);
  CHECK(grasp["fuzzy_wrench"][0].size() == 7);
  CHECK(grasp["reciprocal_twists"].size() == 6 - grasp["stability"].get<std::size_t>());
}

}  // namespace

TEST_CASE("Report as JSON: parses, and has the documented members, however the run ended") {
  const std::vector<std::string> statuses = {"served", "recognised", "learned", "deadlock"};
  REQUIRE(records_of_every_status().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const RunRecord& record = records_of_every_status()[i];
    const Json json = parsed(record);
    INFO(statuses[i]);
    check_members(json, {"schema", "status", "mode", "served", "verdict", "task", "fuzzy_task", "thresholds", "measures",
                         "attempts", "result", "unrecalled", "nearest", "lesson", "simulation", "second_try", "object", "pipeline", "timings"});
    CHECK(json["schema"] == "preshape-report/1");
    CHECK(json["status"] == statuses[i]);
    CHECK(json["mode"] == record.report.mode);
    CHECK(json["served"] == record.report.served());
    CHECK(json["attempts"].size() == record.report.attempts.size());
    check_members(json["pipeline"], {"preshape", "fingerprint", "scenario", "description", "components", "hand", "memory", "seed"});
    CHECK(json["pipeline"]["preshape"] == PRESHAPE_VERSION_STRING);
    REQUIRE(json["result"].is_object());
    check_grasp(json["result"]);
    CHECK(json["nearest"].is_null() == !record.report.nearest);
    if (record.report.nearest) check_grasp(json["nearest"]["grasp"]);
    CHECK(json["lesson"].is_null() == !record.report.lesson);
    CHECK(json["object"]["hash"].get<std::string>().size() == 64);
  }
  CHECK(parsed(records_of_every_status()[1])["nearest"].is_object());
  CHECK(parsed(records_of_every_status()[2])["lesson"]["rows_added"] == 2);
}

TEST_CASE("Report as JSON: numbers are those of the run to the last bit, lengths in metres") {
  const RunRecord& record = records_of_every_status()[0];
  const Json json = parsed(record);
  const VirtualGrasp& grasp = record.report.result->grasp;
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(json["task"]["screw"][i].get<double>() == record.report.task.screw[i]);
    CHECK(json["result"]["resultant_wrench"][i].get<double>() == grasp.resultant.vector()[static_cast<Eigen::Index>(i)]);
  }
  CHECK(json["result"]["plane"] == grasp.plane + 1);
  CHECK(json["result"]["approach_m"].get<double>() == grasp.approach_m);
  CHECK(json["result"]["contacts"][0]["point_O_m"][0].get<double>() == grasp.contacts[0].p_OC.x());
  CHECK_NEAR(json["object"]["extents_m"][0].get<double>(), 0.06, 1e-8);
  CHECK_NEAR(json["result"]["approach_normalised"].get<double>(), grasp.approach_m / 0.18, 1e-15);
}

TEST_CASE("Report as JSON: the motions that the hand can give the object, and the task's share of them") {
  RunRecord record = records_of_every_status()[0];
  REQUIRE(record.simulation);
  record.imparted.reset();
  CHECK(parsed(record)["simulation"]["imparted"].is_null());
  record.imparted = ImpartedTwists{{Twist({1, 0, 0}, {0, 0, 0}), Twist({0, 0, 0}, {0, 0.6, 0.8})}, 3};
  const Json told = parsed(record)["simulation"]["imparted"];
  check_members(told, {"twists_O", "internal_motions", "task_share"});
  CHECK(told["twists_O"] == Json{{1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0.6, 0.8}});
  CHECK(told["internal_motions"] == 3);
  CHECK(told["task_share"].get<double>() == share_of(*record.imparted, record.report.task));
}

TEST_CASE("Report as JSON: collisions name the link, what it meets and when") {
  RunRecord record = records_of_every_status()[0];
  REQUIRE(record.simulation);
  CHECK(parsed(record)["simulation"]["collisions"].empty());
  record.simulation->collisions = {{0, Collision::kObject, 0}, {1, Collision::kSupport, 1}, {2, 5, 1}, {99, 5, 1}};  // the last names no link
  const Json told = parsed(record)["simulation"]["collisions"];
  REQUIRE(told.size() == 3);
  CHECK(told[0] == Json{{"link", solid_name(*record.hand_model, 0)}, {"with", "object"}, {"posture", 0}});
  CHECK(told[1]["with"] == "support");
  CHECK(told[2] == Json{{"link", solid_name(*record.hand_model, 2)}, {"with", solid_name(*record.hand_model, 5)}, {"posture", 1}});
}

TEST_CASE(
    "Report as JSON: a simulation tells the open hand's approach volume; one that shows no motion has none") {
  RunRecord record = records_of_every_status()[0];
  REQUIRE(record.simulation);
  const Finger& thumb =
      record.hand_model->fingers()[static_cast<std::size_t>(record.simulation->fingers[0].finger)];
  record.simulation->path.front()[static_cast<std::size_t>(thumb.first_joint + thumb.joint_count - 1)] +=
      0.4;  // else it is even
  std::vector<int> fingers;
  for (const auto& outcome : record.simulation->fingers) fingers.push_back(outcome.finger);
  const ApproachPlane& plane = record.planes[static_cast<std::size_t>(record.report.result->grasp.plane)];
  const auto volume = approach_volume({*record.hand_model, record.simulation->X_OH,
                                       record.simulation->path.front(), fingers, plane.a, plane.n_f});
  REQUIRE(volume);
  const Json told = parsed(record)["simulation"]["approach_volume"];
  check_members(told, {"volume_m3", "entrance_O_m", "entrance_centroid_O_m", "entrance_normal_O",
                       "angle_to_approach_deg"});
  CHECK(told["volume_m3"].get<double>() == volume->volume_m3);
  CHECK(told["entrance_O_m"].size() == volume->entrance_O.size());
  CHECK(told["entrance_O_m"][1][2].get<double>() == volume->entrance_O[1].z());
  CHECK(told["entrance_centroid_O_m"][0].get<double>() == volume->centroid_O.x());
  CHECK(told["entrance_normal_O"][1].get<double>() == volume->normal_O.y());
  const double cosine = volume->normal_O.dot(plane.a);
  CHECK(cosine < 0.999);
  CHECK_NEAR(std::cos(told["angle_to_approach_deg"].get<double>() / 57.29577951308232), cosine, 1e-12);
  record.second_try = SecondTry{1, record.report.result, *record.simulation};
  record.simulation->path.clear();
  CHECK(parsed(record)["simulation"]["approach_volume"].is_null());
  CHECK(parsed(record)["second_try"]["simulation"]["approach_volume"] == told);
}

TEST_CASE("Report as JSON: what is unset is null, never a zero or a word") {
  RunRecord record = records_of_every_status()[0];
  record.report.result->confidence = std::numeric_limits<double>::quiet_NaN();
  record.report.result->grasp.quality[0] = std::numeric_limits<double>::infinity();
  record.report.attempts[0].score.reset();
  const Json json = parsed(record);
  CHECK(json["result"]["confidence"].is_null());
  CHECK(json["result"]["quality"]["stability"].is_null());
  CHECK(json["attempts"][0]["score"].is_null());
  record.report.result.reset();
  CHECK(parsed(record)["result"].is_null());
  CHECK(report_json(record).find("nan") == std::string::npos);
}

TEST_CASE("Report as JSON: timings are the only member that can be left out") {
  const RunRecord& record = records_of_every_status()[0];
  Json with = parsed(record);
  CHECK(with["timings"].contains("controller"));
  with.erase("timings");
  CHECK(with == parsed(record, false));
}

TEST_CASE("Report as JSON: the pipeline names every component with its parameters, so that the run can be repeated") {
  const Json pipeline = parsed(records_of_every_status()[0])["pipeline"];
  std::vector<std::string> roles;
  for (const Json& component : pipeline["components"]) {
    roles.push_back(component["role"]);
    CHECK_FALSE(component["version"].get<std::string>().empty());
    CHECK_FALSE(component["plugin"].get<std::string>().empty());
    CHECK_MESSAGE(!component["fingerprint"].get<std::string>().empty(), roles.back());
  }
  for (const char* role : {"contact", "similarity", "tie_break", "classifier", "collision", "quality", "explorer", "proof", "hand"}) {
    CHECK(std::count(roles.begin(), roles.end(), role) == 1);
  }
  const Json& description = pipeline["description"];
  CHECK(description["title"] == "a cube");
  CHECK(description["contact"]["ka"] == 0.45);
  CHECK(description["thresholds"]["estimation"] == 3.0);
  CHECK(description["collision"]["name"] == "brute");
  // A value of the report reads as the report.
  CHECK(Json::parse(value_json(report_value(records_of_every_status()[0])))["pipeline"]["description"] == description);
}

TEST_CASE("Value as JSON: kinds keep their form, functions and numbers that are none become null") {
  const Value value = Value::table({{"a", 1}, {"b", 0.5}, {"c", "x\"y"}, {"d", true}, {"e", Value::list({1, 2})},
                                    {"f", Value::list({std::numeric_limits<double>::quiet_NaN()})},
                                    {"g", Value::list({Value(Value::Function{1})})}});
  CHECK(value_json(value) == R"({"a":1,"b":0.5,"c":"x\"y","d":true,"e":[1,2],"f":[null],"g":[null]})");
  CHECK(value_json(Value{}) == "null");
}

TEST_SUITE_END();
