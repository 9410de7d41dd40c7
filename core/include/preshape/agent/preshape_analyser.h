#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "preshape/agent/environment_sensing.h"
#include "preshape/agent/settings.h"
#include "preshape/contact/contact_model.h"
#include "preshape/grasp/approach_plane.h"
#include "preshape/grasp/approach_symbols.h"
#include "preshape/grasp/explorer.h"
#include "preshape/grasp/preshape.h"
#include "preshape/grasp/quality.h"
#include "preshape/grasp/virtual_grasp.h"
#include "preshape/hand/hand_model.h"

namespace preshape {

/// Second half of the performance element (spec sections 3 to 6): what closing the hand at a station would give.
/// [any thread, const]
class PRESHAPE_API PreshapeAnalyser {
 public:
  /// The models that it calls.
  struct Models {
    std::shared_ptr<const ContactModel> contact;
    std::vector<std::shared_ptr<const QualityMeasure>> quality;
  };

  /// @throws InputError when no quality measure gives both stability and manipulability, which the classifier reads
  PreshapeAnalyser(Models models, HandDimensions hand, ApproachPlanes planes, ApproachSymbols symbols,
                   AnalysisSettings settings);

  /// The grasps at some stations; `grasps` has the size of `stations`. With `measures` also the wrench union,
  /// stability, manipulability and quality numbers, which a search does not need.
  void analyse(const SensedObject& object, std::span<const Station> stations, std::span<VirtualGrasp> grasps,
               bool measures = true) const;
  VirtualGrasp analyse(const SensedObject& object, const Station& station) const;

  /// Wrench union, stability, manipulability and quality numbers of a grasp that has contacts and wrenches.
  /// @param length_m characteristic length; @param joints of the hand at the contacts, where a posture is known
  void measure(double length_m, VirtualGrasp& grasp, std::span<const JointAction> joints = {}) const;

  /// The station that a preshape names.
  Station station(const SensedObject& object, const Preshape& preshape) const;
  /// The preshape that names a grasp's station.
  Preshape preshape(const SensedObject& object, const VirtualGrasp& grasp) const;

  /// Names of all quality numbers, in the order of VirtualGrasp::quality.
  const std::vector<QualityNumber>& quality_numbers() const { return numbers_; }
  const ApproachPlanes& planes() const { return planes_; }
  const ApproachSymbols& symbols() const { return symbols_; }
  const AnalysisSettings& settings() const { return settings_; }
  const HandDimensions& hand() const { return hand_; }

 private:
  struct Fingers;
  Fingers place_fingers(const SensedObject& object, const Station& station, VirtualGrasp& grasp) const;
  void close_fingers(const SensedObject& object, std::span<const Ray> rays, std::span<const RayHit> hits,
                     VirtualGrasp& grasp) const;

  Models models_;
  HandDimensions hand_;
  ApproachPlanes planes_;
  ApproachSymbols symbols_;
  AnalysisSettings settings_;
  std::vector<QualityNumber> numbers_;
  std::size_t stability_ = 0, manipulability_ = 0;  ///< indices into numbers_
};

}  // namespace preshape
