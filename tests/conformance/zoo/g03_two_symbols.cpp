#include "measure.h"
extern "C" [[gnu::visibility("default")]] int preshape_entry_too() { return 1; }
PRESHAPE_PLUGIN(({"zoo.g03", "1.0.0", "BSD-3-Clause", "the preshape developers", "A library that exports two symbols"}),
                ({"similarity/g03_two_symbols"}), preshape::component<zoo::Measure>("g03_two_symbols", "exports too much"))
