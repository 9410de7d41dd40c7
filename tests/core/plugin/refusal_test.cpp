#include <sys/stat.h>

#include <clocale>
#include <cstdlib>
#include <functional>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "fixtures.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/plugin");

namespace {

constexpr const char* kMark = "PRESHAPE_FIXTURE_RAN";

struct Tampering {
  std::function<void(Fingerprint&)> change;
  std::string sentence;  ///< field, both sides and the mend
};

/// The reasons why a copy of `marks` with an altered fingerprint is refused.
std::vector<std::string> reasons_after(const std::function<void(Fingerprint&)>& change) {
  const TemporaryDirectory folder;
  write_tampered("marks", folder / "marks.so", [&](Manifest& m) { change(m.fingerprint); });
  const Registry registry = registry_of(folder.path());
  REQUIRE(registry.libraries().size() == 1);
  CHECK_FALSE(registry.has("similarity", "marks"));
  const LibraryRecord& library = registry.libraries()[0];
  CHECK(library.status == LibraryRecord::Status::kRefused);
  REQUIRE_FALSE(library.reasons.empty());
  CHECK_THROWS_SAYING(registry.create<Similarity>("marks"), PluginError, library.reasons[0]);
  CHECK_THROWS_SAYING(registry.describe("similarity", "marks"), PluginError, "marks.so' is refused: ");
  CHECK_FALSE(mapped(folder / "marks.so"));
  return library.reasons;
}

}  // namespace

TEST_CASE("Refusal: the fixture leaves its mark when it is loaded, and only then") {
  unsetenv(kMark);
  const Registry registry = registry_of_fixture("marks");
  CHECK(registry.has("similarity", "marks"));
  CHECK(std::getenv(kMark) == nullptr);
  registry.describe("similarity", "marks");
  CHECK(std::getenv(kMark) != nullptr);
}

TEST_CASE("Refusal: one other field of the fingerprint is enough; the sentence names it, both sides and the mend") {
  const std::vector<Tampering> tamperings = {
      {[](Fingerprint& f) { f.sdk_major = 7; }, "SDK major version: plugin 7, host 0; rebuild the plugin with this "
                                                "installation's SDK"},
      {[](Fingerprint& f) { f.sdk_minor = 99; }, "SDK minor version: plugin 0.99, host 0.1; install a newer preshape"},
      {[](Fingerprint& f) { f.interface_hash_low ^= 1u; }, "interface hash: plugin "},
      {[](Fingerprint& f) { f.interface_hash_high ^= 1u; }, "interface hash: plugin "},
      {[](Fingerprint& f) { f.probe_size = 8; }, "size of the boundary types: plugin 8, host "},
      {[](Fingerprint& f) { f.probe_alignment = 64; }, "alignment of the boundary types: plugin 64, host "},
      {[](Fingerprint& f) { f.cxx11_abi = 0; }, "C++ string ABI (_GLIBCXX_USE_CXX11_ABI): plugin 0, host 1; build with "
                                                "-D_GLIBCXX_USE_CXX11_ABI=1"},
      {[](Fingerprint& f) { f.glibcxx_debug = 1; }, "libstdc++ debug mode (_GLIBCXX_DEBUG): plugin 1, host 0; build "
                                                    "without -D_GLIBCXX_DEBUG"},
      {[](Fingerprint& f) { f.rtti = 0; }, "run-time type information: plugin 0, host 1; build without -fno-rtti"},
      {[](Fingerprint& f) { f.exceptions = 0; }, "exceptions: plugin 0, host 1; build without -fno-exceptions"},
      {[](Fingerprint& f) { f.eigen_version = 30309; }, "Eigen version: plugin 3.3.9, host 3.4.0; build with the same "
                                                        "Eigen"},
      {[](Fingerprint& f) { f.eigen_max_align = 32; }, "EIGEN_MAX_ALIGN_BYTES: plugin 32, host 16; let "
                                                       "preshape_add_plugin set the compile flags"},
      {[](Fingerprint& f) { f.eigen_static_align = 32; }, "EIGEN_MAX_STATIC_ALIGN_BYTES: plugin 32, host 16; let "},
      {[](Fingerprint& f) { f.eigen_malloc_aligned = 0; }, "EIGEN_MALLOC_ALREADY_ALIGNED: plugin 0, host 1; let "},
      {[](Fingerprint& f) { f.eigen_index_size = 4; }, "size of Eigen::Index: plugin 4, host 8; let "},
      {[](Fingerprint& f) { f.fast_math = 1; }, "fast math: plugin 1, host 0; build without -ffast-math"},
      {[](Fingerprint& f) { f.sanitizer ^= 2u; }, "sanitizers: plugin "},
      {[](Fingerprint& f) { f.sanitizer ^= 2u; }, "thread"},
      {[](Fingerprint& f) { f.instruction_set = 1u << 31; }, "instruction set: the plugin needs one that this host "
                                                              "does not know, this processor lacks one that"},
  };
  unsetenv(kMark);
  for (const auto& tampering : tamperings) {
    INFO("expected: ", tampering.sentence);
    const auto reasons = reasons_after(tampering.change);
    REQUIRE(reasons.size() == 1);
    INFO("said: ", reasons[0]);
    CHECK(reasons[0].find(tampering.sentence) != std::string::npos);
    CHECK(reasons[0].find("; ") != std::string::npos);
  }
  CHECK(std::getenv(kMark) == nullptr);
}

