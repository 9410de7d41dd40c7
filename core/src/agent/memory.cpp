#include "preshape/agent/memory.h"

#include <fmt/format.h>

#include "agent/memory_file.h"
#include "agent/memory_rows.h"
#include "preshape/base/assert.h"
#include "preshape/base/error.h"

namespace preshape {

using sqlite::Statement;

Memory::Memory(std::unique_ptr<MemoryParts> parts) : parts_(std::move(parts)) {}
Memory::Memory(Memory&&) noexcept = default;
Memory& Memory::operator=(Memory&&) noexcept = default;
Memory::~Memory() = default;

Memory Memory::open(const std::filesystem::path& path, Mode mode, double busy_timeout_s) {
  return Memory(std::make_unique<MemoryParts>(open_memory_file(path, mode, busy_timeout_s)));
}

Memory Memory::in_memory() {
  return Memory(std::make_unique<MemoryParts>(open_memory_in_memory()));
}

Memory Memory::copy_of(const std::filesystem::path& path) {
  auto copy = open_memory_in_memory();
  open_memory_file(path, Mode::kReadOnly, 30.0)->copy_to(*copy);
  return Memory(std::make_unique<MemoryParts>(std::move(copy)));
}

const std::string& Memory::name() const {
  return parts_->connection->name();
}

std::vector<MemoryObject> Memory::objects() const {
  Statement query(*parts_->connection, "SELECT " + object_columns() + " FROM object ORDER BY first_seen");
  std::vector<MemoryObject> objects;
  while (query.step()) objects.push_back(read_object(query));
  return objects;
}

std::optional<MemoryObject> Memory::object(std::string_view hash) const {
  Statement query(*parts_->connection, "SELECT " + object_columns() + " FROM object WHERE hash = ?");
  if (!query.bind(hash).step()) return std::nullopt;
  return read_object(query);
}

namespace {

std::vector<Sample> read_samples(Statement& query) {
  std::vector<Sample> samples;
  while (query.step()) samples.push_back(read_sample(query));
  return samples;
}

}  // namespace

std::vector<Sample> Memory::samples(std::int64_t after) const {
  Statement query(*parts_->connection,
                  "SELECT " + sample_columns() + " FROM sample WHERE id > ? ORDER BY id");
  return read_samples(query.bind(after));
}

std::vector<Sample> Memory::samples_of(std::string_view object_hash) const {
  Statement query(*parts_->connection,
                  "SELECT " + sample_columns() + " FROM sample WHERE object = ? ORDER BY id");
  return read_samples(query.bind(object_hash));
}

std::optional<ClassifierState> Memory::latest_state(std::string_view component) const {
  Statement query(
      *parts_->connection,
      "SELECT " + state_columns() + " FROM classifier_state WHERE component = ? ORDER BY id DESC LIMIT 1");
  if (!query.bind(component).step()) return std::nullopt;
  return read_state(query);
}

std::optional<std::string> Memory::note(std::string_view key) const {
  Statement query(*parts_->connection, "SELECT value FROM note WHERE key = ?");
  if (!query.bind(key).step()) return std::nullopt;
  return query.text();
}

std::int64_t Memory::generation() const {
  return parts_->connection->integer("SELECT max(number) FROM session");
}

MemoryStatistics Memory::statistics() const {
  Statement query(*parts_->connection, R"(SELECT
      (SELECT count(*) FROM object),
      (SELECT count(*) FROM sample WHERE provenance = 'pretrain'),
      (SELECT count(*) FROM sample WHERE provenance = 'wrench'),
      (SELECT count(*) FROM sample WHERE provenance = 'task'),
      (SELECT count(*) FROM classifier_state),
      (SELECT count(*) FROM session))");
  query.step();
  MemoryStatistics statistics;
  for (auto* number : {&statistics.objects, &statistics.pretrain_samples, &statistics.wrench_samples,
                       &statistics.task_samples, &statistics.states, &statistics.sessions}) {
    *number = query.integer();
  }
  statistics.schema_version = parts_->connection->integer("PRAGMA user_version");
  statistics.bytes =
      parts_->connection->integer("PRAGMA page_count") * parts_->connection->integer("PRAGMA page_size");
  return statistics;
}

std::vector<std::string> Memory::integrity_faults() const {
  std::vector<std::string> faults;
  Statement check(*parts_->connection, "PRAGMA integrity_check");
  while (check.step()) faults.push_back(check.text());
  if (faults == std::vector<std::string>{"ok"}) faults.clear();
  Statement orphans(*parts_->connection, "PRAGMA foreign_key_check");
  while (orphans.step()) {
    const std::string table = orphans.text();
    const std::int64_t row = orphans.integer();
    faults.push_back(
        fmt::format("row {} of '{}' names something that is not in '{}'", row, table, orphans.text()));
  }
  return faults;
}

Memory::Snapshot Memory::snapshot() const {
  return Snapshot(*parts_);
}

Memory::Snapshot::Snapshot(MemoryParts& parts) : parts_(parts) {
  PRESHAPE_DEMAND(!parts.connection->in_transaction());
  parts.connection->execute("BEGIN");
  try {
    parts.connection->integer("SELECT max(number) FROM session");  // the moment is that of the first read
  } catch (...) {
    parts.connection->roll_back();
    throw;
  }
}

Memory::Snapshot::~Snapshot() {
  parts_.connection->roll_back();
}

Learning Memory::begin_learning(std::string_view utc) {
  return Learning(*parts_, utc);
}

}  // namespace preshape
