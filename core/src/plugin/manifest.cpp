#include "preshape/plugin/manifest.h"

#include <cstring>

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
    return {Status::kBroken, "its manifest does not begin as a preshape manifest", {}};
  }
  if (manifest.format != kManifestFormat || manifest.size != sizeof(Manifest) ||
      section.bytes.size() < sizeof(Manifest)) {
    return {Status::kBroken,
            "its manifest has format " + std::to_string(manifest.format) + ", this host reads format " +
                std::to_string(kManifestFormat) + "; rebuild the plugin with this installation's SDK",
            {}};
  }
  std::memcpy(&manifest, section.bytes.data(), sizeof(Manifest));
  if (!well_formed(manifest)) return {Status::kBroken, "its manifest is damaged", {}};
  reading.status = Status::kFound;
  return reading;
}

}  // namespace preshape
