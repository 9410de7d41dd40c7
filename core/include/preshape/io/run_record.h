#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "preshape/agent/environment_sensing.h"
#include "preshape/agent/report.h"
#include "preshape/base/value.h"
#include "preshape/fuzzy/partition.h"
#include "preshape/grasp/approach_plane.h"
#include "preshape/grasp/imparted_twists.h"
#include "preshape/grasp/simulator.h"

namespace preshape {

/// A component as a run used it.
struct ComponentUse {
  std::string role;       ///< key of the scenario: contact, similarity, tie_break, ...
  std::string kind, name;
  Value parameters;       ///< resolved, defaults filled in
  std::string plugin, version, fingerprint;
};

/// Where the time of a run went [s].
struct Timing {
  std::string stage;
  double seconds = 0.0;
};

/// "reached", "unreachable", "collision", "too_few_fingers".
PRESHAPE_API std::string_view simulation_status_name(Simulation::Status status);

/// What became of the next-best stations when the hand could not carry out the first.
struct SecondTry {
  int attempts = 0;                  ///< stations that were tried
  std::optional<JudgedGrasp> grasp;  ///< the first of them that the hand carries out; it serves the task
  Simulation simulation;             ///< of `grasp`
  std::optional<ImpartedTwists> imparted = {};  ///< by the hand that holds it
};

/// A run with everything that is needed to run it again.
struct RunRecord {
  Report report;
  std::shared_ptr<const SensedObject> object;
  std::string scenario;  ///< file, as given
  Value description;     ///< the scenario with every default filled in
  std::vector<ComponentUse> components;
  std::string hand;      ///< name
  HandDimensions hand_dimensions;
  std::shared_ptr<const HandModel> hand_model;
  std::string memory;    ///< path, or "(in memory)"
  std::uint64_t seed = 1;
  FuzzyPartition partition;
  ApproachPlanes planes;
  std::vector<std::string> symbol_names;
  std::vector<QualityNumber> quality_numbers;
  SimilarityScale scale, second_scale;
  std::string measure, second_measure;  ///< names of the similarity measures
  std::optional<Simulation> simulation;  ///< of the report's result, where a simulator was asked
  std::optional<ImpartedTwists> imparted;  ///< by the hand, where the simulation ends in its holding the object
  std::optional<SecondTry> second_try;   ///< where the hand could not carry that out, and others were tried
  std::vector<Timing> timings;
};

}  // namespace preshape
