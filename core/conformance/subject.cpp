#include "subject.h"

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/base/error.h"

namespace preshape::conformance {

std::unique_ptr<Registry> registry_of(const std::filesystem::path& file) {
  return std::make_unique<Registry>(std::vector<SearchFolder>{{file, "given"}});
}

std::vector<Subject> subjects_in(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError(fmt::format("there is no plugin file '{}'; name a library, a Lua component or a component's name",
                                 file.string()));
  }
  const auto registry = registry_of(file);
  if (registry->libraries().empty()) {
    const ManifestReading reading = read_manifest(file);
    throw PluginError(fmt::format("'{}' is no plugin: {}", file.string(), reading.reason));
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
