#pragma once

#include <memory>

#include "preshape/agent/environment_sensing.h"
#include "preshape/agent/preshape_analyser.h"
#include "support/registry.h"

namespace preshape::test {

/// A hand whose U is one sixth, so that L = 6U = 1 and lengths are normalised as they stand.
inline HandDimensions unit_hand() { return {1.0 / 6.0, 1.0 / 6.0, 4.0 / 6.0, 5.0 / 6.0}; }

/// The analysis with the thesis's models over the unit hand.
struct Analysis {
  ApproachPlanes planes = thesis_planes();
  AnalysisSettings settings;
  HandDimensions hand = unit_hand();
  std::shared_ptr<const CollisionBackend> collision = registry().create<CollisionBackend>("brute");
  std::shared_ptr<PreshapeAnalyser> analyser;

  /// @param contact parameters of salisbury_soft_finger
  explicit Analysis(const Value& contact = {}, AnalysisSettings s = {}, ApproachPlanes p = thesis_planes())
      : planes(std::move(p)), settings(s) {
    analyser = std::make_shared<PreshapeAnalyser>(
        PreshapeAnalyser::Models{registry().create<ContactModel>("salisbury_soft_finger", contact),
                                 {registry().create<QualityMeasure>("sta_manu")}},
        hand, planes, ApproachSymbols(FuzzyPartition::thesis(), settings.universe), settings);
  }

  std::shared_ptr<const SensedObject> sense(TriangleMesh mesh, const std::string& name = "test") const {
    RawObject raw;
    raw.name = raw.file = name;
    raw.file_faces = static_cast<std::int64_t>(mesh.triangles.size());
    raw.file_normals = 6;
    raw.unit_known = true;
    raw.topology = mesh_topology(mesh);
    raw.mesh = std::move(mesh);
    return EnvironmentSensing(collision, hand, planes, settings).sense(std::move(raw), {});
  }
};

}  // namespace preshape::test
