#include "preshape/contact/contact_model.h"

namespace preshape {

ContactModel::~ContactModel() = default;
const void* ContactModel::extension(const char*) const noexcept { return nullptr; }

}  // namespace preshape
