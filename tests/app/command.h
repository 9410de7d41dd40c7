#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "support/data.h"

namespace preshape::test {

/// What a run of the command left.
struct CommandResult {
  int exit_code = -1;
  std::string out, err;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Runs the built command as a user would: from a directory of its own, with a user folder of its own.
class CommandLine {
 public:
  CommandResult run(const std::string& arguments) const {
    const std::string command = fmt::format(
        "cd '{0}' && env -u PRESHAPE_PLUGIN_PATH -u PRESHAPE_DATA_PATH XDG_DATA_HOME='{0}/user' timeout 120 '{1}/bin/preshape' {2} "
        ">'{0}/out' 2>'{0}/err'",
        folder_.path().string(), PRESHAPE_BINARY_DIR, arguments);
    const int status = std::system(command.c_str());
    CommandResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.out = read_text(folder_ / "out");
    result.err = read_text(folder_ / "err");
    return result;
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryDirectory folder_;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace preshape::test
