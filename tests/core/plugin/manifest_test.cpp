#include "fixtures.h"
#include "preshape/base/random.h"

using namespace preshape;
using namespace preshape::test;
using Status = ManifestReading::Status;

TEST_SUITE_BEGIN("core/plugin");

TEST_CASE("Manifest: what the author declared is read from the file") {
  const ManifestReading reading = read_manifest(fixture_file("family"));
  REQUIRE(reading.status == Status::kFound);
  const Manifest& m = reading.manifest;
  CHECK(std::string(m.name) == "family");
  CHECK(std::string(m.version) == "1.2.0");
  CHECK(std::string(m.licence) == "MIT");
  CHECK(std::string(m.author) == "A. Author");
  REQUIRE(m.component_count == 2);
  CHECK(std::string(m.components[0]) == "similarity/zero");
  CHECK(std::string(m.components[1]) == "contact/normal");
  CHECK(fingerprint_conflicts(m.fingerprint, host_fingerprint()).empty());
}

TEST_CASE("Manifest: reading it loads nothing") {
  read_manifest(fixture_file("marks"));
  CHECK_FALSE(mapped(fixture_file("marks")));
}

TEST_CASE("Manifest: files that are no plugins are told from damaged ones") {
  const TemporaryDirectory folder;
  write_bytes(folder / "empty.so", "");
  write_bytes(folder / "text.so", "#!/bin/sh\necho hello\n");
  std::filesystem::create_directory(folder / "folder.so");
  for (const char* name : {"empty.so", "text.so", "folder.so", "absent.so"}) {
    INFO(name);
    CHECK(read_manifest(folder / name).status == Status::kNotAPlugin);
  }
  const auto core = std::filesystem::canonical(PRESHAPE_BINARY_DIR "/lib/libpreshape_core.so");
  CHECK(read_manifest(core).status == Status::kNotAPlugin);
}

TEST_CASE("Manifest: a library for another machine is said to be one") {
  const TemporaryDirectory folder;
  std::string bytes = read_bytes(fixture_file("marks"));
  bytes[offsetof(Elf64_Ehdr, e_machine)] = EM_SPARC;
  bytes[offsetof(Elf64_Ehdr, e_machine) + 1] = 0;
  write_bytes(folder / "sparc.so", bytes);
  const auto reading = read_manifest(folder / "sparc.so");
  CHECK(reading.status == Status::kBroken);
  CHECK(reading.reason.find("another machine") != std::string::npos);
}

TEST_CASE("Manifest: a plugin cut off at any length is never taken for a whole one") {
  const TemporaryDirectory folder;
  const auto file = folder / "cut.so";
  std::filesystem::copy_file(fixture_file("marks"), file);
  const auto whole = std::filesystem::file_size(file);
  int broken = 0;
  for (auto size = whole - 1; size > 200; size -= 97) {
    std::filesystem::resize_file(file, size);
    const auto reading = read_manifest(file);
    CHECK(reading.status != Status::kFound);
    if (reading.status == Status::kBroken) ++broken;
    if (size < 297) break;
  }
  CHECK(broken > 100);
  for (std::uintmax_t size = 200; size-- > 0;) {
    std::filesystem::resize_file(file, size);
    CHECK(read_manifest(file).status != Status::kFound);
  }
}

TEST_CASE("Manifest: bytes changed at random are read or refused, whatever they are") {
  const TemporaryDirectory folder;
  const std::string whole = read_bytes(fixture_file("marks"));
  Elf64_Ehdr header;
  std::memcpy(&header, whole.data(), sizeof header);
  const auto file = folder / "damaged.so";
  write_bytes(file, whole);
  const auto put = [&](std::uint64_t at, char byte) {
    std::fstream(file, std::ios::binary | std::ios::in | std::ios::out).seekp(static_cast<std::streamoff>(at)).put(byte);
  };
  Random random(21);
  int refused = 0;
  for (int i = 0; i < 1500; ++i) {
    // In the header or in the table of sections, where every offset and size stands.
    std::vector<std::uint64_t> places(1 + random.below(4));
    for (auto& at : places) {
      at = random.below(2) == 0 ? random.below(sizeof header)
                                : header.e_shoff + random.below(header.e_shnum * sizeof(Elf64_Shdr));
      put(at, static_cast<char>(random.below(256)));
    }
    const auto reading = read_manifest(file);
    if (reading.status != Status::kFound) {
      ++refused;
      CHECK_FALSE(reading.reason.empty());
    }
    for (const auto at : places) put(at, whole[at]);
  }
  CHECK(refused > 100);
}

TEST_CASE("Manifest: one of another format, size or beginning is refused, and so is one without an end of its texts") {
  const std::string kDamaged = "its manifest is damaged; build or copy the plugin again";
  const TemporaryDirectory folder;
  const auto file = folder / "tampered.so";
  const auto reason = [&](auto change) {
    write_tampered("marks", file, change);
    const auto reading = read_manifest(file);
    CHECK(reading.status == Status::kBroken);
    return reading.reason;
  };
  CHECK(reason([](Manifest& m) { m.magic[0] = 'P'; }) == kDamaged);
  CHECK(reason([](Manifest& m) { m.format = 9; }).find("format 9, this host reads format 1; rebuild") !=
        std::string::npos);
  CHECK(reason([](Manifest& m) { m.size += 4; }).find("rebuild the plugin") != std::string::npos);
  CHECK(reason([](Manifest& m) { m.component_count = 0; }) == kDamaged);
  CHECK(reason([](Manifest& m) { m.component_count = kManifestComponents + 1; }) == kDamaged);
  CHECK(reason([](Manifest& m) { m.name[0] = '\0'; }) == kDamaged);
  CHECK(reason([](Manifest& m) { std::memset(m.author, 'a', sizeof m.author); }) == kDamaged);
  CHECK(reason([](Manifest& m) { std::memset(m.components[3], 'a', sizeof m.components[3]); }) ==
        kDamaged);
}

TEST_SUITE_END();
