#include "preshape/fuzzy/similarity.h"

namespace preshape {

Similarity::~Similarity() = default;
const void* Similarity::extension(const char*) const noexcept { return nullptr; }

}  // namespace preshape
