#include "preshape/io/report_json.h"

#include <cmath>

#include "io/simulation_json.h"
#include "preshape/agent/internal_critic.h"
#include "preshape/io/hand_notes.h"
#include "preshape/plugin/fingerprint.h"
#include "preshape/spatial/reciprocal.h"
#include "preshape/spatial/screw.h"
#include "preshape/version.h"

namespace preshape {

namespace {

Json six(const std::array<double, kComponents>& v) { return Json(v); }

Json to_json(const Value& value) {
  if (value.is_boolean()) return value.boolean();
  if (value.is_number()) return value.is_integer() ? Json(value.integer()) : number(value.number());
  if (value.is_string()) return value.string();
  if (value.is_list()) {
    Json list = Json::array();
    for (const auto& item : value.items()) list.push_back(to_json(item));
    return list;
  }
  if (value.is_table()) {
    Json table = Json::object();
    for (const auto& [key, entry] : value.entries()) {
      if (!entry.is_function()) table[key] = to_json(entry);
    }
    return table;
  }
  return nullptr;
}

Value to_value(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_array()) {
    Value::List items;
    for (const auto& item : json) items.push_back(to_value(item));
    return Value::list(std::move(items));
  }
  if (json.is_object()) {
    Value::Table entries;
    for (const auto& [key, entry] : json.items()) entries.emplace_back(key, to_value(entry));
    return Value::table(std::move(entries));
  }
  return {};
}

Json fuzzy_json(const FuzzyPartition& partition, const std::array<double, kComponents>& vector) {
  Json rows = Json::array();
  for (const double x : vector) {
    std::vector<double> degrees(static_cast<std::size_t>(partition.size()));
    partition.fuzzify(x, degrees);
    rows.push_back(degrees);
  }
  return rows;
}

Json task_json(const Task& task) {
  return {{"name", task.name}, {"screw", six(task.screw)}, {"stability", task.stability},
          {"manipulability", task.manipulability}};
}

Json contacts_json(const VirtualGrasp& grasp) {
  Json contacts = Json::array();
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const ContactFrame& C = grasp.contacts[i];
    const std::array<double, kComponents> F = components(grasp.F_C_O[i]);
    contacts.push_back({{"finger", grasp.fingers[i]}, {"point_O_m", vector(C.p_OC)}, {"normal_O", vector(C.n)},
                        {"approach_O", vector(C.a)}, {"transverse_O", vector(C.t)}, {"wrench_C_O", six(F)}});
  }
  return contacts;
}

Json twists_json(const VirtualGrasp& grasp) {
  Json twists = Json::array();
  for (const Twist& twist : reciprocal_twists(grasp.wrench_union)) {
    twists.push_back({{"linear", vector(twist.linear())}, {"angular", vector(twist.angular())}});
  }
  return twists;
}

Json screw_json(const Wrench& resultant) {
  const Screw screw = poinsot_reduce(resultant);
  return {{"direction", vector(screw.direction)}, {"point_normalised", vector(screw.point)},
          {"pitch_normalised", number(screw.pitch)}, {"magnitude", screw.magnitude}};
}

Json quality_json(const RunRecord& record, const VirtualGrasp& grasp) {
  Json numbers = Json::object();
  for (std::size_t i = 0; i < grasp.quality.size(); ++i) numbers[record.quality_numbers[i].name] = number(grasp.quality[i]);
  return numbers;
}

Json grasp_json(const RunRecord& record, const JudgedGrasp& judged) {
  const VirtualGrasp& grasp = judged.grasp;
  const auto wrench = components(grasp.resultant);
  const PreshapeTaxonomy names = taxonomy({judged.preshape.plane, judged.preshape.symbol, grasp.virtual_fingers});
  return {{"plane", grasp.plane + 1},
          {"plane_text", record.planes[static_cast<std::size_t>(grasp.plane)].text()},
          {"approach_m", grasp.approach_m},
          {"approach_fraction", grasp.approach_fraction},
          {"transverse_fraction", grasp.transverse_fraction},
          {"approach_normalised", grasp.approach_m / record.object->length_m},
          {"approach_symbol", judged.preshape.symbol},
          {"approach_symbol_name", record.symbol_names[static_cast<std::size_t>(judged.preshape.symbol - 1)]},
          {"virtual_fingers", grasp.virtual_fingers},
          {"recalled_virtual_fingers", judged.preshape.virtual_fingers},
          {"confidence", number(judged.confidence)},
          {"taxonomy", {{"opposition", names.opposition}, {"grasp", names.grasp}, {"type", names.type}}},
          {"depth_m", grasp.depth_m},
          {"opening_m", grasp.opening_m},
          {"opens_wide_enough", grasp.opening_m <= 2.0 * record.hand_dimensions.maximum_opening_m},
          {"contacts", contacts_json(grasp)},
          {"resultant_wrench", six(wrench)},
          {"screw", screw_json(grasp.resultant)},
          {"stability", grasp.stability},
          {"manipulability", grasp.manipulability},
          {"reciprocal_twists", twists_json(grasp)},
          {"quality", quality_json(record, grasp)},
          {"similarity", {{"first", judged.criticism.first}, {"second", judged.criticism.second},
                          {"components", six(judged.criticism.components)}}},
          {"fuzzy_wrench", fuzzy_json(record.partition, wrench)}};
}

