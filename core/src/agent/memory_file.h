#pragma once

#include <filesystem>
#include <memory>

#include "agent/sqlite.h"
#include "preshape/agent/memory.h"

namespace preshape {

/// Opens, and where asked makes, a memory's file; see Memory::open.
std::unique_ptr<sqlite::Connection> open_memory_file(const std::filesystem::path& path, Memory::Mode mode,
                                                     double busy_timeout_s);
std::unique_ptr<sqlite::Connection> open_memory_in_memory();

}  // namespace preshape
