#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <string_view>

#include "preshape/agent/memory.h"

namespace preshape {

/// Every sample as one line of comma-separated values, with its object, under a line of column names; in the
/// order of learning. Numbers are the shortest text that reads back the same, an unknown one is an empty
/// field; fields are quoted as in RFC 4180, lines end with a line feed. Ids and sessions are the memory's own
/// and stay out, so that export, import into an empty memory and export again give the same bytes.
PRESHAPE_API void export_samples(const Memory& memory, std::ostream& out);

/// Adds every row as one learning, or none. Columns may stand in any order; lines may end with CR LF; a byte
/// order mark is passed over. An object that the memory does not know is added with the attributes of its
/// first row.
/// @param source the file's name, for messages
/// @returns number of samples added
/// @throws InputError naming source, line, column, the given text and what is allowed
PRESHAPE_API std::int64_t import_samples(Memory& memory, std::istream& in, std::string_view source);

}  // namespace preshape
