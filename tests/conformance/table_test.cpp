// The page with the checks of every shipped component is what the command writes.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/data.h"

using namespace preshape::test;

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("Shipped components: all conform, and docs/conformance-table.md says so check by check") {
  const std::filesystem::path binary = PRESHAPE_BINARY_DIR, table = binary / "conformance-table.md";
  const std::string command = fmt::format("env -u PRESHAPE_PLUGIN_PATH XDG_DATA_HOME=/nowhere {} conform --all -q --markdown {} > {}",
                                          (binary / "bin/preshape").string(), table.string(), (binary / "conformance.txt").string());
  const int status = std::system(command.c_str());
  INFO(read(binary / "conformance.txt"));
  CHECK(status == 0);
  const std::string page = read(source_file("docs/conformance-table.md")), written = read(table);
  const auto body = page.find("\n## contact");
  REQUIRE(body != std::string::npos);
  CHECK_MESSAGE(page.substr(body) == written, "write it anew: preshape conform --all --markdown FILE, below the page's head");
}
