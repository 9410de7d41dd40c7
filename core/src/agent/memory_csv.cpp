#include "preshape/agent/memory_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "agent/memory_csv_record.h"
#include "agent/memory_rows.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/base/value.h"

namespace preshape {

namespace {

struct Row {
  MemoryObject object;
  Sample sample;
};

/// One column: how a row is written and read. `set` throws InputError with the end of a sentence.
struct Column {
  std::string name;
  std::function<std::string(const Row&)> text;
  std::function<void(Row&, const std::string&)> set;
};

template <class Number>
Number parsed(const std::string& text, std::string_view kind) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) {
    throw InputError(fmt::format("must be a {}, got '{}'", kind, text));
  }
  return number;
}

double parsed_finite(const std::string& text) {
  const double number = parsed<double>(text, "number");
  if (!std::isfinite(number)) throw InputError(fmt::format("must be a finite number, got '{}'", text));
  return number;
}

/// @param member the row's value, as a reference
template <class Member>
Column text_column(std::string name, Member member) {
  return {std::move(name), [member](const Row& row) { return member(const_cast<Row&>(row)); },
          [member](Row& row, const std::string& text) { member(row) = text; }};
}

template <class Member>
Column number_column(std::string name, Member member) {
  return {std::move(name), [member](const Row& row) { return number_text(member(const_cast<Row&>(row))); },
          [member](Row& row, const std::string& text) { member(row) = parsed_finite(text); }};
}

template <class Member>
Column unknown_or_number_column(std::string name, Member member) {
  Column column = number_column(std::move(name), member);
  column.text = [member](const Row& row) {
    const double number = member(const_cast<Row&>(row));
    return std::isnan(number) ? std::string() : number_text(number);
  };
  column.set = [member](Row& row, const std::string& text) {
    member(row) = text.empty() ? std::numeric_limits<double>::quiet_NaN() : parsed_finite(text);
  };
  return column;
}

Column count_column(std::string name, int Sample::*member) {
  return {std::move(name), [member](const Row& row) { return std::to_string(row.sample.*member); },
          [member](Row& row, const std::string& text) {
            row.sample.*member = parsed<int>(text, "whole number");
            if (row.sample.*member < 1) throw InputError(fmt::format("must be 1 or more, got '{}'", text));
          }};
}

Column hash_column() {
  return {"object_hash", [](const Row& row) { return row.sample.object; },
          [](Row& row, const std::string& text) {
            if (text.size() != 64 || text.find_first_not_of("0123456789abcdef") != std::string::npos) {
              throw InputError(fmt::format("must be 64 lower-case hex digits, got '{}'", text));
            }
            row.object.hash = row.sample.object = text;
          }};
}

Column provenance_column() {
  return {"provenance", [](const Row& row) { return std::string(provenance_name(row.sample.provenance)); },
          [](Row& row, const std::string& text) { row.sample.provenance = provenance_of(text); }};
}

std::vector<Column> make_columns() {
  std::vector<Column> columns = {
      hash_column(), text_column("object_name", [](Row& r) -> std::string& { return r.object.name; }),
      text_column("object_file", [](Row& r) -> std::string& { return r.object.file; })};
  const char* const extents[] = {"width_m", "height_m", "depth_m"};
  for (std::size_t i = 0; i < 3; ++i) {
    columns.push_back(number_column(extents[i], [i](Row& r) -> double& { return r.object.extents_m[i]; }));
  }
  columns.push_back(provenance_column());
  for (std::size_t i = 0; i < feature_names().size(); ++i) {
    columns.push_back(number_column(std::string(feature_names()[i]),
                                    [i](Row& r) -> double& { return r.sample.inputs[i]; }));
  }
  columns.push_back(count_column("plane", &Sample::plane));
  columns.push_back(count_column("symbol", &Sample::symbol));
  columns.push_back(count_column("virtual_fingers", &Sample::virtual_fingers));
  columns.push_back(number_column("approach_m", [](Row& r) -> double& { return r.sample.approach_m; }));
  columns.push_back(
      number_column("approach_ratio", [](Row& r) -> double& { return r.sample.approach_ratio; }));
  const char* const wrench[] = {"fx", "fy", "fz", "mx", "my", "mz"};
  for (std::size_t i = 0; i < 6; ++i) {
    columns.push_back(
        unknown_or_number_column(wrench[i], [i](Row& r) -> double& { return r.sample.wrench[i]; }));
  }
  columns.push_back(unknown_or_number_column("score", [](Row& r) -> double& { return r.sample.score; }));
  columns.push_back(text_column("task", [](Row& r) -> std::string& { return r.sample.task; }));
  return columns;
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = make_columns();
  return all;
}

