#include "agent/sqlite.h"

#include <chrono>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape::sqlite {

namespace {

/// What went wrong and the mend, as the end of a sentence that begins with the memory's name.
std::string explanation(int code, int system_error, const char* text, double busy_timeout_s) {
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return fmt::format(
          "is in use by another process, also after {} s of waiting; try again when that has ended",
          busy_timeout_s);
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "cannot be written; give yourself write permission on the file and its folder, or open it "
             "read-only";
    case SQLITE_CANTOPEN:
      return fmt::format("cannot be opened ({}); check the permissions of the file and its folder",
                         system_error ? std::strerror(system_error) : text);
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return fmt::format("is damaged ({}); put a copy in its place", text);
    case SQLITE_FULL:
      return "cannot grow, the disk is full; make room and try again";
    case SQLITE_IOERR:
      return fmt::format("cannot be read or written ({}, {}); check the disk", text,
                         system_error ? std::strerror(system_error) : "no system error");
    case SQLITE_TOOBIG:
      return "cannot take a value of this size; keep it under 1 GB";
    default:
      return fmt::format("does not work as a memory ({}); put a copy in its place", text);
  }
}

}  // namespace

Connection::Connection(const std::string& file, std::string name, int flags) : name_(std::move(name)) {
  const int code = sqlite3_open_v2(file.c_str(), &handle_, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  if (code != SQLITE_OK) {
    try {
      fail();
    } catch (...) {
      sqlite3_close_v2(handle_);  // the handle is there even when opening failed
      throw;
    }
  }
  sqlite3_extended_result_codes(handle_, 1);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
}

Connection::~Connection() {
  sqlite3_close_v2(handle_);
}

void Connection::fail() const {
  const int code = handle_ ? sqlite3_errcode(handle_) : SQLITE_NOMEM;
  const char* text = handle_ ? sqlite3_errmsg(handle_) : "out of memory";
  throw InputError(fmt::format("memory '{}' {}", name_,
                               explanation(code, sqlite3_system_errno(handle_), text, busy_timeout_s_)));
}

void Connection::set_busy_timeout(double seconds) {
  busy_timeout_s_ = seconds;
  sqlite3_busy_timeout(handle_, static_cast<int>(seconds * 1000.0));
}

void Connection::execute(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Connection::execute_insisting(const char* sql) {
  constexpr auto kPause = std::chrono::milliseconds(5);
  for (auto left = std::chrono::duration<double>(busy_timeout_s_); left.count() > 0.0; left -= kPause) {
    const int code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr);
    if (code == SQLITE_OK) return;
    if ((code & 0xff) != SQLITE_BUSY) fail();
    std::this_thread::sleep_for(kPause);
  }
  execute(sql);
}

std::int64_t Connection::integer(const char* sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer() : 0;
}

void Connection::copy_to(Connection& other) const {
  sqlite3_backup* backup = sqlite3_backup_init(other.handle_, "main", handle_, "main");
  if (!backup) other.fail();
  const int outcome = sqlite3_backup_step(backup, -1);
  sqlite3_backup_finish(backup);
  if (outcome != SQLITE_DONE) fail();
}

void Connection::roll_back() noexcept {
  // A failure here means that SQLite has undone it already.
  if (in_transaction()) sqlite3_exec(handle_, "ROLLBACK", nullptr, nullptr, nullptr);
}

Statement::Statement(Connection& connection, std::string_view sql) : connection_(connection) {
  check(sqlite3_prepare_v2(connection.handle_, sql.data(), static_cast<int>(sql.size()), &handle_, nullptr));
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) connection_.fail();
}

Statement& Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(handle_, ++bound_, value));
  return *this;
}

Statement& Statement::bind(double value) {
  check(sqlite3_bind_double(handle_, ++bound_, value));  // SQLite itself turns NaN into NULL
  return *this;
}

Statement& Statement::bind(std::string_view text) {
  check(sqlite3_bind_text64(handle_, ++bound_, text.data() ? text.data() : "", text.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_blob(std::string_view bytes) {
  check(sqlite3_bind_blob64(handle_, ++bound_, bytes.data() ? bytes.data() : "", bytes.size(),
                            SQLITE_TRANSIENT));
  return *this;
}

bool Statement::step() {
  read_ = 0;
  const int code = sqlite3_step(handle_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) connection_.fail();
  return code == SQLITE_ROW;
}

std::int64_t Statement::integer() {
  return sqlite3_column_int64(handle_, read_++);
}

double Statement::number() {
  const int column = read_++;
  if (sqlite3_column_type(handle_, column) == SQLITE_NULL) return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(handle_, column);
}

std::string Statement::text() {
  const int column = read_++;
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
  return text ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)))
              : std::string();
}

std::string Statement::blob() {
  const int column = read_++;
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
  return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)))
               : std::string();
}

}  // namespace preshape::sqlite
