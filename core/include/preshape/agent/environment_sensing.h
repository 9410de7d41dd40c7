#pragma once

#include <memory>
#include <vector>

#include "preshape/agent/settings.h"
#include "preshape/geometry/collision.h"
#include "preshape/geometry/object.h"
#include "preshape/geometry/section_profile.h"
#include "preshape/grasp/approach_plane.h"
#include "preshape/hand/hand_model.h"

namespace preshape {

/// An object as the agent perceives it: placed, with what the analysis asks of it again and again. Immutable.
struct SensedObject {
  Object object;
  ObjectAttributes attributes;
  double length_m = 0.0;                        ///< L
  std::shared_ptr<const CollisionScene> scene;  ///< mesh_O
  std::vector<SectionProfile> profiles;         ///< of each distinct approach axis
  std::vector<std::size_t> profile_of;          ///< per plane, index into profiles
  std::vector<double> half_extent_a_m;          ///< per plane: furthest |a . p|
  std::vector<double> half_extent_o_m;          ///< per plane: furthest |n_f . p|
};

/// The agent's senses (thesis sec. 3.1, "environment sensing element"): turns an object's file into what the
/// other parts work on.
class PRESHAPE_API EnvironmentSensing {
 public:
  EnvironmentSensing(std::shared_ptr<const CollisionBackend> collision, HandDimensions hand, ApproachPlanes planes,
                     AnalysisSettings settings);

  /// @throws InputError when the object cannot be placed
  std::shared_ptr<const SensedObject> sense(RawObject raw, const ObjectPlacement& placement) const;

 private:
  std::shared_ptr<const CollisionBackend> collision_;
  HandDimensions hand_;
  ApproachPlanes planes_;
  AnalysisSettings settings_;
};

}  // namespace preshape
