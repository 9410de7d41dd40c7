#pragma once

#include <filesystem>
#include <string_view>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

namespace preshape::urdf_hand {

/// Reads a URDF. Nothing is printed.
/// @throws InputError in one sentence that names the file, where possible the line, and the mend: no XML, another format,
///         not a tree, or what urdfdom refuses
urdf::ModelInterfaceSharedPtr read_document(const std::filesystem::path& file);

/// Throws InputError "file: sentence".
[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view sentence);

}  // namespace preshape::urdf_hand
