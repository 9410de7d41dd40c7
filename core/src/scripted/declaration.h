#pragma once

#include "blueprint.h"
#include "preshape/plugin/entry.h"
#include "preshape/plugin/manifest.h"

namespace preshape::scripted {

/// The end of a component's file name.
inline constexpr std::string_view kFileEnding = ".plugin.lua";

/// "cosine" of ".../cosine.plugin.lua".
std::string name_of(const std::filesystem::path& file);

/// What a component's file declares.
struct Declaration {
  Manifest manifest{};
  ComponentDeclaration component;
};

/// Runs the file in a state of its own and reads the table that it returns.
/// @throws ScriptError, InputError with the first mistake
Declaration read_declaration(const ComponentSource& source);

/// The same as a reading: of a faulty file with the mistake, its name and, where it says one, its kind.
ManifestReading read_manifest_of(const std::filesystem::path& file,
                                 std::vector<std::filesystem::path> module_roots);

}  // namespace preshape::scripted
