#pragma once

#include <Eigen/Core>

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// Extent of a plane section along one axis.
struct SectionSpan {
  bool empty = true;
  double lower = 0.0, upper = 0.0;  ///< along the asked axis, in the mesh's unit
  double width() const { return empty ? 0.0 : upper - lower; }
  double middle() const { return 0.5 * (lower + upper); }
};

/// Cuts a mesh with planes across one axis. Triangles are sorted by their lower end along that
/// axis once, so that a cut looks only at those that can meet the plane: the "dynamic depth" of an approach
/// station (spec section 3) costs a fraction of a pass over the mesh.
class PRESHAPE_API SectionProfile {
 public:
  /// @param axis unit vector across which the planes lie, in the mesh's frame
  /// The mesh must outlive the profile.
  SectionProfile(const TriangleMesh& mesh, const Eigen::Vector3d& axis);

  /// The section with {p : axis . p = station}, measured along the unit vector `transverse`.
  SectionSpan cut(double station, const Eigen::Vector3d& transverse) const;

 private:
  const TriangleMesh* mesh_;
  std::vector<double> heights_;      ///< of the vertices along the axis
  std::vector<std::int32_t> order_;  ///< triangles by lower end
  std::vector<double> lower_;        ///< lower ends, in that order
  double longest_ = 0.0;             ///< longest triangle extent along the axis
};

}  // namespace preshape
