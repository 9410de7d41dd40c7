#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/grasp/approach_plane.h"
#include "preshape/grasp/approach_symbols.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/features.h"
#include "preshape/grasp/preshape.h"
#include "preshape/grasp/task_space.h"
#include "preshape/grasp/virtual_fingers.h"
#include "support/registry.h"

namespace preshape::test {

/// Boxes (and what is grasped like its box) under the thesis's contact model, all lengths over L: enough of
/// the analysis to teach a classifier and to judge what it recalls.
struct LessonObject {
  Eigen::Vector3d size;
  double vertices = 2.0 / 3.0, normals = 0.5, faces = 1.0, kilotriangles = 0.012;

  ObjectAttributes attributes() const {
    return {size.x(), size.y(), size.z(), vertices, normals, faces, kilotriangles};
  }
};

inline LessonObject cube() {
  return {Eigen::Vector3d::Constant(1.0 / 3.0)};
}

inline constexpr double kUnit = 1.0 / 6.0;  ///< U over L
using Screw6 = std::array<double, kComponents>;

struct LessonGrasp {
  Preshape preshape;
  Screw6 wrench{};
  double score = -1.0;
};

/// @param plane 1..12; @param fraction of the half extent
inline LessonGrasp grasp_of(const LessonObject& object, int plane, double fraction) {
  static const ApproachPlanes planes = thesis_planes();
  static const ApproachSymbols symbols(FuzzyPartition::thesis(), ApproachSymbols::Universe::kHalfExtent);
  static const auto model = registry().create<ContactModel>("salisbury_soft_finger");
  const ApproachPlane& p = planes[static_cast<std::size_t>(plane) - 1];
  const auto extent = [&](const Eigen::Vector3d& axis) { return axis.cwiseAbs().dot(object.size); };
  const double half_extent = extent(p.a) / 2;
  const int fingers = ruled_virtual_fingers(extent(p.transverse), kUnit);
  const Eigen::Vector3d middle = fraction * half_extent * p.a, side = extent(p.n_f) / 2 * p.n_f;
  std::vector<ContactFrame> contacts = {ContactFrame::at(middle + side, -p.n_f, p.a)};
  for (const double place : forefinger_places(fingers, kUnit)) {
    contacts.push_back(ContactFrame::at(middle - side + place * p.transverse, p.n_f, p.a));
  }
  std::vector<Wrench> F_C_O(contacts.size());
  model->pattern_wrenches(contacts, F_C_O);
  Wrench W;
  for (std::size_t i = 0; i < contacts.size(); ++i) W += F_C_O[i].shifted(-contacts[i].p_OC);
  LessonGrasp grasp{{plane, symbols.symbol(fraction, half_extent, 1.0), fingers}, {}, -1.0};
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(grasp.wrench.data()) = W.vector();
  return grasp;
}

/// The best of the station grid in one plane (mode 1 with the widest window), by TFVADI.
inline LessonGrasp best_in_plane(const LessonObject& object, int plane, const Screw6& task) {
  static const FuzzyPartition partition = FuzzyPartition::thesis();
  static const auto measure = registry().create<Similarity>("tfvadi");
  const Patterns wanted(partition, task);
  LessonGrasp best;
  for (int k = -19; k <= 19; ++k) {
    LessonGrasp grasp = grasp_of(object, plane, k / 20.0);
    const Patterns pattern(partition, grasp.wrench);
    measure->compare(wanted.view(), pattern.view(), {&grasp.score, 1});
    if (grasp.score > best.score + 1e-9) best = grasp;
  }
  return best;
}

inline LessonGrasp best_of_all(const LessonObject& object, const Screw6& task) {
  LessonGrasp best;
  for (int plane = 1; plane <= 12; ++plane) {
    const LessonGrasp grasp = best_in_plane(object, plane, task);
    if (grasp.score > best.score + 1e-9) best = grasp;
  }
  return best;
}

struct LessonRow {
  Features inputs;
  Preshape preshape;
};

inline LessonRow task_row(const LessonObject& object, const Screw6& task, const Preshape& preshape) {
  return {make_features(task, 6.0, 5.0, object.attributes()), preshape};
}

inline LessonRow wrench_row(const LessonObject& object, const LessonGrasp& grasp) {
  const double manipulability = static_cast<double>(
      std::count_if(grasp.wrench.begin(), grasp.wrench.end(), [](double c) { return std::abs(c) >= 0.1; }));
  return {make_features(grasp.wrench, 6.0, manipulability, object.attributes()), grasp.preshape};
}

/// The pretraining set: two stations on each plane (spec section 8).
inline std::vector<LessonRow> pretraining(const LessonObject& object = cube()) {
  std::vector<LessonRow> rows;
  for (int plane = 1; plane <= 12; ++plane) {
    for (const double fraction : {-0.25, 0.25})
      rows.push_back(wrench_row(object, grasp_of(object, plane, fraction)));
  }
  return rows;
}

struct LessonMatrices {
  RowMatrix inputs, targets;
};

inline LessonMatrices matrices(const std::vector<LessonRow>& rows) {
  const PreshapeCode code(12, 7);
  const auto count = static_cast<Eigen::Index>(rows.size());
  LessonMatrices m{RowMatrix(count, kFeatures), RowMatrix(count, code.bits())};
  for (Eigen::Index r = 0; r < count; ++r) {
    const LessonRow& row = rows[static_cast<std::size_t>(r)];
    m.inputs.row(r) = Eigen::Map<const Eigen::RowVectorXd>(row.inputs.data(), kFeatures);
    m.targets.row(r) = code.encode(row.preshape).transpose();
  }
  return m;
}

/// What the classifier recalls.
inline Preshape recall(const Classifier& classifier, const Features& inputs) {
  const PreshapeCode code(12, 7);
  const RowMatrix question = Eigen::Map<const RowMatrix>(inputs.data(), 1, kFeatures);
  RowMatrix bits(1, code.bits());
  classifier.predict(question, bits);
  return code.decode(bits.row(0).transpose()).preshape;
}

}  // namespace preshape::test
