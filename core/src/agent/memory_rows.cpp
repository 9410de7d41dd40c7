#include "agent/memory_rows.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape {

namespace {

constexpr std::array<std::string_view, 3> kProvenances = {"pretrain", "wrench", "task"};

/// As the classifier reads them: Sample::inputs from 8 on.
std::array<double, 7> numbers(const ObjectAttributes& a) {
  return {a.width_normalised,     a.height_normalised,  a.depth_normalised, a.vertices_per_triangle,
          a.normals_per_triangle, a.faces_per_triangle, a.kilotriangles};
}

constexpr std::string_view kObjectOwn = "first_seen";
constexpr std::string_view kObjectGiven =
    "hash, name, file, width_m, height_m, depth_m, width, height, depth, vertices_per_triangle, "
    "normals_per_triangle, faces_per_triangle, kilotriangles, first_seen_utc";
constexpr std::string_view kStateGiven =
    "component, parameters, state, last_sample, arrived, epochs, restarts, mean_squared_error, wrong_rows, "
    "seed, "
    "session";

const std::string& sample_given() {
  static const std::string columns = fmt::format(
      "object, provenance, {}, plane, symbol, virtual_fingers, approach_m, approach_ratio, fx, fy, fz, mx, "
      "my, mz, "
      "score, task, session",
      fmt::join(feature_names(), ", "));
  return columns;
}

std::string insert_sql(std::string_view table, std::string_view columns) {
  const auto count = std::count(columns.begin(), columns.end(), ',') + 1;
  std::string marks = "?";
  for (std::ptrdiff_t i = 1; i < count; ++i) marks += ", ?";
  return fmt::format("INSERT INTO {} ({}) VALUES ({})", table, columns, marks);
}

void check_text(std::string_view what, std::string_view text) {
  if (text.find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("{} contains a zero byte; give plain text", what));
  }
}

void check_finite(std::string_view what, double number) {
  if (!std::isfinite(number))
    throw InputError(fmt::format("{} must be a finite number, got {}", what, number));
}

void check_finite_or_unknown(std::string_view what, double number) {
  if (std::isinf(number))
    throw InputError(fmt::format("{} must be finite, or NaN where unknown, got {}", what, number));
}

void check_from_one(std::string_view what, int number) {
  if (number < 1) throw InputError(fmt::format("{} must be 1 or more, got {}", what, number));
}

bool is_hash(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

std::string_view provenance_name(Provenance provenance) {
  return kProvenances.at(static_cast<std::size_t>(provenance));
}

Provenance provenance_of(std::string_view name) {
  const auto found = std::find(kProvenances.begin(), kProvenances.end(), name);
  if (found != kProvenances.end()) return static_cast<Provenance>(found - kProvenances.begin());
  const std::vector<std::string> known(kProvenances.begin(), kProvenances.end());
  throw InputError(fmt::format("cannot be '{}'{}", name, did_you_mean(name, known)));
}

const std::string& object_columns() {
  static const std::string columns = fmt::format("{}, {}", kObjectOwn, kObjectGiven);
  return columns;
}

const std::string& sample_columns() {
  static const std::string columns = "id, " + sample_given();
  return columns;
}

const std::string& state_columns() {
  static const std::string columns = fmt::format("id, {}", kStateGiven);
  return columns;
}

const std::string& insert_object_sql() {
  static const std::string sql = insert_sql("object", kObjectGiven);
  return sql;
}

const std::string& insert_sample_sql() {
  static const std::string sql = insert_sql("sample", sample_given());
  return sql;
}

const std::string& insert_state_sql() {
  static const std::string sql = insert_sql("classifier_state", kStateGiven);
  return sql;
}

void check_object(const MemoryObject& object) {
  if (!is_hash(object.hash)) {
    throw InputError(fmt::format("an object's hash must be 64 lower-case hex digits, got '{}'", object.hash));
  }
  const std::string owner = fmt::format("object '{}'", object.name);
  for (const auto* text : {&object.name, &object.file, &object.first_seen_utc}) check_text(owner, *text);
  for (const double extent : object.extents_m) check_finite(owner + ": an extent", extent);
  for (const double attribute : numbers(object.attributes)) check_finite(owner + ": an attribute", attribute);
}

void check_sample(const Sample& sample) {
  if (!is_hash(sample.object)) {
    throw InputError(
        fmt::format("a sample's object must be a hash of 64 lower-case hex digits, got '{}'", sample.object));
  }
  check_text("sample: task", sample.task);
  for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
    check_finite(fmt::format("sample: input '{}'", feature_names()[i]), sample.inputs[i]);
  }
  check_from_one("sample: plane", sample.plane);
  check_from_one("sample: symbol", sample.symbol);
  check_from_one("sample: virtual_fingers", sample.virtual_fingers);
  check_finite("sample: approach_m", sample.approach_m);
  check_finite("sample: approach_ratio", sample.approach_ratio);
  for (const double component : sample.wrench) check_finite_or_unknown("sample: wrench component", component);
  check_finite_or_unknown("sample: score", sample.score);
}