TEST_CASE("Refusal: an older minor version of the SDK, another compiler and assertions are no reason") {
  Fingerprint plugin = host_fingerprint(), host = host_fingerprint();
  host.sdk_minor = 5;
  plugin.sdk_minor = 4;
  plugin.compiler += 1000;
  plugin.cplusplus += 1;
  plugin.ndebug ^= 1u;
  plugin.gxx_abi += 1;
  CHECK(fingerprint_conflicts(plugin, host).empty());
}

TEST_CASE("Refusal: all fields that differ are told, not only the first") {
  const auto reasons = reasons_after([](Fingerprint& f) {
    f.eigen_max_align = 32;
    f.fast_math = 1;
  });
  CHECK(reasons.size() == 2);
}

TEST_CASE("Refusal: text, foreign libraries and odd files of the right name are passed over without a word") {
  const TemporaryDirectory folder;
  write_bytes(folder / "text.so", "not a library\n");
  write_bytes(folder / "empty.so", "");
  std::filesystem::create_directory(folder / "folder.so");
  REQUIRE(mkfifo((folder / "pipe.so").c_str(), 0600) == 0);  // reading it would wait for a writer for ever
  std::filesystem::copy_file(std::filesystem::canonical(PRESHAPE_BINARY_DIR "/lib/libpreshape_core.so"),
                             folder / "foreign.so");
  const Registry registry = registry_of(folder.path());
  CHECK(registry.libraries().empty());
  CHECK(registry.components().empty());
}

TEST_CASE("Refusal: a plugin cut off at any length is refused or passed over, and none of it runs") {
  const TemporaryDirectory folder;
  std::filesystem::copy_file(fixture_file("marks"), folder / "cut.so");
  unsetenv(kMark);
  const auto whole = std::filesystem::file_size(folder / "cut.so");
  for (std::uintmax_t size = whole; size-- > 0; size -= std::min<std::uintmax_t>(size, 511)) {
    std::filesystem::resize_file(folder / "cut.so", size);
    const Registry registry = registry_of(folder.path());
    CHECK_FALSE(registry.has("similarity", "marks"));
    for (const auto& library : registry.libraries()) CHECK(library.status == LibraryRecord::Status::kRefused);
    CHECK_THROWS_AS(registry.describe("similarity", "marks"), PluginError);
  }
  CHECK(std::getenv(kMark) == nullptr);
}

