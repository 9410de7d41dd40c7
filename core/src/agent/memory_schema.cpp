#include "agent/memory_schema.h"

#include <fmt/format.h>

namespace preshape {

namespace {

// Ids are never used again after a forget (AUTOINCREMENT), since a classifier state names the last id that it
// has learned, and the last session is the memory's generation.
constexpr const char* kVersion1 = R"(
CREATE TABLE session (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  utc    TEXT NOT NULL
) STRICT;
CREATE TABLE note (
  key   TEXT PRIMARY KEY NOT NULL,
  value TEXT NOT NULL
) STRICT;
CREATE TABLE object (
  first_seen INTEGER PRIMARY KEY AUTOINCREMENT,
  hash       TEXT NOT NULL UNIQUE CHECK (length(hash) = 64),
  name       TEXT NOT NULL,
  file       TEXT NOT NULL,
  width_m    REAL NOT NULL,
  height_m   REAL NOT NULL,
  depth_m    REAL NOT NULL,
  width      REAL NOT NULL,
  height     REAL NOT NULL,
  depth      REAL NOT NULL,
  vertices_per_triangle REAL NOT NULL,
  normals_per_triangle  REAL NOT NULL,
  faces_per_triangle    REAL NOT NULL,
  kilotriangles         REAL NOT NULL,
  first_seen_utc TEXT NOT NULL
) STRICT;
CREATE TABLE sample (
  id         INTEGER PRIMARY KEY AUTOINCREMENT,
  object     TEXT NOT NULL REFERENCES object (hash),
  provenance TEXT NOT NULL CHECK (provenance IN ('pretrain', 'wrench', 'task')),
  tx REAL NOT NULL, ty REAL NOT NULL, tz REAL NOT NULL,
  rx REAL NOT NULL, ry REAL NOT NULL, rz REAL NOT NULL,
  stability      REAL NOT NULL,
  manipulability REAL NOT NULL,
  width          REAL NOT NULL,
  height         REAL NOT NULL,
  depth          REAL NOT NULL,
  vertices_per_triangle REAL NOT NULL,
  normals_per_triangle  REAL NOT NULL,
  faces_per_triangle    REAL NOT NULL,
  kilotriangles         REAL NOT NULL,
  plane           INTEGER NOT NULL CHECK (plane >= 1),
  symbol          INTEGER NOT NULL CHECK (symbol >= 1),
  virtual_fingers INTEGER NOT NULL CHECK (virtual_fingers >= 1),
  approach_m      REAL NOT NULL,
  approach_ratio  REAL NOT NULL,
  fx REAL, fy REAL, fz REAL, mx REAL, my REAL, mz REAL,
  score   REAL,
  task    TEXT NOT NULL,
  session INTEGER NOT NULL REFERENCES session (number)
) STRICT;
CREATE INDEX sample_object ON sample (object);
CREATE TABLE classifier_state (
  id          INTEGER PRIMARY KEY AUTOINCREMENT,
  component   TEXT NOT NULL,
  parameters  TEXT NOT NULL,
  state       BLOB NOT NULL,
  last_sample INTEGER NOT NULL,
  arrived     INTEGER NOT NULL CHECK (arrived IN (0, 1)),
  epochs      INTEGER NOT NULL,
  restarts    INTEGER NOT NULL,
  mean_squared_error REAL,
  wrong_rows  INTEGER NOT NULL,
  seed        INTEGER NOT NULL,
  session     INTEGER NOT NULL REFERENCES session (number)
) STRICT;
CREATE INDEX classifier_state_component ON classifier_state (component, id);
)";

/// Entry k leads from version k to k + 1.
constexpr const char* kUpgrades[] = {kVersion1};
static_assert(std::size(kUpgrades) == kMemorySchemaVersion);

}  // namespace

void upgrade_memory_schema(sqlite::Connection& connection) {
  connection.execute("BEGIN IMMEDIATE");
  try {
    for (std::int64_t version = connection.integer("PRAGMA user_version"); version < kMemorySchemaVersion;
         ++version) {
      connection.execute(kUpgrades[version]);
    }
    connection.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                                   kMemoryApplicationId, kMemorySchemaVersion)
                           .c_str());
    connection.execute("COMMIT");
  } catch (...) {
    connection.roll_back();
    throw;
  }
}

}  // namespace preshape