Json object_json(const SensedObject& sensed) {
  const Object& object = sensed.object;
  const Eigen::Vector3d extents = object.box_O.extents();
  const ObjectAttributes& a = sensed.attributes;
  return {{"name", object.name},
          {"file", object.file},
          {"hash", object.hash},
          {"extents_m", vector(extents)},
          {"scale", object.scale},
          {"width_normalised", a.width_normalised},
          {"height_normalised", a.height_normalised},
          {"depth_normalised", a.depth_normalised},
          {"vertices", object.mesh_O.vertices.size()},
          {"triangles", object.mesh_O.triangles.size()},
          {"vertices_per_triangle", a.vertices_per_triangle},
          {"normals_per_triangle", a.normals_per_triangle},
          {"faces_per_triangle", a.faces_per_triangle},
          {"kilotriangles", a.kilotriangles},
          {"watertight", object.topology.watertight()},
          {"warnings", object.warnings}};
}

Json lesson_json(const LessonReport& lesson) {
  const TrainingOutcome& t = lesson.training;
  return {{"explorer", lesson.explorer},
          {"evaluations", lesson.evaluations},
          {"rows_added", lesson.rows_added},
          {"training", {{"arrived", t.status == TrainingOutcome::Status::kArrived}, {"epochs", t.epochs},
                        {"restarts", t.restarts}, {"mean_squared_error", t.mean_squared_error},
                        {"wrong_rows", t.wrong_rows}}}};
}

Json attempts_json(const Report& report) {
  Json attempts = Json::array();
  for (const auto& attempt : report.attempts) {
    attempts.push_back({{"mode", attempt.mode}, {"rewarded", attempt.rewarded},
                        {"score", attempt.score ? Json(*attempt.score) : Json(nullptr)}, {"words", attempt.words}});
  }
  return attempts;
}

Json pipeline_json(const RunRecord& record) {
  Json components = Json::array();
  for (const auto& use : record.components) {
    components.push_back({{"role", use.role}, {"kind", use.kind}, {"name", use.name},
                          {"parameters", to_json(use.parameters)}, {"plugin", use.plugin}, {"version", use.version},
                          {"fingerprint", use.fingerprint}});
  }
  const HandDimensions& hand = record.hand_dimensions;
  return {{"preshape", PRESHAPE_VERSION_STRING},
          {"fingerprint", fingerprint_text(host_fingerprint())},
          {"scenario", record.scenario},
          {"description", to_json(record.description)},
          {"components", components},
          {"hand", {{"name", record.hand}, {"unit_length_m", hand.unit_length_m},
                    {"finger_spacing_m", hand.finger_spacing_m}, {"maximum_opening_m", hand.maximum_opening_m},
                    {"base_width_m", hand.base_width_m},
                    {"notes", record.hand_model ? hand_notes(*record.hand_model) : std::vector<std::string>{}}}},
          {"memory", record.memory},
          {"seed", record.seed}};
}

Json nearest_json(const RunRecord& record, const NearestTask& nearest) {
  return {{"task", task_json(nearest.task)}, {"similarity", nearest.similarity}, {"grasp", grasp_json(record, nearest.grasp)}};
}

Json second_try_json(const RunRecord& record) {
  const SecondTry& other = *record.second_try;
  Json json = {{"attempts", other.attempts}, {"result", nullptr}, {"simulation", nullptr}};
  if (!other.grasp) return json;
  json["result"] = grasp_json(record, *other.grasp);
  json["simulation"] = simulation_json(record, other.grasp, other.simulation, other.imparted);
  return json;
}

Json record_json(const RunRecord& record, bool timings) {
  const Report& report = record.report;
  Json json = {{"schema", "preshape-report/1"},
               {"status", status_name(report.status)},
               {"mode", report.mode},
               {"served", report.served()},
               {"verdict", report.verdict},
               {"task", task_json(report.task)},
               {"fuzzy_task", fuzzy_json(record.partition, report.task.screw)},
               {"thresholds", {{"estimation", report.thresholds.estimation}, {"recognition", report.thresholds.recognition},
                               {"search", report.thresholds.search}}},
               {"measures", {{"first", record.measure}, {"first_nearest", record.scale.nearest},
                             {"first_farthest", record.scale.farthest}, {"second", record.second_measure}}},
               {"attempts", attempts_json(report)}};
  json["result"] = report.result ? grasp_json(record, *report.result) : Json(nullptr);
  json["unrecalled"] = report.unrecalled ? grasp_json(record, *report.unrecalled) : Json(nullptr);
  json["nearest"] = report.nearest ? nearest_json(record, *report.nearest) : Json(nullptr);
  json["lesson"] = report.lesson ? lesson_json(*report.lesson) : Json(nullptr);
  json["simulation"] =
      record.simulation ? simulation_json(record, report.result, *record.simulation, record.imparted) : Json(nullptr);
  json["second_try"] = record.second_try ? second_try_json(record) : Json(nullptr);
  json["object"] = object_json(*record.object);
  json["pipeline"] = pipeline_json(record);
  if (timings) {
    Json times = Json::object();
    for (const auto& timing : record.timings) times[timing.stage] = timing.seconds;
    json["timings"] = times;
  }
  return json;
}

}  // namespace

std::string report_json(const RunRecord& record, bool timings) { return record_json(record, timings).dump(2) + "\n"; }
Value report_value(const RunRecord& record) { return to_value(record_json(record, false)); }
std::string value_json(const Value& value, int indent) { return to_json(value).dump(indent); }

}  // namespace preshape
