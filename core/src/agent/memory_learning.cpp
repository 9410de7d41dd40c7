#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "agent/memory_rows.h"
#include "preshape/agent/memory.h"
#include "preshape/base/assert.h"
#include "preshape/base/error.h"

namespace preshape {

using sqlite::Statement;

Learning::Learning(MemoryParts& parts, std::string_view utc) : parts_(&parts) {
  PRESHAPE_DEMAND(!parts.connection->in_transaction());
  parts.connection->execute("BEGIN IMMEDIATE");
  try {
    Statement insert(*parts.connection, "INSERT INTO session (utc) VALUES (?)");
    insert.bind(utc).run();
    session_ = parts.connection->last_row();
  } catch (...) {
    parts.connection->roll_back();
    throw;
  }
}

Learning::Learning(Learning&& other) noexcept
    : parts_(std::exchange(other.parts_, nullptr)), session_(other.session_) {}

Learning::~Learning() {
  if (parts_) parts_->connection->roll_back();
}

MemoryParts& Learning::open() const {
  PRESHAPE_DEMAND(parts_ != nullptr);
  // After a full disk, say, SQLite has undone the transaction; what follows would be committed row by row.
  if (!parts_->connection->in_transaction()) {
    throw InputError(
        fmt::format("memory '{}': this learning was undone by an earlier failure; begin another one",
                    parts_->connection->name()));
  }
  return *parts_;
}

bool Learning::add_object(const MemoryObject& object) {
  check_object(object);
  Statement known(*open().connection, "SELECT 1 FROM object WHERE hash = ?");
  if (known.bind(object.hash).step()) return false;
  Statement insert(*parts_->connection, insert_object_sql());
  bind_object(insert, object);
  insert.run();
  return true;
}

std::int64_t Learning::add_sample(const Sample& sample) {
  check_sample(sample);
  Statement known(*open().connection, "SELECT 1 FROM object WHERE hash = ?");
  if (!known.bind(sample.object).step()) {
    throw InputError(fmt::format("memory '{}' has no object '{}'; add the object before its samples",
                                 parts_->connection->name(), sample.object));
  }
  Statement insert(*parts_->connection, insert_sample_sql());
  bind_sample(insert, sample, session_);
  insert.run();
  return parts_->connection->last_row();
}

std::int64_t Learning::store_state(const ClassifierState& state) {
  check_state(state);
  const std::int64_t last = open().connection->integer("SELECT max(id) FROM sample");
  if (state.last_sample < 0 || state.last_sample > last) {
    throw InputError(
        fmt::format("memory '{}': a classifier state cannot have learned sample {}, the last one is {}",
                    parts_->connection->name(), state.last_sample, last));
  }
  Statement insert(*parts_->connection, insert_state_sql());
  bind_state(insert, state, session_);
  insert.run();
  const std::int64_t id = parts_->connection->last_row();
  Statement prune(
      *parts_->connection,
      "DELETE FROM classifier_state WHERE component = ? AND id NOT IN (SELECT id FROM classifier_state "
      "WHERE component = ? ORDER BY id DESC LIMIT ?)");
  prune.bind(state.component).bind(state.component).bind(kStatesKept).run();
  return id;
}

void Learning::set_note(std::string_view key, std::string_view value) {
  Statement remove(*open().connection, "DELETE FROM note WHERE key = ?");
  remove.bind(key).run();
  if (value.empty()) return;
  Statement insert(*parts_->connection, "INSERT INTO note (key, value) VALUES (?, ?)");
  insert.bind(key).bind(value).run();
}

Forgotten Learning::forget_object(std::string_view hash) {
  Statement known(*open().connection, "SELECT 1 FROM object WHERE hash = ?");
  if (!known.bind(hash).step()) {
    throw InputError(
        fmt::format("memory '{}' has no object '{}' to forget", parts_->connection->name(), hash));
  }
  std::vector<std::int64_t> ids;
  Statement query(*parts_->connection, "SELECT id FROM sample WHERE object = ? ORDER BY id");
  query.bind(hash);
  while (query.step()) ids.push_back(query.integer());
  const Forgotten forgotten = forget_samples(ids);
  Statement remove(*parts_->connection, "DELETE FROM object WHERE hash = ?");
  remove.bind(hash).run();
  return forgotten;
}

Forgotten Learning::forget_samples(std::span<const std::int64_t> ids) {
  sqlite::Connection& connection = *open().connection;
  for (const std::int64_t id : ids) {
    Statement known(connection, "SELECT 1 FROM sample WHERE id = ?");
    if (!known.bind(id).step()) {
      throw InputError(fmt::format("memory '{}' has no sample {} to forget", connection.name(), id));
    }
  }
  Forgotten forgotten;
  for (const std::int64_t id : ids) {
    Statement remove(connection, "DELETE FROM sample WHERE id = ?");
    remove.bind(id).run();
    forgotten.samples += connection.changes();
  }
  if (ids.empty()) return forgotten;
  Statement stale(connection, "DELETE FROM classifier_state WHERE last_sample >= ?");
  stale.bind(*std::min_element(ids.begin(), ids.end())).run();
  forgotten.states = connection.changes();
  return forgotten;
}

void Learning::commit() {
  open().connection->execute("COMMIT");
  parts_ = nullptr;
}

}  // namespace preshape
