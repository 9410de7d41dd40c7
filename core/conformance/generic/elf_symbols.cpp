#include "elf_symbols.h"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

class Image {
 public:
  explicit Image(const std::filesystem::path& file) : file_(file) {
    std::ifstream stream(file, std::ios::binary);
    bytes_ = {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  template <class T>
  T at(std::uint64_t offset) const {
    T value;
    if (offset > bytes_.size() || sizeof(T) > bytes_.size() - offset) refuse();
    std::memcpy(&value, bytes_.data() + offset, sizeof(T));
    return value;
  }
  std::string text(const Elf64_Shdr& strings, std::uint64_t index) const {
    const std::uint64_t begin = strings.sh_offset + index;
    const auto end = bytes_.find('\0', begin);
    if (begin >= bytes_.size() || end == std::string::npos) refuse();
    return bytes_.substr(begin, end - begin);
  }

 private:
  [[noreturn]] void refuse() const {
    throw InputError(fmt::format("'{}' is damaged: its dynamic table leaves the file; build it again", file_.string()));
  }
  std::filesystem::path file_;
  std::string bytes_;
};

void read_symbols(const Image& image, const Elf64_Shdr& section, const Elf64_Shdr& strings, DynamicTable& table) {
  for (std::uint64_t i = 1; i < section.sh_size / sizeof(Elf64_Sym); ++i) {
    const auto symbol = image.at<Elf64_Sym>(section.sh_offset + i * sizeof(Elf64_Sym));
    const std::string name = image.text(strings, symbol.st_name);
    const auto bind = ELF64_ST_BIND(symbol.st_info);
    if (symbol.st_shndx == SHN_UNDEF) table.undefined.push_back(name);
    else if (bind == STB_GNU_UNIQUE) table.unique.push_back(name);
    else if (bind != STB_LOCAL && symbol.st_shndx != SHN_ABS) table.exported.push_back(name);
  }
}

void read_dynamic(const Image& image, const Elf64_Shdr& section, const Elf64_Shdr& strings, DynamicTable& table) {
  for (std::uint64_t i = 0; i < section.sh_size / sizeof(Elf64_Dyn); ++i) {
    const auto entry = image.at<Elf64_Dyn>(section.sh_offset + i * sizeof(Elf64_Dyn));
    if (entry.d_tag == DT_NULL) return;
    if (entry.d_tag == DT_NEEDED) table.needed.push_back(image.text(strings, entry.d_un.d_val));
    if (entry.d_tag == DT_TEXTREL) table.text_relocations = true;
    if (entry.d_tag != DT_RPATH && entry.d_tag != DT_RUNPATH) continue;
    std::istringstream folders(image.text(strings, entry.d_un.d_val));
    for (std::string folder; std::getline(folders, folder, ':');) table.run_paths.push_back(folder);
  }
}

}  // namespace

DynamicTable dynamic_table(const std::filesystem::path& file) {
  const Image image(file);
  const auto header = image.at<Elf64_Ehdr>(0);
  const auto section_at = [&](std::uint64_t index) {
    return image.at<Elf64_Shdr>(header.e_shoff + index * sizeof(Elf64_Shdr));
  };
  DynamicTable table;
  for (std::uint64_t i = 0; i < header.e_shnum; ++i) {
    const Elf64_Shdr section = section_at(i);
    if (section.sh_type == SHT_DYNSYM) read_symbols(image, section, section_at(section.sh_link), table);
    if (section.sh_type == SHT_DYNAMIC) read_dynamic(image, section, section_at(section.sh_link), table);
  }
  return table;
}

}  // namespace preshape::conformance
