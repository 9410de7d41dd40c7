// The installation in the hands of an author: every kind's template, pkg-config, CMake.
#include "installation.h"
#include "preshape/plugin/kind.h"
#include "preshape/version.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("sdk");

namespace {

/// A project of every template, named my_KIND, in one build: one run of cmake finds the compiler once.
const fs::path& every_kind() {
  static const fs::path folder = [] {
    const fs::path project = installation().parent_path() / "every_kind";
    fs::create_directories(project);
    std::string cmake = "cmake_minimum_required(VERSION 3.25)\nproject(every_kind LANGUAGES CXX)\nenable_testing()\n";
    std::string commands;
    for (const auto kind : kKinds) {
      commands += fmt::format("preshape new-plugin {0} my_{0}\n", kind);
      cmake += fmt::format("add_subdirectory(my_{})\n", kind);
    }
    std::ofstream(project / "CMakeLists.txt") << cmake;
    const auto built = shell(project, commands + "cmake -B build -G Ninja -DCMAKE_CXX_FLAGS='-O0 -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-psabi'\n"
                                                 "cmake --build build");
    if (built.exit_code != 0) throw std::runtime_error(built.output);
    return project;
  }();
  return folder;
}

}  // namespace

TEST_CASE("Templates: every kind's builds without a warning against the installation alone, and its own test passes") {
  const auto result = shell(every_kind(), SDK_CTEST " --test-dir build --output-on-failure --exclude-regex conformance");
  INFO(result.output);
  CHECK(result.exit_code == 0);
  CHECK(result.output.find("100% tests passed, 0 tests failed out of 8") != std::string::npos);
}

TEST_CASE("Templates: every kind's conforms") {
  const auto result = shell(every_kind(), SDK_CTEST " --test-dir build --output-on-failure --tests-regex conformance");
  INFO(result.output);
  CHECK(result.exit_code == 0);
}

TEST_CASE("Templates: every kind's example runs as it comes") {
  for (const auto kind : kKinds) {
    const auto result = shell(every_kind(), fmt::format("preshape --plugin-path build/lib/preshape/plugins run -q my_{0}/my_{0}.lua", kind));
    INFO(kind, ": ", result.output);
    CHECK(result.exit_code == 0);
  }
}

TEST_CASE("Templates: a hand's parameters stand beside its model, and a misspelt one is told with the right one") {
  const auto result = shell(every_kind(), "preshape --plugin-path build/lib/preshape/plugins check my_hand/my_hand.lua --set hand.distall=0.04");
  INFO(result.output);
  CHECK(result.exit_code == 5);
  CHECK(result.output.find("hand 'my_hand': unknown key 'distall'; did you mean 'distal'?") != std::string::npos);
}

TEST_CASE("Templates: every kind's README has the table of parameters that its component declares") {
  for (const auto kind : kKinds) {
    const auto told = shell(every_kind(), fmt::format("preshape --plugin-path build/lib/preshape/plugins plugins {0}/my_{0} --markdown", kind));
    INFO(kind, ": ", told.output);
    REQUIRE(told.exit_code == 0);
    const std::string readme = read_file(every_kind() / fmt::format("my_{}", kind) / "README.md");
    const auto table = told.output.find("| name | unit |");
    if (table == std::string::npos) {
      CHECK(readme.find("It has none.") != std::string::npos);
    } else {
      const std::string rows = told.output.substr(table, told.output.find("\n\n", table) - table);
      CHECK(readme.find(rows) != std::string::npos);
    }
  }
}

TEST_CASE("Templates: the commands of a README do what it says, in order") {
  const fs::path folder = installation().parent_path() / "readme";
  fs::create_directories(folder);
  const auto made = shell(folder, "preshape new-plugin contact rubber_pad");
  INFO(made.output);
  REQUIRE(made.exit_code == 0);
  const auto blocks = fenced_blocks(read_file(folder / "rubber_pad/README.md"), "sh");
  REQUIRE(blocks.size() == 1);
  const auto result = shell(folder / "rubber_pad", blocks[0]);
  INFO(result.output);
  CHECK(result.exit_code == 0);
  CHECK(result.output.find("contact 'rubber_pad': Hard finger") != std::string::npos);
  CHECK(result.output.find("served") != std::string::npos);
}

TEST_CASE("pkg-config: a compiler and what it says are enough to build a plugin that loads") {
  const fs::path folder = installation().parent_path() / "pkgconfig";
  fs::create_directories(folder);
  const auto result = shell(folder,
                            "preshape new-plugin similarity near\n"
                            SDK_COMPILER " -std=c++20 -O0 -fPIC -shared -fvisibility=hidden near/near.cpp -o near.so "
                            "$(pkg-config --cflags --libs preshape) "
                            "-Wl,--version-script=$(pkg-config --variable=plugin_map preshape) -Wl,-z,defs,-z,now\n"
                            "preshape --plugin-path . plugins similarity/near\n"
                            "pkg-config --modversion preshape");
  INFO(result.output);
  CHECK(result.exit_code == 0);
  CHECK(result.output.find("similarity 'near': Weighted sum") != std::string::npos);
  CHECK(result.output.find("\n" PRESHAPE_VERSION_STRING "\n") != std::string::npos);
}

TEST_CASE("CMake: a version that this SDK does not serve is refused, one that it does is found") {
  const fs::path folder = installation().parent_path() / "versions";
  fs::create_directories(folder);
  const auto find = [&](const std::string& version) {
    std::ofstream(folder / "CMakeLists.txt") << "cmake_minimum_required(VERSION 3.25)\nproject(versions LANGUAGES NONE)\n"
                                                "find_package(preshape " + version + " REQUIRED)\n";
    return shell(folder, "rm -rf build; cmake -B build");
  };
  const auto found = find("0.1");
  INFO(found.output);
  CHECK(found.exit_code == 0);
  CHECK(find("99.0").exit_code != 0);
}

TEST_CASE("Versions: the macros compare as the numbers do") {
  CHECK(PRESHAPE_VERSION_NUMBER == PRESHAPE_VERSION_MAJOR * 10000 + PRESHAPE_VERSION_MINOR * 100 + PRESHAPE_VERSION_PATCH);
  CHECK(PRESHAPE_VERSION_AT_LEAST(PRESHAPE_VERSION_MAJOR, PRESHAPE_VERSION_MINOR, PRESHAPE_VERSION_PATCH));
  CHECK_FALSE(PRESHAPE_VERSION_AT_LEAST(PRESHAPE_VERSION_MAJOR, PRESHAPE_VERSION_MINOR, PRESHAPE_VERSION_PATCH + 1));
  CHECK_FALSE(PRESHAPE_VERSION_AT_LEAST(PRESHAPE_VERSION_MAJOR + 1, 0, 0));
}

TEST_SUITE_END();
