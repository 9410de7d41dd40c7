#include "preshape/plugin/manifest.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "elf_section.h"

namespace preshape {

namespace {

template <std::size_t N>
bool terminated(const char (&text)[N]) {
  return std::memchr(text, '\0', N) != nullptr;
}

bool well_formed(const Manifest& m) {
  if (m.component_count == 0 || m.component_count > kManifestComponents) return false;
  for (const auto& component : m.components) {
    if (!terminated(component)) return false;
  }
  return terminated(m.name) && terminated(m.version) && terminated(m.licence) && terminated(m.author) &&
         terminated(m.summary) && m.name[0] != '\0';
}

std::string differs(const char* field, std::size_t plugin, std::size_t host) {
  return fmt::format("its manifest has {0} {1}, this host reads {0} {2}; rebuild the plugin with this installation's SDK",
                     field, plugin, host);
}

constexpr const char* kDamaged = "its manifest is damaged; build or copy the plugin again";

}  // namespace

ManifestReading read_manifest(const std::filesystem::path& file) {
  using Status = ManifestReading::Status;
  const ElfSection section = read_elf_section(file, "preshape");
  if (section.status == ElfSection::Status::kAbsent || section.status == ElfSection::Status::kNotElf) {
    return {Status::kNotAPlugin, section.reason, {}};
  }
  if (section.status != ElfSection::Status::kFound) return {Status::kBroken, section.reason, {}};

  ManifestReading reading;
  constexpr std::size_t kHead = offsetof(Manifest, fingerprint);
  Manifest& manifest = reading.manifest;
  if (section.bytes.size() >= kHead) std::memcpy(&manifest, section.bytes.data(), kHead);
  if (section.bytes.size() < kHead || std::memcmp(manifest.magic, kManifestMagic, sizeof kManifestMagic) != 0) {
    return {Status::kBroken, kDamaged, {}};
  }
  if (manifest.format != kManifestFormat) return {Status::kBroken, differs("format", manifest.format, kManifestFormat), {}};
  if (manifest.size != sizeof(Manifest) || section.bytes.size() < sizeof(Manifest)) {
    return {Status::kBroken, differs("size", std::min<std::size_t>(manifest.size, section.bytes.size()), sizeof(Manifest)),
            {}};
  }
  std::memcpy(&manifest, section.bytes.data(), sizeof(Manifest));
  if (!well_formed(manifest)) return {Status::kBroken, kDamaged, {}};
  reading.status = Status::kFound;
  return reading;
}

}  // namespace preshape
