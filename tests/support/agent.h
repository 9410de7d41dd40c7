#pragma once

#include <memory>
#include <string>

#include "preshape/agent/preshape_controller.h"
#include "preshape/grasp/task_space.h"
#include "preshape/io/object_reader.h"
#include "support/analysis.h"
#include "support/data.h"

namespace preshape::test {

/// The whole agent with real plugins over the unit hand.
struct Agent {
  struct Options {
    LearningSettings learning = {};
    Thresholds thresholds = {};
    AnalysisSettings analysis = {};
    std::uint64_t seed = 1;
    std::shared_ptr<Memory> memory = std::make_shared<Memory>(Memory::in_memory());
    const char* collision = "brute";
    ApproachPlanes planes = thesis_planes();
  };

  Options options;
  Analysis analysis;
  std::shared_ptr<Memory> memory;
  std::shared_ptr<Classifier> classifier = registry().create<Classifier>("mlp");
  std::shared_ptr<InternalCritic> critic;
  std::shared_ptr<LearningElement> learning;
  std::shared_ptr<PerformanceElement> performance;
  std::unique_ptr<PreshapeController> controller;

  Agent() : Agent(Options{}) {}
  explicit Agent(Options o) : options(std::move(o)), analysis({}, options.analysis, options.planes), memory(options.memory) {
    analysis.collision = registry().create<CollisionBackend>(options.collision);
    critic = std::make_shared<InternalCritic>(registry().create<Similarity>("tfvadi"), registry().create<Similarity>("tfdist"),
                                              FuzzyPartition::thesis(), options.thresholds);
    learning = std::make_shared<LearningElement>(parts());
    performance = std::make_shared<PerformanceElement>(classifier, analysis.analyser);
    controller = std::make_unique<PreshapeController>(performance, critic, learning);
  }

  LearningElement::Parts parts() const {
    return {memory, {"mlp", "{}", classifier}, {"beam", registry().create<Explorer>("beam")},
            {"exhaustive", registry().create<Explorer>("exhaustive")}, analysis.analyser, critic, options.learning, options.seed};
  }

  /// A shipped object, its lengths in U.
  std::shared_ptr<const SensedObject> shipped(const std::string& name) const {
    RawObject raw = read_object(source_file("objects/" + name + "/" + name + ".obj"));
    raw.name = name;
    ObjectPlacement placement;
    placement.unit = "U";
    return EnvironmentSensing(analysis.collision, analysis.hand, analysis.planes, analysis.settings).sense(std::move(raw), placement);
  }

  /// Learns the pretraining cube.
  LessonReport pretrain() { return learning->pretrain(*shipped("cube"), {}, nullptr); }

  bool serves(const JudgedGrasp& judged) const { return judged.grasp.is_grasp() && critic->serves(judged.criticism.first); }
};

}  // namespace preshape::test
