#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>

#include "memory_examples.h"
#include "preshape/base/error.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;
namespace fs = std::filesystem;

TEST_SUITE_BEGIN("core/agent");

namespace {

using Mode = Memory::Mode;
constexpr Mode kModes[] = {Mode::kReadWrite, Mode::kCreate, Mode::kReadOnly};

void write_file(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A memory of `rows` samples, closed.
void make_memory(const fs::path& path, int rows = 3) {
  Memory memory = Memory::open(path, Mode::kCreate);
  Learning learning = memory.begin_learning();
  learning.add_object(example_object(1));
  for (int i = 0; i < rows; ++i) learning.add_sample(example_sample(1, static_cast<std::uint64_t>(i)));
  learning.commit();
}

void run_sql(const fs::path& path, const char* sql) {
  sqlite3* handle = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &handle) == SQLITE_OK);
  REQUIRE(sqlite3_exec(handle, sql, nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(handle);
}

/// Every mode refuses, in one sentence with the path, and the file stays as it is.
void refuse_all(const fs::path& path, const std::string& part) {
  const std::string before = fs::is_regular_file(path) ? read_file(path) : "";
  for (const Mode mode : kModes) {
    CHECK_THROWS_SAYING(Memory::open(path, mode), InputError, part);
    CHECK_THROWS_SAYING(Memory::open(path, mode), InputError, "memory '" + path.string() + "'");
  }
  if (fs::is_regular_file(path)) CHECK(read_file(path) == before);
}

/// Runs `body` in a child without root's rights, since root may write everywhere. Its text, "" when all is
/// well.
std::string as_nobody(const std::function<std::string()>& body) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    std::string text = "cannot become nobody";
    if (geteuid() != 0 || (setgid(65534) == 0 && setuid(65534) == 0)) {
      try {
        text = body();
      } catch (const std::exception& error) {
        text = error.what();
      }
    }
    const auto written = write(ends[1], text.data(), text.size());
    _exit(written == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  char buffer[1024];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  return text;
}

}  // namespace

TEST_CASE("Memory file: what is no memory is refused and left as it is") {
  const TemporaryDirectory folder;
  write_file(folder / "text.lua", "return { object = 'cube' }\n");
  refuse_all(folder / "text.lua", "is not a memory but some other kind of file; name another file");
  write_file(folder / "short", "SQLite format 3");
  refuse_all(folder / "short", "is damaged (cut off within its header)");
  write_file(folder / "cut", std::string("SQLite format 3\0and no more", 27));
  refuse_all(folder / "cut", "is damaged (cut off within its header)");
  run_sql(folder / "other.db", "CREATE TABLE sample (id); INSERT INTO sample VALUES (1)");
  refuse_all(folder / "other.db", "is the SQLite database of another program");
  fs::create_directory(folder / "directory");
  refuse_all(folder / "directory", "is a directory; name a file in it");
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  refuse_all(folder / "pipe", "is not a regular file");
  CHECK_THROWS_SAYING(Memory::open("", Mode::kCreate), InputError, "name a file");
}

TEST_CASE("Memory file: a foreign database's hot journal is not rolled back") {
  const TemporaryDirectory folder;
  run_sql(folder / "other.db", "CREATE TABLE t (id)");
  write_file(folder / "other.db-journal", "something of theirs");
  refuse_all(folder / "other.db", "another program");
  CHECK(read_file(folder / "other.db-journal") == "something of theirs");
}

TEST_CASE("Memory file: an absent one is made only when asked") {
  const TemporaryDirectory folder;
  for (const Mode mode : {Mode::kReadWrite, Mode::kReadOnly}) {
    CHECK_THROWS_SAYING(Memory::open(folder / "m.db", mode), InputError, "does not exist");
  }
  CHECK_FALSE(fs::exists(folder / "m.db"));
  CHECK_THROWS_SAYING(Memory::open(folder / "none" / "m.db", Mode::kCreate), InputError, "cannot be opened");
  write_file(folder / "empty.db", "");
  CHECK_THROWS_SAYING(Memory::open(folder / "empty.db", Mode::kReadWrite), InputError, "is an empty file");
  CHECK(Memory::open(folder / "empty.db", Mode::kCreate).samples().empty());
  make_memory(folder / "m.db");
  CHECK(Memory::open(folder / "m.db", Mode::kCreate).samples().size() == 3);  // and never made anew
}

TEST_CASE("Memory file: the name ':memory:' is a file like any other") {
  const TemporaryDirectory folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  make_memory(":memory:");
  fs::current_path(before);
  CHECK(Memory::open(folder / ":memory:", Mode::kReadOnly).samples().size() == 3);
}

TEST_CASE("Memory file: one of a newer schema is refused") {
  const TemporaryDirectory folder;
  make_memory(folder / "m.db");
  run_sql(folder / "m.db", "PRAGMA user_version = 2");
  refuse_all(folder / "m.db",
             "was written by a newer preshape (schema 2, this one knows up to 1); use that version");
}

TEST_CASE("Memory file: a cut one is refused") {
  const TemporaryDirectory folder;
  make_memory(folder / "m.db", 200);
  const std::string whole = read_file(folder / "m.db");
  for (const std::size_t size :
       {std::size_t{100}, std::size_t{4096}, std::size_t{5000}, whole.size() - 4096}) {
    write_file(folder / "cut.db", whole.substr(0, size));
    refuse_all(folder / "cut.db", "is damaged");
  }
}

TEST_CASE("Memory file: damaged bytes are told or harmless, and never crash") {
  const TemporaryDirectory folder;
  make_memory(folder / "m.db", 40);
  const std::string whole = read_file(folder / "m.db");
  Random random(5);
  int told = 0;
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    for (int k = 0; k < 40; ++k)
      damaged[100 + random.below(damaged.size() - 100)] = static_cast<char>(random.below(256));
    write_file(folder / "bad.db", damaged);
    try {
      const Memory memory = Memory::open(folder / "bad.db", Mode::kReadOnly);
      for (const auto& fault : memory.integrity_faults()) told += !fault.empty();
      memory.samples(), memory.objects();
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).find("bad.db") != std::string::npos);
      ++told;
    }
  }
  CHECK(told > 0);
}

