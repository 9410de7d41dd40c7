#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

namespace preshape::urdf_hand {

/// A URDF and where it is from.
struct Document {
  std::filesystem::path file;
  urdf::ModelInterfaceSharedPtr model;
  std::vector<std::string> notes;  ///< what urdfdom says of parts that it leaves out
};

/// Reads a URDF. Nothing is printed.
/// @throws InputError in one sentence that names the file, where possible the line, and the mend: no XML,
/// another format,
///         not a tree, or what urdfdom refuses
Document read_document(const std::filesystem::path& file);

/// Throws InputError "file: sentence".
[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view sentence);

}  // namespace preshape::urdf_hand