template <class Text>
void write_line(std::ostream& out, Text text) {
  for (std::size_t i = 0; i < columns().size(); ++i) {
    if (i > 0) out.put(',');
    out << csv_field(text(columns()[i]));
  }
  out.put('\n');
}

/// The columns in the order of the header line.
std::vector<const Column*> read_header(CsvRecords& records) {
  std::vector<std::string> names, known;
  for (const Column& column : columns()) known.push_back(column.name);
  if (!records.next(names)) records.fail("no header line; the first line must name the columns");
  std::vector<const Column*> order;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      records.fail(fmt::format("unknown column '{}'{}", name, did_you_mean(name, known)));
    const Column* column = &columns()[static_cast<std::size_t>(found - known.begin())];
    if (std::find(order.begin(), order.end(), column) != order.end()) {
      records.fail(fmt::format("column '{}' stands twice in the header; keep one", name));
    }
    order.push_back(column);
  }
  for (const Column& column : columns()) {
    if (std::find(order.begin(), order.end(), &column) == order.end()) {
      records.fail(fmt::format("the header lacks column '{}'; add it", column.name));
    }
  }
  return order;
}

Row read_row(const CsvRecords& records, const std::vector<const Column*>& order,
             const std::vector<std::string>& fields) {
  if (fields.size() != order.size()) {
    records.fail(fmt::format("{} fields, but the header names {} columns", fields.size(), order.size()));
  }
  Row row;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    try {
      if (fields[i].find('\0') != std::string::npos)
        throw InputError("contains a zero byte; give plain text");
      order[i]->set(row, fields[i]);
    } catch (const InputError& error) {
      records.fail(fmt::format("column '{}' {}", order[i]->name, error.what()));
    }
  }
  const auto& in = row.sample.inputs;
  row.object.attributes = {in[8], in[9], in[10], in[11], in[12], in[13], in[14]};
  return row;
}

/// A hash names one object: what its rows say of it must agree.
class ObjectsOfSource {
 public:
  void check(const CsvRecords& records, const MemoryObject& object) {
    const auto [entry, is_new] = first_.try_emplace(object.hash, records.line(), object);
    const auto& [line, first] = entry->second;
    if (!is_new &&
        (first.name != object.name || first.file != object.file || first.extents_m != object.extents_m)) {
      records.fail(
          fmt::format("its object's name, file or extents differ from line {}, which has the same "
                      "object_hash; make them agree",
                      line));
    }
  }

 private:
  std::map<std::string, std::pair<int, MemoryObject>> first_;
};

}  // namespace

void export_samples(const Memory& memory, std::ostream& out) {
  const auto moment = memory.snapshot();
  std::map<std::string, MemoryObject> objects;
  for (auto& object : memory.objects()) objects.emplace(object.hash, object);
  write_line(out, [](const Column& column) { return column.name; });
  for (const Sample& sample : memory.samples()) {
    const Row row{objects.at(sample.object), sample};
    write_line(out, [&](const Column& column) { return column.text(row); });
  }
}

std::int64_t import_samples(Memory& memory, std::istream& in, std::string_view source) {
  if (!in) throw InputError(fmt::format("{} cannot be read; check the path and its permissions", source));
  CsvRecords records(in, source);
  const auto order = read_header(records);
  Learning learning = memory.begin_learning();
  ObjectsOfSource seen;
  std::vector<std::string> fields;
  std::int64_t count = 0;
  for (; records.next(fields); ++count) {
    const Row row = read_row(records, order, fields);
    seen.check(records, row.object);
    learning.add_object(row.object);
    learning.add_sample(row.sample);
  }
  if (count > 0) learning.commit();
  return count;
}

}  // namespace preshape
