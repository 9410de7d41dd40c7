#include "agent/memory_csv_record.h"

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {
constexpr int kEnd = std::char_traits<char>::eof();
}

CsvRecords::CsvRecords(std::istream& in, std::string_view source) : in_(*in.rdbuf()), source_(source) {
  // Spreadsheets put a byte order mark in front.
  for (const char mark : {'\xef', '\xbb', '\xbf'}) {
    if (in_.sgetc() == std::char_traits<char>::to_int_type(mark)) in_.sbumpc();
  }
}

void CsvRecords::fail(std::string_view sentence) const {
  throw InputError(fmt::format("{}:{}: {}", source_, record_line_, sentence));
}

int CsvRecords::take() {
  const int c = in_.sbumpc();
  if (c == '\n') ++line_;
  return c;
}

bool CsvRecords::at_field_end() {
  const int c = in_.sgetc();
  return c == kEnd || c == ',' || c == '\n' || c == '\r';
}

bool CsvRecords::next(std::vector<std::string>& fields) {
  do {
    record_line_ = line_;
    if (in_.sgetc() == kEnd) return false;
    read_record(fields);
  } while (fields.size() == 1 && fields.front().empty());
  return true;
}

void CsvRecords::read_record(std::vector<std::string>& fields) {
  fields.clear();
  for (;;) {
    fields.push_back(in_.sgetc() == '"' ? read_quoted() : read_plain());
    int end = take();
    if (end == ',') continue;
    if (end == '\r') end = take();
    if (end != '\n' && end != kEnd) fail("a carriage return within a line; put the field in quotes");
    return;
  }
}

std::string CsvRecords::read_plain() {
  std::string field;
  while (!at_field_end()) {
    if (in_.sgetc() == '"')
      fail("a quote within a field without quotes; put the field in quotes and double it");
    field += static_cast<char>(take());
  }
  return field;
}

std::string CsvRecords::read_quoted() {
  std::string field;
  take();
  for (;;) {
    const int c = take();
    if (c == kEnd) fail("a quoted field is not closed");
    if (c != '"') {
      field += static_cast<char>(c);
    } else if (in_.sgetc() == '"') {
      field += static_cast<char>(take());
    } else {
      break;
    }
  }
  if (!at_field_end()) fail("text after a closing quote; double a quote within a field");
  return field;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace preshape
