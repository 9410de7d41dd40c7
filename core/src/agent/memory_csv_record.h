#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace preshape {

/// Reads comma-separated values, quoted as in RFC 4180, record by record.
class CsvRecords {
 public:
  CsvRecords(std::istream& in, std::string_view source);

  /// The next record that is no blank line. @returns false at the end
  /// @throws InputError on a stray or unclosed quote
  bool next(std::vector<std::string>& fields);
  /// Line on which the last record began, from 1.
  int line() const { return record_line_; }
  /// @throws InputError "source:line: sentence" of the last record
  [[noreturn]] void fail(std::string_view sentence) const;

 private:
  int take();
  bool at_field_end();
  void read_record(std::vector<std::string>& fields);
  std::string read_plain();
  std::string read_quoted();

  std::streambuf& in_;
  std::string source_;
  int line_ = 1, record_line_ = 1;
};

/// With quotes around it where it needs them.
std::string csv_field(std::string_view text);

}  // namespace preshape
