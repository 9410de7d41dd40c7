#pragma once

#include "agent/sqlite.h"
#include "preshape/agent/memory.h"

namespace preshape {

/// What Memory, Snapshot and Learning share.
struct MemoryParts {
  explicit MemoryParts(std::unique_ptr<sqlite::Connection> opened) : connection(std::move(opened)) {}
  std::unique_ptr<sqlite::Connection> connection;
};

/// The columns of each table in the order in which bind writes and read reads them, separated by commas.
/// The memory's own ones (first_seen; id, session) come first, and bind leaves them out.
const std::string& object_columns();
const std::string& sample_columns();
const std::string& state_columns();

/// "INSERT INTO table (all but the memory's own columns, then `extra`) VALUES (?, ?, ..)".
const std::string& insert_object_sql();
const std::string& insert_sample_sql();
const std::string& insert_state_sql();

/// @throws InputError when a value does not belong into a memory
void check_object(const MemoryObject& object);
void check_sample(const Sample& sample);
void check_state(const ClassifierState& state);

void bind_object(sqlite::Statement& statement, const MemoryObject& object);
void bind_sample(sqlite::Statement& statement, const Sample& sample, std::int64_t session);
void bind_state(sqlite::Statement& statement, const ClassifierState& state, std::int64_t session);

MemoryObject read_object(sqlite::Statement& statement);
Sample read_sample(sqlite::Statement& statement);
ClassifierState read_state(sqlite::Statement& statement);

/// By its name. @throws InputError naming the known ones
Provenance provenance_of(std::string_view name);

}  // namespace preshape
