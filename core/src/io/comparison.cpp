#include "preshape/io/comparison.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "preshape/io/report_json.h"

namespace preshape {

namespace {

/// A time differs when it is longer or shorter by more than this factor: the clock is not steady enough for less.
constexpr double kOtherTime = 1.5;

double seconds_of(const RunRecord& record) {
  for (const auto& timing : record.timings) {
    if (timing.stage == "controller") return timing.seconds;
  }
  return 0.0;
}

/// "hard_finger mu=0.6": a choice as a person would say it, lists that are keys of their own left out.
std::string choice_text(const Value& choice) {
  if (choice.is_nil()) return "-";
  if (choice.is_string()) return choice.string();
  const Value* name = choice.find("name");
  if (!name || !name->is_string()) return choice.text();
  std::string text = name->string();
  for (const auto& [key, value] : choice.entries()) {
    if (key != "name" && !value.is_list()) text += fmt::format(" {}={}", key, value.text());
  }
  return text;
}

struct Cell {
  std::string text;
  bool differs = false;
};

/// What a column shows of a run and how two runs differ in it.
class Column {
 public:
  virtual ~Column() = default;
  explicit Column(std::string head) : head_(std::move(head)) {}
  const std::string& head() const { return head_; }
  virtual std::string text(const RunRecord& record) const = 0;
  virtual bool differs(const RunRecord& first, const RunRecord& other) const { return text(first) != text(other); }

 private:
  std::string head_;
};

template <class Text>
class TextColumn final : public Column {
 public:
  TextColumn(std::string head, Text text) : Column(std::move(head)), text_(std::move(text)) {}
  std::string text(const RunRecord& record) const override { return text_(record); }

 private:
  Text text_;
};

class TimeColumn final : public Column {
 public:
  TimeColumn() : Column("ms") {}
  std::string text(const RunRecord& record) const override { return fmt::format("{:.1f}", 1e3 * seconds_of(record)); }
  bool differs(const RunRecord& first, const RunRecord& other) const override {
    const double a = seconds_of(first), b = seconds_of(other);
    return std::max(a, b) > kOtherTime * std::min(a, b);
  }
};

using Columns = std::vector<std::unique_ptr<Column>>;

template <class Text>
void add(Columns& columns, std::string head, Text text) {
  columns.push_back(std::make_unique<TextColumn<Text>>(std::move(head), std::move(text)));
}

/// Of the run's grasp, or "-" where it has none.
template <class Text>
void add_of_grasp(Columns& columns, std::string head, Text text) {
  add(columns, std::move(head), [text](const RunRecord& record) -> std::string {
    const auto& result = record.report.result;
    return result && result->grasp.is_grasp() ? text(*result) : "-";
  });
}

std::optional<double> quality_number(const RunRecord& record, const std::string& name) {
  const auto& result = record.report.result;
  if (!result || !result->grasp.is_grasp()) return std::nullopt;
  for (std::size_t i = 0; i < record.quality_numbers.size() && i < result->grasp.quality.size(); ++i) {
    if (record.quality_numbers[i].name == name) return result->grasp.quality[i];
  }
  return std::nullopt;
}

std::string number_cell(std::optional<double> number) {
  return number ? fmt::format("{:.4g}", *number) : "-";
}

/// Names of the quality numbers that the runs do not share.
std::vector<std::string> differing_numbers(const std::vector<const RunRecord*>& records) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const RunRecord* record : records) {
    for (const auto& number : record->quality_numbers) {
      if (!seen.insert(number.name).second) continue;
      const std::string first = number_cell(quality_number(*records.front(), number.name));
      const bool differs = std::any_of(records.begin(), records.end(), [&](const RunRecord* other) {
        return number_cell(quality_number(*other, number.name)) != first;
      });
      if (differs) names.push_back(number.name);
    }
  }
  return names;
}

/// The measure's name where all runs have the same.
std::string measure_head(const std::vector<const RunRecord*>& records, std::string RunRecord::*measure, const char* else_head) {
  const std::string& first = records.front()->*measure;
  const bool same = std::all_of(records.begin(), records.end(), [&](const RunRecord* r) { return r->*measure == first; });
  return same ? first : else_head;
}

