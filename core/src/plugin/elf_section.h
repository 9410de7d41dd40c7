#pragma once

#include <filesystem>
#include <string>

namespace preshape {

/// The bytes of one section of a 64-bit little-endian ELF shared object.
struct ElfSection {
  enum class Status { kFound, kAbsent, kNotElf, kForeign, kBroken };
  Status status = Status::kNotElf;
  std::string reason;  ///< unless found
  std::string bytes;
};

/// Reads a section by name from the file itself; nothing is loaded, every offset is checked against the file.
ElfSection read_elf_section(const std::filesystem::path& file, const char* name);

}  // namespace preshape
