#include "preshape/scripted/lua_loader.h"

#include <cstring>

#include <fmt/format.h>

#include "adapters.h"
#include "declaration.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

using namespace scripted;

/// Each adapter is a pointer to its kind's interface, as the registry takes it.
std::shared_ptr<void> make(Blueprint blueprint) {
  const std::string kind = blueprint.kind;
  if (kind == "contact") return make_contact(std::move(blueprint));
  if (kind == "similarity") return make_similarity(std::move(blueprint));
  if (kind == "classifier") return make_classifier(std::move(blueprint));
  if (kind == "hand") return make_hand(std::move(blueprint));
  if (kind == "quality") return make_quality(std::move(blueprint));
  if (kind == "explorer") return make_explorer(std::move(blueprint));
  if (kind == "simulator") return make_simulator(std::move(blueprint));
  throw PluginError(fmt::format("a {} cannot be written in Lua", kind));
}

class LuaLibrary final : public ComponentLibrary {
 public:
  LuaLibrary(ComponentSource source, ComponentDeclaration declaration)
      : source_(std::move(source)), declaration_(std::move(declaration)) {}

  std::span<const ComponentDeclaration> components() const noexcept override { return {&declaration_, 1}; }

  std::shared_ptr<void> create(std::size_t, const Parameters& parameters) const override {
    return make({source_, declaration_.kind, declaration_.name, parameters});
  }

 private:
  ComponentSource source_;
  ComponentDeclaration declaration_;
};

}  // namespace

LuaLoader::LuaLoader(std::vector<std::filesystem::path> module_roots)
    : module_roots_(std::move(module_roots)) {}
LuaLoader::~LuaLoader() = default;

bool LuaLoader::claims(const std::filesystem::path& file) const {
  return file.filename().string().ends_with(kFileEnding) && !name_of(file).empty();
}

ManifestReading LuaLoader::read(const std::filesystem::path& file) const {
  return read_manifest_of(file, module_roots_);
}

std::shared_ptr<const ComponentLibrary> LuaLoader::load(const std::filesystem::path& file,
                                                        const Manifest& manifest) const {
  auto source = ComponentSource::read(file, module_roots_);
  Declaration declaration = read_declaration(source);
  if (std::memcmp(&declaration.manifest, &manifest, sizeof manifest) != 0) {
    throw PluginError(
        fmt::format("component '{}' has been changed since it was found; start again", source.shown));
  }
  return std::make_shared<LuaLibrary>(std::move(source), std::move(declaration.component));
}

}  // namespace preshape
