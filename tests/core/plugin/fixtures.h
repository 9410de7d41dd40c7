#pragma once

#include <elf.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "preshape/plugin/registry.h"
#include "support/data.h"

namespace preshape::test {

/// The file of a fixture plugin, which lies in a folder of its own.
inline std::filesystem::path fixture_file(const std::string& name) {
  return std::filesystem::path(PRESHAPE_FIXTURES) / name / (name + ".so");
}

/// A registry that sees one folder only.
inline Registry registry_of(const std::filesystem::path& folder) { return Registry({{folder, "test"}}); }
inline Registry registry_of_fixture(const std::string& name) {
  return registry_of(fixture_file(name).parent_path());
}

inline std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Writes a copy of a fixture whose manifest `change` has altered, and nothing else.
template <class Change>
void write_tampered(const std::string& fixture, const std::filesystem::path& to, Change change) {
  std::string bytes = read_bytes(fixture_file(fixture));
  const std::string magic(kManifestMagic, sizeof kManifestMagic);
  Manifest manifest;
  std::size_t offset = bytes.find(magic);
  // The word stands elsewhere in the file too: the manifest is where its size and format follow.
  for (;; offset = bytes.find(magic, offset + 1)) {
    if (offset == std::string::npos || offset + sizeof manifest > bytes.size()) throw std::runtime_error("no manifest");
    std::memcpy(&manifest, bytes.data() + offset, sizeof manifest);
    if (manifest.size == sizeof manifest && manifest.format == kManifestFormat) break;
  }
  change(manifest);
  std::memcpy(bytes.data() + offset, &manifest, sizeof manifest);
  write_bytes(to, bytes);
}

/// A file is mapped into this process.
inline bool mapped(const std::filesystem::path& file) {
  return read_bytes("/proc/self/maps").find(std::filesystem::canonical(file).string()) != std::string::npos;
}

/// A defined symbol of a library's dynamic symbol table.
struct ExportedSymbol {
  std::string name;
  unsigned char binding;  ///< STB_GLOBAL, STB_WEAK, STB_GNU_UNIQUE
};

/// What a library exports, read from its file.
inline std::vector<ExportedSymbol> exported_symbols(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  Elf64_Ehdr header;
  std::memcpy(&header, bytes.data(), sizeof header);
  std::vector<Elf64_Shdr> sections(header.e_shnum);
  std::memcpy(sections.data(), bytes.data() + header.e_shoff, sections.size() * sizeof(Elf64_Shdr));
  std::vector<ExportedSymbol> exported;
  for (const auto& section : sections) {
    if (section.sh_type != SHT_DYNSYM) continue;
    std::vector<Elf64_Sym> symbols(section.sh_size / sizeof(Elf64_Sym));
    std::memcpy(symbols.data(), bytes.data() + section.sh_offset, section.sh_size);
    const char* names = bytes.data() + sections[section.sh_link].sh_offset;
    for (const auto& symbol : symbols) {
      if (symbol.st_shndx == SHN_UNDEF || ELF64_ST_BIND(symbol.st_info) == STB_LOCAL) continue;
      exported.push_back({names + symbol.st_name, static_cast<unsigned char>(ELF64_ST_BIND(symbol.st_info))});
    }
  }
  return exported;
}

}  // namespace preshape::test
