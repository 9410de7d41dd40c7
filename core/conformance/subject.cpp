#include "subject.h"

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/base/error.h"
#include "preshape/scripted/lua_loader.h"
#include "preshape/workbench/catalogue.h"

namespace preshape::conformance {

std::unique_ptr<Registry> registry_of(const std::filesystem::path& file) {
  std::vector<std::shared_ptr<const ComponentLoader>> loaders = {
      std::make_shared<LuaLoader>(Catalogue::standard().module_roots())};
  return std::make_unique<Registry>(std::vector<SearchFolder>{{file, "given"}}, std::move(loaders));
}

std::vector<Subject> subjects_in(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError(fmt::format("there is no plugin file '{}'; name a library, a Lua component or a component's name",
                                 file.string()));
  }
  const auto registry = registry_of(file);
  if (registry->libraries().empty()) {
    const std::string reason = file.extension() == ".lua" ? "a component in Lua is in a file NAME.plugin.lua"
                                                          : read_manifest(file).reason + "; build it with preshape_add_plugin";
    throw PluginError(fmt::format("'{}' is no plugin: {}", file.string(), reason));
  }
  const LibraryRecord& library = registry->libraries().front();
  if (library.status == LibraryRecord::Status::kRefused) {
    throw PluginError(fmt::format("plugin '{}' is refused: {}", file.string(), fmt::join(library.reasons, "; ")));
  }
  std::vector<Subject> subjects;
  for (const auto& key : registry->components()) subjects.push_back({library.file, key.kind, key.name});
  return subjects;
}

}  // namespace preshape::conformance
