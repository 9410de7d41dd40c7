#pragma once

#include <limits>
#include <span>
#include <string>

#include "preshape/contact/contact_model.h"
#include "preshape/contact/wrench_union.h"
#include "preshape/grasp/joint_action.h"

namespace preshape {

/// A virtual grasp as a quality measure sees it; not owning, everything in O.
struct GraspView {
  std::span<const ContactFrame> contacts;  ///< thumb first
  std::span<const Wrench> F_C_O;           ///< pattern wrenches about their contacts
  const WrenchUnion& wrench_union;         ///< about O, lengths normalised
  const Wrench& resultant;                 ///< W_n about O, normalised
  double length_m;                         ///< characteristic length L
  const ContactModel* contact_model = nullptr;  ///< what made F_C_O (contact_limits says what it bears); null: not known
  Eigen::Vector3d approach_O = kNotKnown;       ///< unit: the way the hand comes
  Eigen::Vector3d opposition_O = kNotKnown;     ///< unit: the way the forefingers push
  std::span<const JointAction> joints = {};     ///< empty: the posture is not known

  static inline const Eigen::Vector3d kNotKnown = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// One number that a measure gives.
struct QualityNumber {
  std::string name;
  std::string unit = "-";
  double lowest = 0.0, highest = 0.0;  ///< range of its values
  bool higher_is_better = true;
};

/// Kind `quality`: numbers for a virtual grasp (thesis sec. 3.7). [any thread, const]
class PRESHAPE_API QualityMeasure {
 public:
  virtual ~QualityMeasure();
  /// What evaluate writes, in order; the first is the measure's own number.
  virtual std::span<const QualityNumber> numbers() const noexcept = 0;
  /// @param values numbers().size() values, overwritten
  virtual void evaluate(const GraspView& grasp, std::span<double> values) const = 0;
  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
