#include "report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "preshape/io/table.h"
#include "preshape/version.h"

namespace preshape::conformance {

namespace {

constexpr Outcome kOutcomes[] = {Outcome::kPass, Outcome::kWarn,  Outcome::kSkip,
                                 Outcome::kFail, Outcome::kCrash, Outcome::kTimeout};

std::string coloured(Outcome outcome, bool colour) {
  const std::string name(outcome_name(outcome));
  const std::string padded = name + std::string(8 - name.size(), ' ');
  if (!colour || outcome == Outcome::kPass) return padded;
  return fmt::format("\033[{}m{}\033[0m", is_bad(outcome) ? "31" : outcome == Outcome::kWarn ? "33" : "2", padded);
}

std::string counts_text(const ComponentReport& report) {
  std::string text;
  for (const Outcome outcome : kOutcomes) {
    const int count = report.count(outcome);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, outcome_name(outcome));
  }
  return text;
}

/// Bytes that XML 1.0 cannot carry are replaced.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '&': out += "&amp;"; break;
      case '"': out += "&quot;"; break;
      default: out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return out;
}

std::string case_xml(const ComponentReport& report, const CheckReport& check, const Plan& plan) {
  const Result& result = check.result;
  const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{} {}\" time=\"{:.3f}\"",
                                       escaped(report.subject.title()), check.check->id, escaped(check.check->property),
                                       result.seconds);
  switch (result.outcome) {
    case Outcome::kPass: return head + "/>\n";
    case Outcome::kSkip: return fmt::format("{}><skipped message=\"{}\"/></testcase>\n", head, escaped(result.text));
    case Outcome::kWarn: return fmt::format("{}><system-out>{}</system-out></testcase>\n", head, escaped(result.text));
    default: break;
  }
  const char* element = result.outcome == Outcome::kFail ? "failure" : "error";
  return fmt::format("{}><{} type=\"{}\" message=\"{}\">{}\nrun it alone: {}</{}></testcase>\n", head, element,
                     outcome_name(result.outcome), escaped(result.text.substr(0, result.text.find('\n'))),
                     escaped(result.text), escaped(rerun_command(report.subject, *check.check, plan)), element);
}

/// A warning tells of time, which is another at every run: it counts as passed.
std::string_view cell_text(Outcome outcome) {
  if (outcome == Outcome::kSkip) return "–";
  return is_bad(outcome) ? outcome_name(outcome) : "✓";
}

}  // namespace

std::string component_text(const ComponentReport& report, const Plan& plan, const ReportStyle& style) {
  std::string text;
  double seconds = 0.0;
  for (const CheckReport& check : report.checks) {
    const Result& result = check.result;
    seconds += result.seconds;
    if (style.quiet && (result.outcome == Outcome::kPass || result.outcome == Outcome::kSkip)) continue;
    text += fmt::format("  {} {} {}\n", check.check->id, coloured(result.outcome, style.colour), check.check->property);
    if (result.outcome == Outcome::kPass) continue;
    text += fmt::format("    {}\n", result.text);
    if (is_bad(result.outcome)) text += fmt::format("    run it alone: {}\n", rerun_command(report.subject, *check.check, plan));
  }
  return fmt::format("{} ({}), seed {}\n{}{}: {} ({:.1f} s of processes)\n", report.subject.title(),
                     report.subject.file.string(), plan.settings.seed, text,
                     report.conforms() ? "conforms" : "does not conform", counts_text(report), seconds);
}

std::string summary_text(std::span<const ComponentReport> reports) {
  Table table;
  table.columns = {"component", "verdict", "checks"};
  for (const auto& report : reports) {
    table.rows.push_back({report.subject.title(), report.conforms() ? "conforms" : "does not", counts_text(report)});
  }
  return "\n" + table_text(table);
}

std::string junit_text(std::span<const ComponentReport> reports, const Plan& plan) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const auto& report : reports) {
    double seconds = 0.0;
    std::string cases;
    for (const auto& check : report.checks) {
      cases += case_xml(report, check, plan);
      seconds += check.result.seconds;
    }
    text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n"
                        "{}  </testsuite>\n",
                        escaped(report.subject.title()), report.checks.size(), report.count(Outcome::kFail),
                        report.count(Outcome::kCrash) + report.count(Outcome::kTimeout), report.count(Outcome::kSkip),
                        seconds, cases);
  }
  return text + "</testsuites>\n";
}

std::string markdown_text(std::span<const ComponentReport> reports) {
  std::string text;
  for (const auto kind : kKinds) {
    std::vector<const ComponentReport*> columns;
    for (const auto& report : reports) {
      if (report.subject.kind == kind) columns.push_back(&report);
    }
    if (columns.empty()) continue;
    text += fmt::format("\n## {}\n\n| check | property |", kind);
    for (const auto* column : columns) text += fmt::format(" `{}` |", column->subject.name);
    text += "\n|---|---|" ;
    for (std::size_t i = 0; i < columns.size(); ++i) text += ":-:|";
    text += "\n";
    for (std::size_t row = 0; row < columns.front()->checks.size(); ++row) {
      const Check& check = *columns.front()->checks[row].check;
      text += fmt::format("| {} | {} |", check.id, check.property);
      for (const auto* column : columns) text += fmt::format(" {} |", cell_text(column->checks[row].result.outcome));
      text += "\n";
    }
  }
  text += "\n## Left out\n\nChecks of the published lists that do not fit the interfaces.\n\n| check | reason |\n|---|---|\n";
  for (const LeftOut& left : left_out()) text += fmt::format("| {} | {} |\n", left.id, left.reason);
  return text;
}

std::string json_text(std::span<const ComponentReport> reports, const Plan& plan) {
  using Json = nlohmann::ordered_json;
  Json components = Json::array();
  for (const auto& report : reports) {
    Json checks = Json::array();
    for (const auto& check : report.checks) {
      checks.push_back({{"id", check.check->id},
                        {"property", check.check->property},
                        {"outcome", outcome_name(check.result.outcome)},
                        {"text", check.result.text},
                        {"seconds", check.result.seconds}});
    }
    components.push_back({{"kind", report.subject.kind},
                          {"name", report.subject.name},
                          {"file", report.subject.file.string()},
                          {"conforms", report.conforms()},
                          {"checks", checks}});
  }
  const Json all = {{"preshape", PRESHAPE_VERSION_STRING}, {"seed", plan.settings.seed}, {"components", components}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace preshape::conformance
