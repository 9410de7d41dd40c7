#include "../probe.h"

#include "preshape/base/assert.h"

namespace preshape::conformance {

const Probe& explorer_probe() {
  PRESHAPE_DEMAND(!"written");
  return similarity_probe();
}

}  // namespace preshape::conformance
