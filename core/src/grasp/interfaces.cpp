// The out-of-line parts of the area's interfaces: one type information for every plugin.
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/explorer.h"
#include "preshape/grasp/quality.h"
#include "preshape/grasp/simulator.h"

namespace preshape {

Classifier::~Classifier() = default;
const void* Classifier::extension(const char*) const noexcept { return nullptr; }

ExplorationProblem::~ExplorationProblem() = default;
Explorer::~Explorer() = default;
const void* Explorer::extension(const char*) const noexcept { return nullptr; }

GraspSimulator::~GraspSimulator() = default;
const void* GraspSimulator::extension(const char*) const noexcept { return nullptr; }

QualityMeasure::~QualityMeasure() = default;
const void* QualityMeasure::extension(const char*) const noexcept { return nullptr; }

}  // namespace preshape
