// The pages lead somewhere.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/data.h"

namespace fs = std::filesystem;
using preshape::test::source_file;

TEST_SUITE_BEGIN("architecture");

namespace {

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const char* file : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"})
    found.push_back(source_file(file));
  for (const char* folder : {"docs", "hands", "objects", "plugins", "scripts", "core", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source_file(folder))) {
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
  }
  return found;
}

std::vector<std::string> found_in(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

/// "fuzzy-sets" of a line "## Fuzzy sets", as pages are shown: letters, digits, - and _ stay.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(std::min(heading.find(' ') + 1, heading.size()))) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (std::isalnum(byte) || c == '-' || c == '_' || byte > 127)
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  std::ifstream stream(page);
  bool code = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) code = !code;
    if (!code && line.starts_with("#")) anchors.insert(anchor_of(line));
  }
  return anchors;
}

}  // namespace

TEST_CASE("Pages: every link to a file or a heading leads there") {
  static const std::regex link("\\]\\(([^)\\s]+)\\)");
  int checked = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& target : found_in(text_of(page), link)) {
      if (target.find(':') != std::string::npos) continue;  // of the network
      INFO(page.string(), ": ", target);
      const auto hash = target.find('#');
      const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
      CHECK(fs::exists(file));
      if (hash != std::string::npos) CHECK(anchors_of(file).contains(target.substr(hash + 1)));
      ++checked;
    }
  }
  CHECK(checked > 100);
}

TEST_SUITE_END();
