#include "preshape/plugin/loader.h"

namespace preshape {

ComponentLibrary::~ComponentLibrary() = default;
ComponentLoader::~ComponentLoader() = default;

}  // namespace preshape
