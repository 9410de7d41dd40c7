#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "preshape/hand/hand_model.h"
#include "table.h"

namespace preshape::urdf_hand {

/// A finger as the hand's Lua file names it in the URDF.
struct FingerDescription {
  Table table;
  std::string name;
  FingerRole role = FingerRole::kIndex;
  std::string tip_link;
  Eigen::Vector3d p_LD = Eigen::Vector3d::Zero();  ///< the fingertip in the tip's link [m]
};

/// The Lua table beside a URDF.
struct Description {
  Table table;
  std::filesystem::path file;  ///< the URDF, which is there
  HandDimensions dimensions;
  std::string base_link;
  Pose X_LH;  ///< H in the base's link
  std::vector<FingerDescription> fingers;
};

/// Reads the table; the keys are explained in this plugin's README.
/// @throws InputError on the first mistake, and when the URDF is not there
Description read_description(const Value& table);

}  // namespace preshape::urdf_hand
