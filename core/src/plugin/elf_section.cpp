#include "elf_section.h"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <optional>
#include <vector>

namespace preshape {

namespace {

constexpr const char* kCutOff = "its section headers are damaged or the file is cut off; build or copy it again";

/// A file of which only checked ranges are read.
class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    if (stream_.seekg(0, std::ios::end)) size_ = static_cast<std::uint64_t>(stream_.tellg());
  }
  bool open() const { return stream_.is_open() && size_ > 0; }

  bool read(std::uint64_t offset, void* to, std::uint64_t count) {
    if (count > size_ || offset > size_ - count) return false;
    stream_.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(stream_.read(static_cast<char*>(to), static_cast<std::streamsize>(count)));
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
constexpr Elf64_Half kMachine = EM_NONE;
#endif

std::optional<ElfSection> header_fault(const Elf64_Ehdr& header) {
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return ElfSection{ElfSection::Status::kNotElf, "it is no ELF file", ""};
  if (header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != ELFDATA2LSB ||
      header.e_machine != kMachine) {
    return ElfSection{ElfSection::Status::kForeign, "it was built for another machine; build it on this one", ""};
  }
  if (header.e_shentsize != sizeof(Elf64_Shdr) || header.e_shnum == 0 || header.e_shstrndx >= header.e_shnum) {
    return ElfSection{ElfSection::Status::kBroken, kCutOff, ""};
  }
  return std::nullopt;
}

constexpr std::uint64_t kLargestSection = 1 << 20;
}  // namespace

ElfSection read_elf_section(const std::filesystem::path& file, const char* name) {
  const ElfSection broken{ElfSection::Status::kBroken, kCutOff, ""};
  Bytes bytes(file);
  Elf64_Ehdr header{};
  if (!bytes.open() || !bytes.read(0, &header, sizeof header)) {
    return {ElfSection::Status::kNotElf, "it is no ELF file", ""};
  }
  if (auto fault = header_fault(header)) return *fault;

  std::vector<Elf64_Shdr> sections(header.e_shnum);
  if (!bytes.read(header.e_shoff, sections.data(), sections.size() * sizeof(Elf64_Shdr))) return broken;
  const Elf64_Shdr& names_section = sections[header.e_shstrndx];
  if (names_section.sh_size > kLargestSection) return broken;
  std::string names(names_section.sh_size, '\0');
  if (!bytes.read(names_section.sh_offset, names.data(), names.size())) return broken;

  for (const auto& section : sections) {
    if (section.sh_name >= names.size() || std::strcmp(names.c_str() + section.sh_name, name) != 0) continue;
    if (section.sh_size > kLargestSection) return broken;
    ElfSection found{ElfSection::Status::kFound, "", std::string(section.sh_size, '\0')};
    if (!bytes.read(section.sh_offset, found.bytes.data(), found.bytes.size())) return broken;
    return found;
  }
  return {ElfSection::Status::kAbsent, "it has no section 'preshape', so it is no preshape plugin", ""};
}

}  // namespace preshape