TEST_CASE("Refusal: a component of a kind that this host does not know refuses its library") {
  const TemporaryDirectory folder;
  write_tampered("marks", folder / "marks.so", [](Manifest& m) { std::strcpy(m.components[0], "gripper/marks"); });
  const Registry registry = registry_of(folder.path());
  REQUIRE(registry.libraries().size() == 1);
  CHECK(registry.libraries()[0].status == LibraryRecord::Status::kRefused);
  CHECK(registry.libraries()[0].reasons[0].find("'gripper/marks' is of no kind that this host knows") == 0);
}

TEST_CASE("Refusal: a library whose code declares other components than its manifest is not used") {
  const Registry registry = registry_of_fixture("other_names");
  CHECK_THROWS_SAYING(registry.create<Similarity>("listed"), PluginError,
                      "declares other components than its manifest lists; name the same in both parts");
  CHECK_FALSE(registry.has("similarity", "declared"));
  CHECK_FALSE(mapped(fixture_file("other_names")));
}

TEST_CASE("Refusal: a library that cannot be loaded, or whose entry is absent or another's, is refused with the reason") {
  CHECK_THROWS_SAYING(registry_of_fixture("no_entry").describe("similarity", "no_entry"), PluginError,
                      "does not export 'preshape_entry'; end its source with PRESHAPE_PLUGIN");
  CHECK_THROWS_SAYING(registry_of_fixture("two_faces").describe("similarity", "shown"), PluginError,
                      "has another manifest in memory than in its file; rebuild it");
  CHECK_THROWS_SAYING(registry_of_fixture("undefined").describe("similarity", "undefined"), PluginError,
                      "undefined symbol: _Z15defined_nowherev; install what it needs or rebuild it");
}

TEST_CASE("Refusal: what a constructor throws comes out with its text, as the error it is") {
  const Registry registry = registry_of_fixture("throws");
  const auto what = [](const char* kind) { return Value::table({{"what", kind}}); };
  CHECK_THROWS_SAYING(registry.create<Similarity>("throws", {}, {"scenario.lua", 5}), InputError,
                      "scenario.lua:5: similarity 'throws': the input is bad");
  CHECK_THROWS_SAYING(registry.create<Similarity>("throws", what("runtime")), PluginError,
                      "similarity 'throws': the machine is bad");
  CHECK_THROWS_SAYING(registry.create<Similarity>("throws", what("integer")), PluginError,
                      "similarity 'throws': an exception that is no std::exception");
  CHECK_THROWS_SAYING(registry.create<Similarity>("throws", what("long")), PluginError, "xxxx");
}

TEST_CASE("Refusal: a plugin that moves the process or sets its locale is refused and the change undone") {
  const auto folder = std::filesystem::current_path();
  CHECK_THROWS_SAYING(registry_of_fixture("moves_folder").describe("similarity", "disturbs"), PluginError,
                      "changed the working directory when it was loaded; it was put back and the plugin refused");
  CHECK(std::filesystem::current_path() == folder);
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  CHECK_THROWS_SAYING(registry_of_fixture("sets_locale").describe("similarity", "disturbs"), PluginError,
                      "changed the locale when it was loaded");
  CHECK(std::setlocale(LC_ALL, nullptr) == locale);
}

#if defined(__SSE__)
TEST_CASE("Refusal: a plugin linked with fast math is refused, and subnormal numbers live on") {
  const unsigned before = _mm_getcsr() & ~0x3fu;
  CHECK_THROWS_SAYING(registry_of_fixture("fast_math").describe("similarity", "plain"), PluginError,
                      "changed the floating-point mode (link it without -ffast-math) when it was loaded");
  CHECK((_mm_getcsr() & ~0x3fu) == before);
  volatile double smallest = std::numeric_limits<double>::min();
  CHECK(smallest / 4 > 0.0);
}
#endif

TEST_SUITE_END();
