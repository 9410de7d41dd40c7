#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/plugin/fingerprint.h"

namespace preshape {

inline constexpr char kManifestMagic[8] = {'p', 'r', 'e', 's', 'h', 'a', 'p', 'e'};
inline constexpr std::uint32_t kManifestFormat = 1;
inline constexpr std::uint32_t kManifestComponents = 32;

/// Who a plugin library is and what it holds: plain bytes in the ELF section "preshape", read from the file
/// before the library is loaded.
struct Manifest {
  char magic[8];
  std::uint32_t size;    ///< sizeof(Manifest)
  std::uint32_t format;  ///< kManifestFormat
  Fingerprint fingerprint;
  char name[64], version[16], licence[32], author[64], summary[160];
  std::uint32_t component_count;
  char components[kManifestComponents][80];  ///< "kind/name"
};

namespace detail {

template <std::size_t N>
constexpr void copy_text(char (&to)[N], std::string_view from) {
  // A text that does not fit is no constant expression, so the plugin's author is told at compile time.
  if (from.size() >= N) throw "manifest text too long";
  for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i];
}

}  // namespace detail

/// What an author says of a plugin library.
struct PluginIdentity {
  std::string_view name, version, licence, author, summary;
};

static constexpr Manifest make_manifest(const PluginIdentity& identity,
                                        std::initializer_list<std::string_view> components) {
  Manifest m{};
  for (int i = 0; i < 8; ++i) m.magic[i] = kManifestMagic[i];
  m.size = sizeof(Manifest);
  m.format = kManifestFormat;
  m.fingerprint = this_fingerprint();
  detail::copy_text(m.name, identity.name);
  detail::copy_text(m.version, identity.version);
  detail::copy_text(m.licence, identity.licence);
  detail::copy_text(m.author, identity.author);
  detail::copy_text(m.summary, identity.summary);
  for (const auto component : components) detail::copy_text(m.components[m.component_count++], component);
  return m;
}

/// What reading a file for its manifest gave.
struct ManifestReading {
  enum class Status { kFound, kNotAPlugin, kBroken };
  Status status = Status::kNotAPlugin;
  std::string reason;  ///< unless kFound: one sentence
  Manifest manifest{};
};

/// Reads the manifest out of an ELF file's section "preshape" without loading the file.
PRESHAPE_API ManifestReading read_manifest(const std::filesystem::path& file);

}  // namespace preshape
