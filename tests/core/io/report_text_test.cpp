#include <regex>

#include "preshape/io/report_json.h"
#include "preshape/io/report_text.h"
#include "reports.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

/// The text with every run of blanks as one: sentences are wrapped.
std::string flat(const std::string& text) {
  std::string words;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || words.empty() || words.back() != ' ') words += blank ? ' ' : c;
  }
  return words;
}

bool has(const std::string& text, const std::string& part) { return flat(text).find(flat(part)) != std::string::npos; }

}  // namespace

TEST_CASE("Report in words: says how it ended, with the grasp, the modes and the object") {
  for (const RunRecord& record : records_of_every_status()) {
    const std::string text = report_text(record);
    INFO(text);
    CHECK(has(text, std::string(status_name(record.report.status))));
    CHECK(has(text, record.report.verdict));
    CHECK(has(text, record.object->object.name));
    CHECK(has(text, "task " + record.report.task.name));
    CHECK(has(text, "tfvadi"));
    for (const ModeAttempt& attempt : record.report.attempts) {
      CHECK(has(text, "mode " + std::to_string(attempt.mode)));
      CHECK(has(text, attempt.words));
    }
    CHECK(has(text, record.report.served() ? "\nPreshape\n" : "Best grasp that was tried"));
    CHECK(has(text, "lesson") == record.report.lesson.has_value());
    CHECK(has(text, "Nearest task of the task space") == !record.report.served());
  }
}

TEST_CASE("Report in words: no escape codes without colour; colour adds nothing but escape codes") {
  for (const RunRecord& record : records_of_every_status()) {
    const std::string plain = report_text(record), coloured = report_text(record, {true, false, true});
    CHECK_FALSE(has(plain, "\x1b"));
    CHECK(has(coloured, "\x1b["));
    CHECK(std::regex_replace(coloured, std::regex("\x1b\\[[0-9;]*m"), "") == plain);
  }
}

TEST_CASE("Report in words: the quiet form is the verdict and the preshape, and nothing more") {
  for (const RunRecord& record : records_of_every_status()) {
    const std::string text = report_text(record, {false, true, true});
    CHECK(has(text, record.report.verdict));
    CHECK(has(text, "plane "));
    CHECK(has(text, "carried out: ") == record.simulation.has_value());
    if (!record.second_try) CHECK(std::count(text.begin(), text.end(), '\n') == 3 + (record.report.nearest ? 1 : 0) + (record.simulation ? 1 : 0));
    CHECK_FALSE(has(text, " ms"));
  }
}

TEST_CASE(
    "Report in words: the open hand's approach volume has a line, in cubic centimetres and degrees, where "
    "there is one") {
  RunRecord record = records_of_every_status()[0];
  const Value report = report_value(record), &told = *report.find("simulation")->find("approach_volume");
  CHECK(has(
      report_text(record),
      fmt::format(
          "\n  open           approach volume {:.0f} cm3, entered {:.1f} degrees from the approach axis\n",
          1e6 * told.find("volume_m3")->number(), told.find("angle_to_approach_deg")->number())));
  record.simulation->fingers[0].finger = -1;  // none was free: one alone has no room beside it
  record.simulation->fingers.resize(2);
  CHECK_FALSE(has(report_text(record), "approach volume"));
}

TEST_CASE("Report in words: nothing is printed as minus zero, at any number of decimals") {
  const std::regex minus_zero("-0\\.0+(?![0-9])");
  for (RunRecord record : records_of_every_status()) {
    // Numbers that round to zero from below, where reports have them.
    auto& grasp = record.report.result->grasp;
    for (ContactFrame& C : grasp.contacts) C.n.z() = -1e-17, C.p_OC.x() = -1e-9;
    grasp.resultant = Wrench({-0.001, 0.004, -0.0}, {-0.0049, -1.0, -0.006});
    grasp.approach_fraction = -0.0001;
    record.report.task.screw = {-0.001, -0.0, 1, -0.004, 0, 0.05};
    for (const bool quiet : {false, true}) {
      const std::string text = report_text(record, {false, quiet, true});
      INFO(text);
      CHECK_FALSE(std::regex_search(text, minus_zero));
    }
    CHECK(has(report_text(record), "-0.01"));  // what does not round to zero keeps its sign
  }
}

TEST_CASE("Report in words: timings are told, and left out on request") {
  const RunRecord& record = records_of_every_status()[0];
  CHECK(has(report_text(record), "controller"));
  CHECK_FALSE(has(report_text(record, {false, false, false}), "controller"));
}

TEST_CASE("Report in words: a run without any grasp is told too") {
  RunRecord record = records_of_every_status()[3];
  record.report.result.reset();
  const std::string text = report_text(record);
  CHECK(has(text, "deadlock"));
  CHECK_FALSE(has(text, "Best grasp"));
}

TEST_SUITE_END();
