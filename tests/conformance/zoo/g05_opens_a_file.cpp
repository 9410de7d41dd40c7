#include <fcntl.h>

#include "measure.h"

namespace {
[[maybe_unused]] const int kFile = open("/dev/null", O_RDONLY);
}

PRESHAPE_PLUGIN(({"zoo.g05", "1.0.0", "BSD-3-Clause", "the preshape developers", "A library that opens a file when it is loaded"}),
                ({"similarity/g05_opens_a_file"}), preshape::component<zoo::Measure>("g05_opens_a_file", "opens too early"))
