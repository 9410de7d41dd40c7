#include "preshape/hand/hand_model.h"

namespace preshape {

HandModel::~HandModel() = default;
const void* HandModel::extension(const char*) const noexcept { return nullptr; }

}  // namespace preshape
