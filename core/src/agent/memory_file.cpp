#include "agent/memory_file.h"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

#include "agent/memory_schema.h"
#include "preshape/base/error.h"

namespace preshape {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw InputError(fmt::format("memory '{}' {}", path.string(), why));
}

std::uint32_t big_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Looks at a file with plain reads: SQLite would roll a foreign database's journal back, or make an empty
/// file of a text file its own.
/// @returns false when the file is empty
bool check_header(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, fmt::format("cannot be read ({}); check its permissions", std::strerror(errno)));
  char header[100] = {};
  file.read(header, sizeof header);
  if (file.gcount() == 0) return false;
  if (std::memcmp(header, "SQLite format 3", 16) != 0) {
    refuse(path, "is not a memory but some other kind of file; name another file");
  }
  if (file.gcount() < static_cast<std::streamsize>(sizeof header)) {
    refuse(path, "is damaged (cut off within its header); put a copy in its place");
  }
  if (big_endian(header + 68) != kMemoryApplicationId) {
    refuse(path, "is the SQLite database of another program; name another file");
  }
  return true;
}

/// @returns true when the file has to be made
bool check_path(const fs::path& path, Memory::Mode mode) {
  if (path.empty() || path.native().find('\0') != std::string::npos)
    refuse(path, "has no usable path; name a file");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    if (mode == Memory::Mode::kCreate) return true;
    refuse(path, "does not exist; check the path, or make it by opening it to create");
  }
  if (status.type() == fs::file_type::none) {
    refuse(path, fmt::format("cannot be reached ({}); check the permissions of its folder", error.message()));
  }
  if (status.type() == fs::file_type::directory) refuse(path, "is a directory; name a file in it");
  if (status.type() != fs::file_type::regular) refuse(path, "is not a regular file; name another one");
  if (check_header(path)) return false;
  if (mode != Memory::Mode::kCreate) refuse(path, "is an empty file; open it to create, or name another one");
  return true;
}

std::int64_t check_version(sqlite::Connection& connection, const fs::path& path) {
  const std::int64_t version = connection.integer("PRAGMA user_version");
  if (version > kMemorySchemaVersion) {
    refuse(path, fmt::format(
                     "was written by a newer preshape (schema {}, this one knows up to {}); use that version",
                     version, kMemorySchemaVersion));
  }
  return version;
}

/// A memory on a read-only medium: SQLite cannot make the log's shared memory beside it. Nobody can write
/// there, so the file may be read as it is, unless a log with newer rows was left beside it.
bool needs_no_log(const fs::path& path) {
  std::error_code ignored;
  const fs::path log = path.string() + "-wal";
  const fs::path folder = path.parent_path();
  return ::access(folder.c_str(), W_OK) != 0 &&
         (!fs::exists(log, ignored) || fs::file_size(log, ignored) == 0);
}

/// For an URI: everything but the plain characters as %XX.
std::string uri_of(const fs::path& path) {
  std::string uri = "file:";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) || std::strchr("/._-", c));
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return uri + "?immutable=1";
}

void configure(sqlite::Connection& connection) {
  connection.execute(
      "PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON;"
      "PRAGMA synchronous = FULL");
}

std::unique_ptr<sqlite::Connection> open_read_only(const fs::path& path, double busy_timeout_s) {
  const fs::path file = fs::absolute(path);
  const bool as_is = needs_no_log(file);
  auto connection =
      std::make_unique<sqlite::Connection>(as_is ? uri_of(file) : file.string(), path.string(),
                                           SQLITE_OPEN_READONLY | (as_is ? SQLITE_OPEN_URI : 0));
  connection->set_busy_timeout(busy_timeout_s);
  configure(*connection);
  if (check_version(*connection, path) < kMemorySchemaVersion) {
    refuse(path, "is of an older schema; open it once for writing, which brings it up to date");
  }
  return connection;
}

}  // namespace

std::unique_ptr<sqlite::Connection> open_memory_file(const fs::path& path, Memory::Mode mode,
                                                     double busy_timeout_s) {
  const bool make = check_path(path, mode);
  if (mode == Memory::Mode::kReadOnly) return open_read_only(path, busy_timeout_s);
  // The absolute path keeps names such as ":memory:" from meaning something else to SQLite.
  auto connection = std::make_unique<sqlite::Connection>(
      fs::absolute(path).string(), path.string(), SQLITE_OPEN_READWRITE | (make ? SQLITE_OPEN_CREATE : 0));
  connection->set_busy_timeout(busy_timeout_s);
  if (connection->read_only())
    refuse(path, "cannot be written; change its permissions, or open it read-only");
  configure(*connection);
  // The schema is written under the plain journal first, so that the file's header names us from then on.
  if (check_version(*connection, path) < kMemorySchemaVersion) upgrade_memory_schema(*connection);
  connection->execute_insisting("PRAGMA journal_mode = WAL");
  return connection;
}

std::unique_ptr<sqlite::Connection> open_memory_in_memory() {
  auto connection = std::make_unique<sqlite::Connection>(":memory:", "(in memory)",
                                                         SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  configure(*connection);
  upgrade_memory_schema(*connection);
  return connection;
}

}  // namespace preshape
