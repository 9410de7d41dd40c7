#include "preshape/plugin/fingerprint.h"

#include <fmt/format.h>

namespace preshape {

namespace {

std::string number_of(std::uint32_t value) { return fmt::format("{}", value); }

std::string eigen_version(std::uint32_t value) {
  return fmt::format("{}.{}.{}", value / 10000, value / 100 % 100, value % 100);
}

std::string sanitizer_names(std::uint32_t bits) {
  static constexpr const char* kNames[] = {"none", "address", "thread", "address,thread"};
  return kNames[bits & 3u];
}

/// A field on which both sides must agree, with the mend.
struct Field {
  const char* name;
  std::uint32_t Fingerprint::*value;
  const char* mend;
  std::string (*text)(std::uint32_t) = number_of;
};

constexpr const char* kRebuild = "rebuild the plugin with this installation's SDK";
constexpr const char* kFlags = "let preshape_add_plugin set the compile flags";

constexpr Field kMustEqual[] = {
    {"SDK major version", &Fingerprint::sdk_major, kRebuild},
    {"C++ string ABI (_GLIBCXX_USE_CXX11_ABI)", &Fingerprint::cxx11_abi, "build with -D_GLIBCXX_USE_CXX11_ABI=1"},
    {"libstdc++ debug mode (_GLIBCXX_DEBUG)", &Fingerprint::glibcxx_debug, "build without -D_GLIBCXX_DEBUG"},
    {"run-time type information", &Fingerprint::rtti, "build without -fno-rtti"},
    {"exceptions", &Fingerprint::exceptions, "build without -fno-exceptions"},
    {"Eigen version", &Fingerprint::eigen_version, "build with the same Eigen", eigen_version},
    {"EIGEN_MAX_ALIGN_BYTES", &Fingerprint::eigen_max_align, kFlags},
    {"EIGEN_MAX_STATIC_ALIGN_BYTES", &Fingerprint::eigen_static_align, kFlags},
    {"EIGEN_MALLOC_ALREADY_ALIGNED", &Fingerprint::eigen_malloc_aligned, kFlags},
    {"size of Eigen::Index", &Fingerprint::eigen_index_size, kFlags},
    {"fast math", &Fingerprint::fast_math, "build without -ffast-math"},
    {"sanitizers", &Fingerprint::sanitizer, "build plugin and host with the same -fsanitize", sanitizer_names},
    {"size of the boundary types", &Fingerprint::probe_size, kRebuild},
    {"alignment of the boundary types", &Fingerprint::probe_alignment, kRebuild},
};

std::uint64_t interface_hash(const Fingerprint& f) {
  return std::uint64_t{f.interface_hash_high} << 32 | f.interface_hash_low;
}

/// What the running processor can do, as the bits of instruction_set.
std::uint32_t processor_bits() {
  std::uint32_t bits = 0;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx")) bits |= 1u;
  if (__builtin_cpu_supports("avx2")) bits |= 2u;
  if (__builtin_cpu_supports("fma")) bits |= 4u;
  if (__builtin_cpu_supports("avx512f")) bits |= 8u;
#endif
  return bits;
}

std::string instruction_names(std::uint32_t bits) {
  static constexpr const char* kNames[] = {"AVX", "AVX2", "FMA", "AVX-512F"};
  std::string names;
  for (unsigned i = 0; i < 4; ++i) {
    if (bits & (1u << i)) names += fmt::format("{}{}", names.empty() ? "" : " ", kNames[i]);
  }
  if (bits >> 4) names += fmt::format("{}{}", names.empty() ? "" : " ", "one that this host does not know");
  return names;
}

}  // namespace

std::vector<std::string> fingerprint_conflicts(const Fingerprint& plugin, const Fingerprint& host) {
  std::vector<std::string> conflicts;
  for (const auto& field : kMustEqual) {
    const std::uint32_t theirs = plugin.*field.value, ours = host.*field.value;
    if (theirs != ours) {
      conflicts.push_back(fmt::format("{}: plugin {}, host {}; {}", field.name, field.text(theirs), field.text(ours),
                                      field.mend));
    }
  }
  if (interface_hash(plugin) != interface_hash(host)) {
    conflicts.push_back(fmt::format("interface hash: plugin {:016x}, host {:016x}; {}", interface_hash(plugin),
                                    interface_hash(host), kRebuild));
  }
  if (plugin.sdk_major == host.sdk_major && plugin.sdk_minor > host.sdk_minor) {
    conflicts.push_back(fmt::format("SDK minor version: plugin {}.{}, host {}.{}; install a newer preshape",
                                    plugin.sdk_major, plugin.sdk_minor, host.sdk_major, host.sdk_minor));
  }
  const std::uint32_t missing = plugin.instruction_set & ~processor_bits();
  if (missing != 0) {
    conflicts.push_back(fmt::format("instruction set: the plugin needs {}, this processor lacks {}; build it without "
                                    "-march=native",
                                    instruction_names(plugin.instruction_set), instruction_names(missing)));
  }
  return conflicts;
}

std::string fingerprint_text(const Fingerprint& f) {
  std::string text = fmt::format("SDK {}.{}, {} {}, Eigen {}", f.sdk_major, f.sdk_minor,
                                 f.compiler >= 2000000u ? "clang" : "g++", f.compiler % 1000000u / 1000u,
                                 eigen_version(f.eigen_version));
  if (f.instruction_set) text += ", " + instruction_names(f.instruction_set);
  if (f.sanitizer) text += ", sanitizers";
  return text + fmt::format(", interfaces {:016x}", interface_hash(f));
}

const Fingerprint& host_fingerprint() {
  static constexpr Fingerprint kHost = this_fingerprint();
  return kHost;
}

}  // namespace preshape
