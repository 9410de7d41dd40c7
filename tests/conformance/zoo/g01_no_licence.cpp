#include "measure.h"
PRESHAPE_PLUGIN(({"zoo.g01", "1.0.0", "", "the preshape developers", "A library without a licence"}),
                ({"similarity/g01_no_licence"}), preshape::component<zoo::Measure>("g01_no_licence", "says no licence"))
