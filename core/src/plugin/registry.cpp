#include "preshape/plugin/registry.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "native_loader.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape {

namespace {

std::size_t kind_rank(std::string_view kind) {
  return static_cast<std::size_t>(std::find(kKinds.begin(), kKinds.end(), kind) - kKinds.begin());
}

ComponentKey key_of(std::string_view manifest_component) {
  const auto slash = manifest_component.find('/');
  if (slash == std::string_view::npos) return {"", std::string(manifest_component)};
  return {std::string(manifest_component.substr(0, slash)), std::string(manifest_component.substr(slash + 1))};
}

/// Whether `key` may be the component that is looked for; a broken script does not always tell its kind.
bool may_be(const ComponentKey& key, std::string_view kind, std::string_view name) {
  return key.name == name && (key.kind.empty() || kind.empty() || key.kind == kind);
}

bool lists(const LibraryRecord& library, std::string_view kind, std::string_view name) {
  const auto keys = library.components();
  return std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return may_be(key, kind, name); });
}

/// A loader's files in a folder and, unless only sandboxed ones are wanted, in the folders directly below, sorted by
/// name; a file in the place of a folder stands for itself.
std::vector<std::filesystem::path> files_of(const ComponentLoader& loader, const SearchFolder& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  if (std::filesystem::is_regular_file(folder.path, error)) {
    return loader.claims(folder.path) ? std::vector{folder.path} : files;
  }
  const auto collect = [&](const std::filesystem::path& in) {
    for (const auto& entry : std::filesystem::directory_iterator(in, error)) {
      if (loader.claims(entry.path()) && entry.is_regular_file(error)) files.push_back(entry.path());
    }
  };
  if (folder.sandboxed_only && !loader.sandboxed()) return files;
  collect(folder.path);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path, error)) {
    if (!folder.sandboxed_only && entry.is_directory(error)) collect(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<ComponentKey> LibraryRecord::components() const {
  std::vector<ComponentKey> keys;
  for (std::uint32_t i = 0; i < manifest.component_count; ++i) keys.push_back(key_of(manifest.components[i]));
  return keys;
}

struct Registry::State {
  /// A library's loader, and what it gave once it was asked.
  struct Slot {
    const ComponentLoader* loader;
    std::mutex mutex;
    std::shared_ptr<const ComponentLibrary> library;
  };

  std::vector<SearchFolder> folders;
  std::vector<std::shared_ptr<const ComponentLoader>> loaders;
  std::vector<LibraryRecord> libraries;
  std::vector<std::unique_ptr<Slot>> slots;    ///< one for each of libraries
  std::map<ComponentKey, std::size_t> owners;  ///< index into libraries

  mutable std::mutex mutex;  ///< guards what follows
  mutable std::map<ComponentKey, std::unique_ptr<ComponentRecord>> described;

  void scan();
  void add(const std::filesystem::path& file, const std::string& origin, const ComponentLoader& loader);
  std::shared_ptr<const ComponentLibrary> library(std::size_t index) const;
  std::size_t owner(std::string_view kind, std::string_view name) const;
  [[noreturn]] void refuse_unknown(std::string_view kind, std::string_view name) const;
};

void Registry::State::scan() {
  std::set<std::filesystem::path> seen;
  for (const auto& folder : folders) {
    for (const auto& loader : loaders) {
      for (const auto& file : files_of(*loader, folder)) {
        std::error_code error;
        const auto canonical = std::filesystem::canonical(file, error);
        if (!error && seen.insert(canonical).second) add(canonical, folder.origin, *loader);
      }
    }
  }
}

void Registry::State::add(const std::filesystem::path& file, const std::string& origin,
                          const ComponentLoader& loader) {
  const ManifestReading reading = loader.read(file);
  if (reading.status == ManifestReading::Status::kNotAPlugin) return;
  LibraryRecord record{file, origin, LibraryRecord::Status::kUsable, {}, reading.manifest, std::string(loader.language())};
  if (reading.status == ManifestReading::Status::kBroken) {
    record.reasons = {reading.reason};
  } else {
    record.reasons = fingerprint_conflicts(reading.manifest.fingerprint, host_fingerprint());
    for (const auto& key : record.components()) {
      if (kind_rank(key.kind) == kKinds.size()) {
        record.reasons.push_back(fmt::format("'{}' is of no kind that this host knows", key.kind + "/" + key.name));
      }
    }
  }
  if (!record.reasons.empty()) record.status = LibraryRecord::Status::kRefused;

  if (record.status == LibraryRecord::Status::kUsable) {
    std::size_t taken = 0;
    for (const auto& key : record.components()) {
      const auto [owner, is_new] = owners.emplace(key, libraries.size());
      if (is_new) continue;
      ++taken;
      record.reasons.push_back(fmt::format("{} '{}' is already taken by '{}'", key.kind, key.name,
                                           libraries[owner->second].file.string()));
    }
    if (taken == record.manifest.component_count) record.status = LibraryRecord::Status::kShadowed;
  }
  libraries.push_back(std::move(record));
  slots.push_back(std::make_unique<Slot>());
  slots.back()->loader = &loader;
}

void Registry::State::refuse_unknown(std::string_view kind, std::string_view name) const {
  for (const auto& library : libraries) {
    if (library.status != LibraryRecord::Status::kRefused || !lists(library, kind, name)) continue;
    std::string reasons;
    for (const auto& reason : library.reasons) reasons += (reasons.empty() ? "" : "; ") + reason;
    throw PluginError(fmt::format("{} '{}': plugin '{}' is refused: {}", kind, name, library.file.string(), reasons));
  }
  std::vector<std::string> names;
  for (const auto& [key, owner] : owners) {
    if (key.kind == kind) names.push_back(key.name);
  }
  if (kind_rank(kind) == kKinds.size()) {
    const std::vector<std::string> kinds(kKinds.begin(), kKinds.end());
    throw PluginError(fmt::format("there is no kind '{}'{}", kind, did_you_mean(kind, kinds)));
  }
  if (names.empty()) {
    throw PluginError(fmt::format("there is no plugin of kind '{}' on the search path; see 'preshape doctor'", kind));
  }
  throw PluginError(fmt::format("there is no {} '{}'{}", kind, name, did_you_mean(name, names)));
}

std::size_t Registry::State::owner(std::string_view kind, std::string_view name) const {
  const auto found = owners.find({std::string(kind), std::string(name)});
  if (found == owners.end()) refuse_unknown(kind, name);
  return found->second;
}

std::shared_ptr<const ComponentLibrary> Registry::State::library(std::size_t index) const {
  Slot& slot = *slots[index];
  const std::lock_guard lock(slot.mutex);
  if (!slot.library) slot.library = slot.loader->load(libraries[index].file, libraries[index].manifest);
  return slot.library;
}

Registry::Registry(std::vector<SearchFolder> folders, std::vector<std::shared_ptr<const ComponentLoader>> loaders)
    : state_(std::make_unique<State>()) {
  state_->folders = std::move(folders);
  state_->loaders = std::move(loaders);
  state_->loaders.insert(state_->loaders.begin(), std::make_shared<NativeLoader>());
  state_->scan();
}

Registry::~Registry() = default;

std::span<const SearchFolder> Registry::folders() const { return state_->folders; }
std::span<const LibraryRecord> Registry::libraries() const { return state_->libraries; }

std::vector<ComponentKey> Registry::components() const {
  std::vector<ComponentKey> keys;
  for (const auto& [key, owner] : state_->owners) keys.push_back(key);
  std::stable_sort(keys.begin(), keys.end(),
                   [](const auto& a, const auto& b) { return kind_rank(a.kind) < kind_rank(b.kind); });
  return keys;
}

std::vector<std::string> Registry::names(std::string_view kind) const {
  std::vector<std::string> names;
  for (const auto& [key, owner] : state_->owners) {
    if (key.kind == kind) names.push_back(key.name);
  }
  return names;
}

bool Registry::has(std::string_view kind, std::string_view name) const {
  return state_->owners.contains({std::string(kind), std::string(name)});
}

const ComponentRecord& Registry::describe(std::string_view kind, std::string_view name) const {
  const std::size_t index = state_->owner(kind, name);
  const ComponentKey key{std::string(kind), std::string(name)};
  {
    const std::lock_guard lock(state_->mutex);
    if (const auto known = state_->described.find(key); known != state_->described.end()) return *known->second;
  }
  const LibraryRecord& file = state_->libraries[index];
  const auto library = state_->library(index);
  for (const ComponentDeclaration& d : library->components()) {
    if (d.kind != kind || d.name != name) continue;
    auto record = std::make_unique<ComponentRecord>(ComponentRecord{
        d.kind, d.name, d.summary, d.capabilities,
        ParameterSchema(fmt::format("{} '{}'", d.kind, d.name), d.parameters), file.file, file.manifest.name,
        file.manifest.version, file.manifest.licence, file.manifest.author, file.language});
    const std::lock_guard lock(state_->mutex);
    return *state_->described.emplace(key, std::move(record)).first->second;
  }
  throw PluginError(fmt::format("plugin '{}' lists {} '{}' but does not declare it; build or write it anew",
                                file.file.string(), kind, name));
}

std::shared_ptr<void> Registry::create_erased(std::string_view kind, std::string_view name, const Value& given,
                                              const SourcePlace& place) const {
  const Parameters parameters = describe(kind, name).schema.resolve(given, place);
  const auto library = state_->library(state_->owner(kind, name));
  const auto components = library->components();
  std::size_t index = 0;
  while (components[index].kind != kind || components[index].name != name) ++index;
  const std::string where = place.known() ? place.text() + ": " : "";
  try {
    return library->create(index, parameters);
  } catch (const InputError& problem) {
    throw InputError(fmt::format("{}{} '{}': {}", where, kind, name, problem.what()));
  } catch (const Error& problem) {
    throw PluginError(fmt::format("{}{} '{}': {}", where, kind, name, problem.what()));
  }
}

std::vector<std::string> Registry::why(std::string_view kind, std::string_view name) const {
  std::vector<std::string> lines;
  for (const auto& folder : state_->folders) {
    std::error_code error;
    const bool exists = std::filesystem::is_directory(folder.path, error);
    lines.push_back(fmt::format("folder {} ({}){}", folder.path.string(), folder.origin, exists ? "" : ": not there"));
  }
  for (const auto& library : state_->libraries) {
    if (library.manifest.component_count == 0) {  // its manifest could not be read, so it may be the one that is looked for
      lines.push_back(fmt::format("library {}: refused", library.file.string()));
      for (const auto& reason : library.reasons) lines.push_back("  " + reason);
      continue;
    }
    if (!lists(library, kind, name)) continue;
    static constexpr const char* kStatus[] = {"usable", "refused", "shadowed"};
    lines.push_back(fmt::format("library {} ({} {}): {}", library.file.string(), library.manifest.name,
                                library.manifest.version, kStatus[static_cast<int>(library.status)]));
    lines.push_back(library.language == "C++"
                        ? fmt::format("  built with {}", fingerprint_text(library.manifest.fingerprint))
                        : fmt::format("  written in {}", library.language));
    for (const auto& reason : library.reasons) lines.push_back("  " + reason);
  }
  lines.push_back(fmt::format("host       {}", fingerprint_text(host_fingerprint())));
  if (!has(kind, name)) {
    lines.push_back(fmt::format("result: no usable {} '{}'", kind.empty() ? "component" : kind, name));
    return lines;
  }
  try {
    lines.push_back(fmt::format("result: {} is used", describe(kind, name).file.string()));
  } catch (const PluginError& problem) {
    lines.push_back(fmt::format("result: {}", problem.what()));
  }
  return lines;
}

}  // namespace preshape
