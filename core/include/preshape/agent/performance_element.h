#pragma once

#include <memory>

#include "preshape/agent/preshape_analyser.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/features.h"

namespace preshape {

/// What the performance element answers: the preshape that the classifier recalls and the grasp that it gives.
struct Performance {
  Preshape preshape;
  double confidence = 0.0;
  VirtualGrasp grasp;
};

/// The agent's actual control unit (thesis sec. 3.1): classifier, then preshape analyser.
class PRESHAPE_API PerformanceElement {
 public:
  PerformanceElement(std::shared_ptr<const Classifier> classifier, std::shared_ptr<const PreshapeAnalyser> analyser);

  /// @throws InputError when the classifier is not trained
  Performance perform(const SensedObject& object, const Task& task) const;

  const PreshapeAnalyser& analyser() const { return *analyser_; }
  const PreshapeCode& code() const { return code_; }

 private:
  std::shared_ptr<const Classifier> classifier_;
  std::shared_ptr<const PreshapeAnalyser> analyser_;
  PreshapeCode code_;
};

}  // namespace preshape
