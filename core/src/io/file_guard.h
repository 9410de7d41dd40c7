#pragma once

#include <string>
#include <string_view>

namespace preshape {

/// Looks a mesh file over for what the reading library does not survive: it trusts counts, follows placements
/// without limit and waits for ends that never come (each found by feeding it damaged files). Says nothing
/// about the rest of the file, which is left to the library.
/// @param ending  lower case, one of object_file_endings
/// @param content the whole file
/// @throws InputError in a sentence that begins in lower case, for the caller to say of which file
void guard_file(const std::string& ending, std::string_view content);

}  // namespace preshape
