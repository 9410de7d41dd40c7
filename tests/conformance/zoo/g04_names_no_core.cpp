// Linked without the core, whose functions it uses: it lives on what its host happens to have loaded.
#include "measure.h"
PRESHAPE_PLUGIN(({"zoo.g04", "1.0.0", "BSD-3-Clause", "the preshape developers", "A library that does not name the core"}),
                ({"similarity/g04_names_no_core"}), preshape::component<zoo::Measure>("g04_names_no_core", "links too little"))
