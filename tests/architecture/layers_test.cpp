// The tree shows the theory: each area may include only those before it, plugins never include plugins.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "support/data.h"

namespace fs = std::filesystem;
using preshape::test::source_file;

TEST_SUITE_BEGIN("architecture");

namespace {

const std::vector<std::string> kAreas = {"base", "spatial", "geometry", "contact", "fuzzy",  "hand",
                                         "grasp", "plugin", "agent",    "script",  "scripted", "io", "workbench"};

std::ptrdiff_t rank(const std::string& area) {
  return std::find(kAreas.begin(), kAreas.end(), area) - kAreas.begin();
}

struct Include {
  fs::path file;
  int line;
  std::string target;
};

std::vector<Include> includes_below(const fs::path& folder) {
  static const std::regex pattern("^\\s*#include \"([^\"]+)\"");
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::string text;
    std::smatch match;
    for (int line = 1; std::getline(stream, text); ++line) {
      if (std::regex_search(text, match, pattern)) includes.push_back({entry.path(), line, match[1]});
    }
  }
  return includes;
}

/// "grasp" of "preshape/grasp/task.h"; "" for anything that is not an area's header.
std::string area_of_target(const std::string& target) {
  const fs::path path(target);
  auto part = path.begin();
  if (*part != "preshape" || ++part == path.end()) return "";
  return rank(part->string()) < std::ssize(kAreas) ? part->string() : "";
}

}  // namespace

TEST_CASE("Areas include only what stands before them in the order of the theory") {
  int checked = 0;
  for (const char* half : {"core/include/preshape", "core/src"}) {
    for (const auto& area : kAreas) {
      const fs::path folder = source_file(half) / area;
      if (!fs::exists(folder)) continue;
      for (const auto& include : includes_below(folder)) {
        const std::string target = area_of_target(include.target);
        if (target.empty()) continue;
        ++checked;
        CHECK_MESSAGE(rank(target) <= rank(area), include.file.string(), ":", include.line, " (", area, ") includes ", include.target);
      }
    }
  }
  CHECK(checked > 300);
}

TEST_CASE("Interface headers speak of mathematics and data only: no files, no Lua, no drawing") {
  static const std::regex forbidden("<(filesystem|fstream|iostream|lua.*|sqlite3\\.h|assimp.*|boost/.*)>");
  for (const char* area : {"spatial", "geometry", "contact", "fuzzy", "hand", "grasp"}) {
    for (const auto& entry : fs::directory_iterator(source_file("core/include/preshape") / area)) {
      std::ifstream stream(entry.path());
      std::string line;
      while (std::getline(stream, line)) {
        CHECK_MESSAGE(!(line.starts_with("#include") && std::regex_search(line, forbidden)), entry.path().string(), ": ", line);
      }
    }
  }
}

TEST_CASE("Plugins include the SDK and themselves, never one another, the core's sources or Lua") {
  for (const auto& include : includes_below(source_file("plugins"))) {
    const bool sdk = include.target.starts_with("preshape/");
    const bool own = fs::exists(include.file.parent_path() / include.target) && include.target.find('/') == std::string::npos;
    CHECK_MESSAGE((sdk || own), include.file.string(), ":", include.line, " includes ", include.target);
    for (const char* area : {"agent/", "script/", "io/", "workbench/"}) {
      CHECK_MESSAGE(!include.target.starts_with(std::string("preshape/") + area), include.file.string(), " includes ", include.target);
    }
  }
}

TEST_CASE("The thesis map names files that are there") {
  static const std::regex quoted("`([A-Za-z_0-9/.]+/[A-Za-z_0-9/.]*)`");
  std::ifstream stream(source_file("docs/thesis-map.md"));
  std::string line;
  int checked = 0;
  while (std::getline(stream, line)) {
    for (std::sregex_iterator match(line.begin(), line.end(), quoted), end; match != end; ++match) {
      std::string path = (*match)[1];
      if (path.starts_with("inc/")) path = "core/include/preshape/" + path.substr(4);
      ++checked;
      CHECK_MESSAGE(fs::exists(source_file(path)), path);
    }
  }
  CHECK(checked > 100);
}

TEST_CASE("Every public header names its unit of protection once") {
  for (const auto& entry : fs::recursive_directory_iterator(source_file("core/include"))) {
    if (entry.path().extension() != ".h") continue;
    std::ifstream stream(entry.path());
    std::string first;
    std::getline(stream, first);
    CHECK_MESSAGE(first == "#pragma once", entry.path().string());
  }
}

TEST_SUITE_END();
