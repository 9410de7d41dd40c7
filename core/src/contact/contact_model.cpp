#include "preshape/contact/contact_model.h"

#include "preshape/contact/contact_limits.h"

namespace preshape {

ContactModel::~ContactModel() = default;
const void* ContactModel::extension(const char*) const noexcept { return nullptr; }

ContactLimits::~ContactLimits() = default;

}  // namespace preshape
