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

/// Cuts a mesh with planes across one coordinate axis. Triangles are sorted by their lower end along that
/// axis once, so that a cut looks only at those that can meet the plane: the "dynamic depth" of an approach
/// station (spec section 3) costs a fraction of a pass over the mesh.
class PRESHAPE_API SectionProfile {
 public:
  /// @param axis 0, 1, 2: coordinate axis across which the planes lie
  /// The mesh must outlive the profile.
  SectionProfile(const TriangleMesh& mesh, int axis);

  /// The section with {p : p[axis] = station}, measured along `transverse` (another axis).
  SectionSpan cut(double station, int transverse) const;

 private:
  const TriangleMesh* mesh_;
  int axis_;
  std::vector<std::int32_t> order_;  ///< triangles by lower end
  std::vector<double> lower_;        ///< lower ends, in that order
  double longest_ = 0.0;             ///< longest triangle extent along the axis
};

}  // namespace preshape
