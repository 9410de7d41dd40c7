#pragma once

#include <string>
#include <string_view>

#include "lesson.h"

namespace preshape::nadaraya_watson {

/// Little-endian bytes: a head with the version, the SHA-256 of what follows, three sizes, inputs and
/// targets.
std::string state_bytes(const Lesson& lesson);
/// @throws InputError when the bytes are not what state_bytes gave; no more is allocated than the bytes hold
Lesson lesson_from(std::string_view bytes);

}  // namespace preshape::nadaraya_watson
