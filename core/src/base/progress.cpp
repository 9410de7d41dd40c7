#include "preshape/base/progress.h"

namespace preshape {

Progress::~Progress() = default;

}  // namespace preshape
