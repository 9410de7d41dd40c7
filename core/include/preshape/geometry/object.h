#pragma once

#include <string>
#include <vector>

#include "preshape/base/parameters.h"
#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// A mesh as a file has it, in the file's axes and metres (or the file's bare numbers, see `unit_known`).
struct RawObject {
  std::string name;
  std::string file;
  TriangleMesh mesh;              ///< welded; flat triangles already dropped
  std::int64_t file_faces = 0;    ///< polygons as the file has them, before triangulation
  std::int64_t file_normals = 0;  ///< distinct vertex normals as the file has them (facet normals if none)
  bool unit_known = false;        ///< the format states its unit, so `mesh` is in metres
  MeshTopology topology;          ///< before flat triangles were dropped, see MeshRepair
  std::vector<std::string> warnings;
};

/// How an object is put into the hand's world. Declared as parameters, see `placement_schema`.
struct ObjectPlacement {
  std::string unit = "file";   ///< file, m, cm, mm, inch, U: what one unit of the mesh's numbers is
  double fit_U = 0.0;          ///< > 0: scale so that the largest extent is this many U, whatever the unit
  std::string frame = "file";  ///< file, principal, smallest_box
  std::string centre = "box";  ///< box, volume
};

/// The placement's parameters: unit, fit, frame, centre.
PRESHAPE_API const ParameterSchema& placement_schema();
PRESHAPE_API ObjectPlacement object_placement(const Parameters& parameters);

/// The attributes that the classifier reads (spec section 8), all without unit.
struct ObjectAttributes {
  double width_normalised = 0, height_normalised = 0, depth_normalised = 0;  ///< extents along X, Y, Z over L
  double vertices_per_triangle = 0, normals_per_triangle = 0, faces_per_triangle = 0;
  double kilotriangles = 0;  ///< number of triangles / 1000
};

/// An object ready for grasp analysis: origin at its centre, axes as the placement asks, in metres.
struct Object {
  std::string name;
  std::string file;
  std::string hash;     ///< SHA-256 of the placed mesh (see object_hash), lower-case hex
  TriangleMesh mesh_O;  ///< [m]
  Box box_O;            ///< [m]
  Eigen::Vector3d volume_centroid_O = Eigen::Vector3d::Zero();  ///< [m]; NaN when the mesh is not closed
  std::int64_t file_faces = 0, file_normals = 0;
  MeshTopology topology;
  double scale = 1.0;  ///< metres per unit of the file, as applied
  std::vector<std::string> warnings;

  /// @param length_m the characteristic length L [m]
  PRESHAPE_API ObjectAttributes attributes(double length_m) const;
};

/// Scales, turns and centres. Warns where the file states no unit, and where the volume centre is asked of a
/// mesh that is not closed: the box centre stands in for it.
/// @param raw of `repair_mesh`: finite, welded, with at least one triangle
/// @param unit_length_m the hand's U [m]
/// @throws InputError on a placement outside its schema, when U is not positive, when no triangle is left or
/// when
///         the extent is not finite, not positive or beyond 1e6 m
PRESHAPE_API Object place_object(RawObject raw, const ObjectPlacement& placement, double unit_length_m);

/// SHA-256 over vertices (each coordinate rounded to 1e-9 m, little-endian int64) and triangles: the same
/// content gives the same hash whatever its file is called.
PRESHAPE_API std::string object_hash(const TriangleMesh& mesh);

/// R_FO: axes of the smallest enclosing box ("smallest_box") or of inertia ("principal") of a mesh, in the
/// file's frame, right-handed, largest extent along X; signs chosen so that each axis' largest component is
/// positive (of X and Y; Z follows), which makes the choice repeatable. Ties (a cube) and round bodies
/// (between two spheres whose radii differ by less than 5 %) keep the file's axes.
PRESHAPE_API Eigen::Matrix3d principal_axes(const TriangleMesh& mesh);
PRESHAPE_API Eigen::Matrix3d smallest_box_axes(const TriangleMesh& mesh);

}  // namespace preshape
