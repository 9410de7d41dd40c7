// Plugins built as they must not be, and refused by what their files say; and others with odd flags that work.
#include <cstdlib>

#include "fixtures.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/plugin");

namespace {

constexpr const char* kMark = "PRESHAPE_FIXTURE_RAN";

/// Every reason for which a build of `marks` is refused, when none of its code has run.
std::string refusal_of(const std::string& fixture) {
  unsetenv(kMark);
  const Registry registry = registry_of_fixture(fixture);
  REQUIRE(registry.libraries().size() == 1);
  const LibraryRecord& library = registry.libraries()[0];
  CHECK(library.status == LibraryRecord::Status::kRefused);
  CHECK(registry.components().empty());
  CHECK_THROWS_SAYING(registry.create<Similarity>("marks"), PluginError, "is refused: ");
  CHECK_FALSE(mapped(fixture_file(fixture)));
  CHECK(std::getenv(kMark) == nullptr);
  std::string text;
  for (const auto& reason : library.reasons) text += reason + "\n";
  return text;
}

struct Offence {
  std::string fixture, sentence;
};

}  // namespace

TEST_CASE("Offenders: a plugin built with flags that break the boundary is refused by name and mend before any of it runs") {
  const std::vector<Offence> offences = {
      {"old_string_abi", "C++ string ABI (_GLIBCXX_USE_CXX11_ABI): plugin 0, host 1; build with -D_GLIBCXX_USE_CXX11_ABI=1"},
      {"old_string_abi", "size of the boundary types: plugin "},
      {"debug_library", "libstdc++ debug mode (_GLIBCXX_DEBUG): plugin 1, host 0; build without -D_GLIBCXX_DEBUG"},
      {"no_rtti", "run-time type information: plugin 0, host 1; build without -fno-rtti"},
      {"fast_math_compiled", "fast math: plugin 1, host 0; build without -ffast-math"},
      {"other_sdk", "SDK major version: plugin 7, host 0; rebuild the plugin with this installation's SDK"},
#if defined(PRESHAPE_AVX2_FIXTURES)
      {"unpinned_avx", "EIGEN_MAX_ALIGN_BYTES: plugin 32, host 16; let preshape_add_plugin set the compile flags"},
      {"unpinned_avx", "EIGEN_MALLOC_ALREADY_ALIGNED: plugin 0, host 1; let preshape_add_plugin set the compile flags"},
#endif
  };
  for (const auto& offence : offences) {
    const std::string said = refusal_of(offence.fixture);
    INFO(offence.fixture, " said: ", said);
    CHECK(said.find(offence.sentence) != std::string::npos);
  }
}

TEST_CASE("Offenders: a plugin with the address sanitizer beside a host without it is refused") {
#if defined(PRESHAPE_ADDRESS_FIXTURE) && !defined(__SANITIZE_ADDRESS__)
  const std::string said = refusal_of("address_sanitizer");
  INFO(said);
  CHECK(said.find("sanitizers: plugin address, host none; build plugin and host with the same -fsanitize") != std::string::npos);
#else
  MESSAGE("skipped: this tool chain has no address sanitizer to link, or the host is built with it");
#endif
}

TEST_CASE("Offenders: a library of another machine or of 32 bits is refused, and none of it runs") {
  unsetenv(kMark);
  const auto patched = [](std::size_t at, char value) {
    const TemporaryDirectory folder;
    std::string bytes = read_bytes(fixture_file("marks"));
    bytes[at] = value;
    write_bytes(folder / "marks.so", bytes);
    const Registry registry = registry_of(folder.path());
    CHECK_FALSE(registry.has("similarity", "marks"));
    REQUIRE(registry.libraries().size() == 1);
    CHECK(registry.libraries()[0].status == LibraryRecord::Status::kRefused);
    return registry.libraries()[0].reasons.at(0);
  };
  const char* sentence = "it was built for another machine; build it on this one";
  CHECK(patched(offsetof(Elf64_Ehdr, e_machine), EM_SPARC) == sentence);
  CHECK(patched(EI_CLASS, ELFCLASS32) == sentence);
  CHECK(patched(EI_DATA, ELFDATA2MSB) == sentence);
  CHECK(std::getenv(kMark) == nullptr);
}

#if defined(PRESHAPE_AVX2_FIXTURES)
TEST_CASE("Offenders: a plugin for this very processor, built as the SDK has it, is none") {
  const Registry registry = registry_of_fixture("native");
  REQUIRE(registry.libraries().size() == 1);
  const auto& library = registry.libraries()[0];
  for (const auto& reason : library.reasons) MESSAGE(reason);
  CHECK(library.status == LibraryRecord::Status::kUsable);
  CHECK(registry.create<Similarity>("plain")->scale(7).nearest == 1.0);
}
#endif

TEST_CASE("State: two plugins that include one header with static state have each their own") {
  const Registry first = registry_of_fixture("counts_one"), second = registry_of_fixture("counts_two");
  const auto one = first.create<Similarity>("one");
  CHECK(one->scale(7).farthest == 0.0);
  CHECK(one->scale(7).nearest == 1.0);
  const auto two = second.create<Similarity>("two");
  CHECK(two->scale(7).farthest == 0.0);  // not 2
  CHECK(two->scale(7).nearest == 1.0);
}

TEST_CASE("State: a library that was let go of and loaded again begins anew") {
  const TemporaryDirectory folder;
  const auto file = folder / "counts.so";
  std::filesystem::copy_file(fixture_file("counts_one"), file);
  for (int i = 0; i < 3; ++i) {
    CHECK(registry_of(folder.path()).create<Similarity>("one")->scale(7).farthest == 0.0);
    CHECK_FALSE(mapped(file));
  }
}

TEST_SUITE_END();