Columns columns_of(const std::vector<const RunRecord*>& records) {
  Columns columns;
  add(columns, "outcome", [](const RunRecord& r) { return fmt::format("{} ({})", status_name(r.report.status), r.report.mode); });
  add_of_grasp(columns, "plane", [](const JudgedGrasp& g) { return fmt::format("{}", g.grasp.plane + 1); });
  add_of_grasp(columns, "x/half", [](const JudgedGrasp& g) { return fmt::format("{:+.2f}", g.grasp.approach_fraction); });
  add_of_grasp(columns, "vf", [](const JudgedGrasp& g) { return fmt::format("{}", g.grasp.virtual_fingers); });
  add_of_grasp(columns, measure_head(records, &RunRecord::measure, "first"),
               [](const JudgedGrasp& g) { return fmt::format("{:.2f}", g.criticism.first); });
  add_of_grasp(columns, measure_head(records, &RunRecord::second_measure, "second"),
               [](const JudgedGrasp& g) { return fmt::format("{:.2f}", g.criticism.second); });
  for (const std::string& name : differing_numbers(records)) {
    add(columns, name, [name](const RunRecord& r) { return number_cell(quality_number(r, name)); });
  }
  if (std::any_of(records.begin(), records.end(), [](const RunRecord* r) { return r->simulation.has_value(); })) {
    add(columns, "simulation", [](const RunRecord& r) {
      if (!r.simulation) return std::string("-");
      const bool other = r.second_try && r.second_try->grasp;
      return fmt::format("{}{}", simulation_status_name(r.simulation->status), other ? ", another station reached" : "");
    });
  }
  columns.push_back(std::make_unique<TimeColumn>());
  return columns;
}

/// Aligned lines; stars stand behind what differs, in a place of their own so that the numbers stay below each other.
class Lines {
 public:
  explicit Lines(bool colour) : colour_(colour) {}
  void add(std::vector<Cell> line) {
    widths_.resize(std::max(widths_.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) widths_[i] = std::max(widths_[i], line[i].text.size());
    lines_.push_back(std::move(line));
  }
  std::string text() const {
    std::string text;
    for (const auto& line : lines_) {
      std::string row;
      for (std::size_t i = 0; i < line.size(); ++i) row += cell_text(line[i], widths_[i]) + ' ';
      row.erase(row.find_last_not_of(' ') + 1);
      text += row + '\n';
    }
    return text;
  }

 private:
  std::string cell_text(const Cell& cell, std::size_t width) const {
    const std::string padded = fmt::format("{:<{}}", cell.text + (cell.differs ? "*" : ""), width + 1);
    return colour_ && cell.differs ? "\x1b[33m" + padded + "\x1b[0m" : padded;
  }

  bool colour_;
  std::vector<std::size_t> widths_;
  std::vector<std::vector<Cell>> lines_;
};

std::vector<const RunRecord*> records_of(const Comparison& comparison) {
  std::vector<const RunRecord*> records;
  for (const auto& run : comparison.runs) {
    if (run.record) records.push_back(&*run.record);
  }
  return records;
}

}  // namespace

std::string comparison_text(const Comparison& comparison, bool colour) {
  const auto records = records_of(comparison);
  const Columns columns = records.empty() ? Columns{} : columns_of(records);
  Lines lines(colour);
  std::vector<Cell> heads = {{"#"}};
  for (const auto& key : comparison.keys) heads.push_back({key});
  for (const auto& column : columns) heads.push_back({column->head()});
  lines.add(std::move(heads));
  std::string refusals;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    std::vector<Cell> line = {{fmt::format("{}", i + 1)}};
    for (const Value& choice : run.choices) line.push_back({choice_text(choice)});
    if (!run.record) {
      line.push_back({"refused", true});
      refusals += fmt::format("row {}: {}\n", i + 1, run.refusal);
    }
    for (const auto& column : columns) {
      if (run.record) line.push_back({column->text(*run.record), column->differs(*records.front(), *run.record)});
    }
    lines.add(std::move(line));
  }
  std::string text = lines.text();
  if (comparison.runs.size() > 1) text += fmt::format("\n* differs from the first row that ran; a time, by more than a factor of {}\n", kOtherTime);
  return text + refusals;
}

Value comparison_value(const Comparison& comparison) {
  Value::List rows, keys;
  for (const auto& key : comparison.keys) keys.emplace_back(key);
  for (const auto& run : comparison.runs) {
    Value choices = Value::table({}), row = Value::table({});
    for (std::size_t i = 0; i < comparison.keys.size(); ++i) {
      if (!run.choices[i].is_nil()) choices.set(comparison.keys[i], run.choices[i]);
    }
    row.set("choices", std::move(choices));
    if (run.record) {
      row.set("report", report_value(*run.record));
      row.set("seconds", seconds_of(*run.record));
    } else {
      row.set("refusal", run.refusal);
    }
    rows.push_back(std::move(row));
  }
  return Value::table({{"schema", "preshape.comparison/1"},
                       {"scenario", comparison.scenario},
                       {"keys", Value::list(std::move(keys))},
                       {"rows", Value::list(std::move(rows))}});
}

}  // namespace preshape
