#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <doctest/doctest.h>

namespace preshape::test {

/// A file of the external test data, or an empty path, having said that the case is skipped.
inline std::filesystem::path test_data(const std::string& name) {
  const char* root = std::getenv("PRESHAPE_TEST_DATA");
  if (!root || !*root) {
    MESSAGE("skipped: PRESHAPE_TEST_DATA is unset, so '", name, "' is not there");
    return {};
  }
  return std::filesystem::path(root) / name;
}

/// A file of the source tree.
inline std::filesystem::path source_file(const std::string& name) {
  return std::filesystem::path(PRESHAPE_SOURCE_DIR) / name;
}

/// A fresh directory, removed at the end of the scope.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "preshape-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory: " + name);
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace preshape::test
