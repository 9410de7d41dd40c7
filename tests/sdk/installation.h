#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support/data.h"

namespace preshape::test {

namespace fs = std::filesystem;

inline std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// This build, installed and then moved, so that a path of the build or of the first place would be found out. Made
/// once; always in the same folder, so that a compiler cache knows what it compiled before.
inline const fs::path& installation() {
  static const fs::path prefix = [] {
    const fs::path folder = SDK_FOLDER;
    fs::remove_all(folder);
    fs::create_directories(folder);
    const std::string install = fmt::format("'{}' --install '{}' --prefix '{}' >'{}' 2>&1", SDK_CMAKE, PRESHAPE_BINARY_DIR,
                                            (folder / "first").string(), (folder / "install.log").string());
    if (std::system(install.c_str()) != 0) throw std::runtime_error(read_file(folder / "install.log"));
    fs::rename(folder / "first", folder / "prefix");
    return folder / "prefix";
  }();
  return prefix;
}

/// What a shell left.
struct ShellResult {
  int exit_code = -1;
  std::string output;  ///< both streams
};

/// Runs lines of a shell in a folder, as a person would who has the installation on the path and nothing else of
/// preshape. The first line that fails ends it.
inline ShellResult shell(const fs::path& folder, const std::string& lines) {
  const fs::path& prefix = installation();
  const fs::path script = prefix.parent_path() / "script.sh", log = prefix.parent_path() / "script.log";
  std::ofstream(script) << "set -e\ncd '" << folder.string() << "'\n" << lines << "\n";
  const std::string command = fmt::format(
      "env -u PRESHAPE_PLUGIN_PATH -u PRESHAPE_DATA_PATH -u MAKEFLAGS -u CMAKE_GENERATOR PATH='{0}/bin':\"$PATH\" "
      "CMAKE_PREFIX_PATH='{0}' PKG_CONFIG_PATH='{0}/lib/pkgconfig' XDG_DATA_HOME='{0}/../user' CMAKE_BUILD_PARALLEL_LEVEL=2 "
      "CMAKE_CXX_COMPILER_LAUNCHER='" SDK_LAUNCHER "' CCACHE_NOHASHDIR=1 "
      "CCACHE_SLOPPINESS=time_macros,include_file_mtime,include_file_ctime timeout 900 sh '{1}' >'{2}' 2>&1",
      prefix.string(), script.string(), log.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(log)};
}

/// The fenced blocks of a language in a Markdown text, in order.
inline std::vector<std::string> fenced_blocks(const std::string& markdown, const std::string& language) {
  std::vector<std::string> blocks;
  const std::string fence = "```" + language + "\n";
  for (auto at = markdown.find(fence); at != std::string::npos; at = markdown.find(fence, at)) {
    at += fence.size();
    const auto end = markdown.find("```", at);
    blocks.push_back(markdown.substr(at, end - at));
    at = end + 3;
  }
  return blocks;
}

}  // namespace preshape::test
