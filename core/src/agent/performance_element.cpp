#include "preshape/agent/performance_element.h"

#include "preshape/base/error.h"

namespace preshape {

PerformanceElement::PerformanceElement(std::shared_ptr<const Classifier> classifier,
                                       std::shared_ptr<const PreshapeAnalyser> analyser)
    : classifier_(std::move(classifier)), analyser_(std::move(analyser)),
      code_(static_cast<int>(analyser_->planes().size()), analyser_->symbols().count()) {}

Performance PerformanceElement::perform(const SensedObject& object, const Task& task) const {
  if (!classifier_->trained()) throw InputError("the classifier has learned nothing yet; pretrain it first");
  const Features features = make_features(task.screw, task.stability, task.manipulability, object.attributes);
  const RowMatrix input = Eigen::Map<const RowMatrix>(features.data(), 1, kFeatures);
  RowMatrix bits(1, code_.bits());
  classifier_->predict(input, bits);
  const auto decoding = code_.decode(bits.row(0).transpose());
  return {decoding.preshape, decoding.confidence,
          analyser_->analyse(object, analyser_->station(object, decoding.preshape))};
}

}  // namespace preshape
