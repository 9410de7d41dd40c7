#pragma once

#include <cstdint>

#include "agent/sqlite.h"

namespace preshape {

/// "prsh": marks an SQLite file as ours (PRAGMA application_id).
inline constexpr std::int64_t kMemoryApplicationId = 0x70727368;
/// PRAGMA user_version of the newest schema.
inline constexpr std::int64_t kMemorySchemaVersion = 1;

/// Brings an empty database (version 0) or an older schema up to kMemorySchemaVersion, in one transaction.
/// Several processes may do so at once: the first does it, the others find it done.
void upgrade_memory_schema(sqlite::Connection& connection);

}  // namespace preshape
