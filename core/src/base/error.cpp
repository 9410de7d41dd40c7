#include "preshape/base/error.h"

namespace preshape {

// Out of line: one type information for every library, so that a plugin's exception is caught by its type.
Error::~Error() = default;
InputError::~InputError() = default;
PluginError::~PluginError() = default;
ScriptError::~ScriptError() = default;

}  // namespace preshape
