#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <sqlite3.h>

namespace preshape::sqlite {

class Statement;

/// An open database. Every failure is an InputError that names the file and the mend.
class Connection {
 public:
  /// @param file absolute path, or ":memory:"; @param name how messages call it
  Connection(const std::string& file, std::string name, int flags);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& name() const { return name_; }
  void set_busy_timeout(double seconds);
  /// Runs statements that give no rows and take no values.
  void execute(const char* sql);
  /// The same, tried again until the busy time-out: SQLite gives up at once where two processes that both hold
  /// a lock want more of it, as when both change the journal mode.
  void execute_insisting(const char* sql);
  /// The first column of the first row of a query.
  std::int64_t integer(const char* sql);
  /// Also when writing was asked for and the file does not permit it.
  bool read_only() const { return sqlite3_db_readonly(handle_, "main") == 1; }
  bool in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }
  std::int64_t last_row() const { return sqlite3_last_insert_rowid(handle_); }
  std::int64_t changes() const { return sqlite3_changes64(handle_); }
  /// Puts all of this database in the place of another's content.
  void copy_to(Connection& other) const;
  /// Undoes an open transaction; never throws.
  void roll_back() noexcept;

  [[noreturn]] void fail() const;

 private:
  friend class Statement;
  sqlite3* handle_ = nullptr;
  std::string name_;
  double busy_timeout_s_ = 0.0;
};

/// A prepared statement. Values are bound in order, columns read in order; NaN is NULL both ways.
class Statement {
 public:
  Statement(Connection& connection, std::string_view sql);
  ~Statement() { sqlite3_finalize(handle_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(std::int64_t value);
  Statement& bind(int value) { return bind(std::int64_t{value}); }
  Statement& bind(double value);
  Statement& bind(std::string_view text);
  Statement& bind_blob(std::string_view bytes);

  /// To the next row. @returns false at the end
  bool step();
  /// Runs a statement that gives no rows.
  void run() {
    while (step()) {
    }
  }

  std::int64_t integer();
  double number();
  std::string text();
  std::string blob();

 private:
  void check(int code) const;
  Connection& connection_;
  sqlite3_stmt* handle_ = nullptr;
  int bound_ = 0, read_ = 0;
};

}  // namespace preshape::sqlite
