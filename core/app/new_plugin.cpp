#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/version.h"

namespace preshape::app {

namespace fs = std::filesystem;

namespace {

struct NewPluginOptions {
  std::string kind, name, folder = ".";
  bool lua = false;
};

/// Files to write, by their names.
using Files = std::map<std::string, std::string>;

constexpr std::size_t kLongestName = 48;  // with its kind it fits a manifest

bool is_lower_snake(const std::string& name) {
  const auto small = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && name.back() != '_' &&
         std::all_of(name.begin(), name.end(), small) && name.find("__") == std::string::npos;
}

/// "rubber_pad" -> "RubberPad".
std::string pascal(const std::string& name) {
  std::string text;
  bool start = true;
  for (const char c : name) {
    if (c == '_') start = true;
    else text += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c, start = false;
  }
  return text;
}

void check_words(const NewPluginOptions& options) {
  const std::vector<std::string> kinds(kKinds.begin(), kKinds.end());
  if (std::find(kinds.begin(), kinds.end(), options.kind) == kinds.end()) {
    throw CLI::ValidationError(fmt::format("there is no kind '{}'{}", options.kind, did_you_mean(options.kind, kinds)));
  }
  if (!is_lower_snake(options.name) || options.name.size() > kLongestName) {
    throw CLI::ValidationError(fmt::format("a component's name is of small letters, digits and single underscores, begins with "
                                           "a letter and has at most {} characters, such as rubber_pad; got '{}'",
                                           kLongestName, options.name));
  }
  if (options.lua && options.kind == "collision") {
    throw CLI::ValidationError("a collision backend cannot be written in Lua, for it answers millions of queries; leave --lua out");
  }
}

std::string replaced(std::string text, const NewPluginOptions& options) {
  const std::pair<const char*, std::string> words[] = {
      {"@NAME@", options.name}, {"@CLASS@", pascal(options.name)}, {"@KIND@", options.kind},
      {"@VERSION@", fmt::format("{}.{}", PRESHAPE_VERSION_MAJOR, PRESHAPE_VERSION_MINOR)}};
  for (const auto& [word, value] : words) {
    const std::string_view w(word);
    for (auto at = text.find(w); at != std::string::npos; at = text.find(w, at + value.size())) text.replace(at, w.size(), value);
  }
  return text;
}

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw InputError(fmt::format("the template '{}' cannot be read; install preshape again", path.string()));
  return text;
}

/// The files of a template folder, after those of the same name that are there already. NAME in a file's name is the
/// component's.
void add_templates(const fs::path& folder, const NewPluginOptions& options, Files& files) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename().string();
    if (name.starts_with("NAME")) name.replace(0, 4, options.name);
    files[name] += replaced(read(entry.path()), options);
  }
}

/// The templates of a kind: the first root of the catalogue that has them wins.
Files render(const Catalogue& catalogue, const NewPluginOptions& options) {
  for (const auto& root : catalogue.roots()) {
    const fs::path folder = root / "templates" / (options.lua ? "lua" : "cpp");
    std::error_code error;
    if (!fs::is_directory(folder / options.kind, error)) continue;
    Files files;
    add_templates(folder / options.kind, options, files);
    add_templates(folder / "any", options, files);
    return files;
  }
  throw InputError("the templates of components were not found; install preshape, or name the folder that has 'templates' "
                   "in PRESHAPE_DATA_PATH");
}

/// Writes all files into a new folder, or nothing.
void write(const Files& files, const fs::path& folder) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder, error))) {
    throw InputError(fmt::format("'{}' is there already and is left as it is; choose another name or --folder", folder.string()));
  }
  const fs::path part = folder.string() + ".part";
  if (!fs::is_directory(folder.parent_path(), error) || !fs::create_directory(part, error)) {
    throw InputError(fmt::format("'{}' cannot be made; check that its folder exists and may be written to", part.string()));
  }
  try {
    for (const auto& [name, text] : files) write_file(part / name, text);
    fs::rename(part, folder);
  } catch (...) {
    fs::remove_all(part, error);
    throw;
  }
}

void make(Application& application, const NewPluginOptions& options) {
  check_words(options);
  const Files files = render(application.catalogue(), options);
  const fs::path folder = (fs::path(options.folder) / options.name).lexically_normal();
  write(files, fs::absolute(folder));
  for (const auto& [name, text] : files) fmt::print("{}\n", (folder / name).string());
  if (application.registry().has(options.kind, options.name)) {
    fmt::print(stderr, "preshape: note: there is a {} '{}' already; the one that is found first is used\n", options.kind, options.name);
  }
  fmt::print("{}/README.md says how to build and try it\n", folder.string());
}

}  // namespace

void add_new_plugin(CLI::App& root, Application& application) {
  auto options = std::make_shared<NewPluginOptions>();
  CLI::App* verb = root.add_subcommand("new-plugin", "Write a small, working component of a kind, to start from");
  verb->add_option("kind", options->kind, fmt::format("{}", fmt::join(kKinds, ", ")))->required()->type_name("KIND");
  verb->add_option("name", options->name, "name of the component, such as rubber_pad")->required()->type_name("NAME");
  verb->add_flag("--lua", options->lua, "written in Lua instead of C++");
  verb->add_option("--folder", options->folder, "folder in which the new folder NAME is made")->type_name("DIR");
  verb->footer("Examples:\n  preshape new-plugin contact rubber_pad\n  preshape new-plugin similarity tversky --lua --folder ~/models");
  verb->callback([options, &application] { make(application, *options); });
}

}  // namespace preshape::app