TEST_CASE("Memory file: a missing table is told as damage") {
  const TemporaryDirectory folder;
  make_memory(folder / "m.db");
  run_sql(folder / "m.db", "DROP TABLE sample");
  const Memory memory = Memory::open(folder / "m.db", Mode::kReadOnly);
  CHECK_THROWS_SAYING(memory.samples(), InputError, "does not work as a memory (no such table: sample)");
}

TEST_CASE("Memory file: read-only reads but does not learn") {
  const TemporaryDirectory folder;
  make_memory(folder / "m.db");
  Memory memory = Memory::open(folder / "m.db", Mode::kReadOnly);
  CHECK(memory.samples().size() == 3);
  CHECK_THROWS_SAYING(memory.begin_learning(), InputError, "cannot be written");
  CHECK(memory.samples().size() == 3);
}

TEST_CASE("Memory file: permissions decide what can be done, and each refusal names the mend") {
  const TemporaryDirectory folder;
  const fs::path room = folder / "room", file = room / "m.db";
  fs::create_directory(room);
  make_memory(file);
  const auto allow = [&](int file_mode, int room_mode) {
    REQUIRE(chmod(folder.path().c_str(), 0755) == 0);
    REQUIRE(chmod(file.c_str(), static_cast<mode_t>(file_mode)) == 0);
    REQUIRE(chmod(room.c_str(), static_cast<mode_t>(room_mode)) == 0);
    const bool root = geteuid() == 0;
    if (root) REQUIRE(chown(file.c_str(), 65534, 65534) == 0);
    if (root) REQUIRE(chown(room.c_str(), 65534, 65534) == 0);
  };
  const auto count = [&](Mode mode) { return std::to_string(Memory::open(file, mode).samples().size()); };
  const auto contains = [](const std::string& text, const std::string& part) {
    INFO("text: ", text);
    CHECK(text.find(part) != std::string::npos);
  };
  allow(0644, 0755);
  if (as_nobody([&] { return std::to_string(access(folder.path().c_str(), X_OK)); }) != "0") {
    MESSAGE("skipped: another user cannot reach the temporary folder of this machine at all");
    return;
  }
  allow(0444, 0755);
  contains(as_nobody([&] { return count(Mode::kReadWrite); }), "cannot be written; change its permissions");
  CHECK(as_nobody([&] { return count(Mode::kReadOnly); }) == "3");
  allow(0444, 0555);  // as on a read-only medium
  CHECK(as_nobody([&] { return count(Mode::kReadOnly); }) == "3");
  fs::remove(file.string() + "-wal"), fs::remove(file.string() + "-shm");  // a reader leaves them
  allow(0644, 0555);
  contains(as_nobody([&] { return count(Mode::kReadWrite); }), "permission on the file and its folder");
  CHECK(as_nobody([&] { return count(Mode::kReadOnly); }) == "3");
  allow(0000, 0755);
  contains(as_nobody([&] { return count(Mode::kReadOnly); }), "cannot be read (Permission denied)");
  allow(0644, 0000);
  contains(as_nobody([&] { return count(Mode::kReadOnly); }), "cannot be reached (Permission denied)");
  allow(0644, 0755);
  CHECK(as_nobody([&] { return count(Mode::kReadWrite); }) == "3");
}

TEST_SUITE_END();