void check_state(const ClassifierState& state) {
  if (state.component.empty()) throw InputError("a classifier state must name its component");
  check_text("classifier state: component", state.component);
  check_text("classifier state: parameters", state.parameters_json);
}

void bind_object(sqlite::Statement& statement, const MemoryObject& object) {
  statement.bind(object.hash).bind(object.name).bind(object.file);
  for (const double extent : object.extents_m) statement.bind(extent);
  for (const double attribute : numbers(object.attributes)) statement.bind(attribute);
  statement.bind(object.first_seen_utc);
}

void bind_sample(sqlite::Statement& statement, const Sample& sample, std::int64_t session) {
  statement.bind(sample.object).bind(provenance_name(sample.provenance));
  for (const double input : sample.inputs) statement.bind(input);
  statement.bind(sample.plane).bind(sample.symbol).bind(sample.virtual_fingers);
  statement.bind(sample.approach_m).bind(sample.approach_ratio);
  for (const double component : sample.wrench) statement.bind(component);
  statement.bind(sample.score).bind(sample.task).bind(session);
}

void bind_state(sqlite::Statement& statement, const ClassifierState& state, std::int64_t session) {
  const TrainingOutcome& outcome = state.outcome;
  statement.bind(state.component).bind(state.parameters_json).bind_blob(state.bytes).bind(state.last_sample);
  statement.bind(outcome.status == TrainingOutcome::Status::kArrived ? 1 : 0);
  statement.bind(outcome.epochs)
      .bind(outcome.restarts)
      .bind(outcome.mean_squared_error)
      .bind(outcome.wrong_rows);
  statement.bind(std::bit_cast<std::int64_t>(state.seed)).bind(session);
}

MemoryObject read_object(sqlite::Statement& statement) {
  MemoryObject object;
  object.first_seen = statement.integer();
  object.hash = statement.text();
  object.name = statement.text();
  object.file = statement.text();
  for (double& extent : object.extents_m) extent = statement.number();
  ObjectAttributes& a = object.attributes;
  for (double* attribute :
       {&a.width_normalised, &a.height_normalised, &a.depth_normalised, &a.vertices_per_triangle,
        &a.normals_per_triangle, &a.faces_per_triangle, &a.kilotriangles}) {
    *attribute = statement.number();
  }
  object.first_seen_utc = statement.text();
  return object;
}

Sample read_sample(sqlite::Statement& statement) {
  Sample sample;
  sample.id = statement.integer();
  sample.object = statement.text();
  sample.provenance = provenance_of(statement.text());
  for (double& input : sample.inputs) input = statement.number();
  for (int* target : {&sample.plane, &sample.symbol, &sample.virtual_fingers}) {
    *target = static_cast<int>(statement.integer());
  }
  sample.approach_m = statement.number();
  sample.approach_ratio = statement.number();
  for (double& component : sample.wrench) component = statement.number();
  sample.score = statement.number();
  sample.task = statement.text();
  sample.session = statement.integer();
  return sample;
}

ClassifierState read_state(sqlite::Statement& statement) {
  using Status = TrainingOutcome::Status;
  ClassifierState state;
  state.id = statement.integer();
  state.component = statement.text();
  state.parameters_json = statement.text();
  state.bytes = statement.blob();
  state.last_sample = statement.integer();
  state.outcome.status = statement.integer() ? Status::kArrived : Status::kStalled;
  state.outcome.epochs = statement.integer();
  state.outcome.restarts = statement.integer();
  state.outcome.mean_squared_error = statement.number();
  state.outcome.wrong_rows = statement.integer();
  state.seed = std::bit_cast<std::uint64_t>(statement.integer());
  state.session = statement.integer();
  return state;
}

}  // namespace preshape
