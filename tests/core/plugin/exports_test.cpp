#include "fixtures.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/plugin");

TEST_CASE("Exports: every shipped plugin exports one symbol, and none that would pin it in memory") {
  int plugins = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PRESHAPE_BINARY_DIR "/lib/preshape/plugins")) {
    if (entry.path().extension() != ".so") continue;
    ++plugins;
    INFO("plugin ", entry.path().string());
    const auto symbols = exported_symbols(entry.path());
    REQUIRE(symbols.size() == 1);
    CHECK(symbols[0].name == "preshape_entry");
    CHECK(symbols[0].binding != STB_GNU_UNIQUE);
  }
  CHECK(plugins >= 4);
}

TEST_CASE("Exports: the reader of symbols sees what a library without a version script shows") {
  // The core exports its public functions; were the reader blind, the case above would prove nothing.
  const auto symbols = exported_symbols(std::filesystem::canonical(PRESHAPE_BINARY_DIR "/lib/libpreshape_core.so"));
  CHECK(symbols.size() > 50);
}

TEST_SUITE_END();
