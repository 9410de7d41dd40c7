#include "preshape/io/table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace preshape {

namespace {

std::string terminal_cell(const Value& value) {
  if (value.is_nil()) return "-";
  if (value.is_string()) return value.string();
  if (!value.is_number()) return value.text();
  if (value.is_integer() && std::abs(value.number()) < 1e9) return fmt::format("{}", value.integer());
  std::string text = fmt::format("{:.3f}", value.number());
  return text == "-0.000" ? "0.000" : text;
}

std::string csv_cell(const Value& value) {
  if (value.is_nil()) return "";
  const std::string text = value.is_string() ? value.string() : value.text();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string table_text(const Table& table) {
  std::vector<std::size_t> widths;
  for (const auto& column : table.columns) widths.push_back(column.size());
  std::vector<std::vector<std::string>> cells;
  for (const auto& row : table.rows) {
    auto& line = cells.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      line.push_back(terminal_cell(row[i]));
      widths[i] = std::max(widths[i], line.back().size());
    }
  }
  std::string text;
  const auto add = [&](std::size_t i, const std::string& cell, bool right, bool last) {
    if (right) text += fmt::format("{:>{}}", cell, widths[i]);
    else text += last ? cell : fmt::format("{:<{}}", cell, widths[i]);
    text += last ? "\n" : "  ";
  };
  const auto numeric = [&](std::size_t i) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const auto& row) { return i < row.size() && row[i].is_number(); });
  };
  for (std::size_t i = 0; i < table.columns.size(); ++i) add(i, table.columns[i], numeric(i), i + 1 == table.columns.size());
  for (const auto& line : cells) {
    for (std::size_t i = 0; i < line.size(); ++i) add(i, line[i], numeric(i), i + 1 == line.size());
  }
  return text;
}

std::string table_csv(const Table& table) {
  std::string text;
  const auto add = [&](const std::string& cell, bool last) { text += cell + (last ? "\r\n" : ","); };
  for (std::size_t i = 0; i < table.columns.size(); ++i) add(csv_cell(table.columns[i]), i + 1 == table.columns.size());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) add(csv_cell(row[i]), i + 1 == row.size());
  }
  return text;
}

}  // namespace preshape
