#include "preshape/geometry/mesh_repair.h"

#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {

std::string counted(std::int64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void check_mesh(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InputError("it has no triangles; give a mesh with faces");
  if (mesh.triangles.size() > kMostTriangles) {
    throw InputError(fmt::format("it has {} triangles, more than {}; reduce the mesh", mesh.triangles.size(),
                                 kMostTriangles));
  }
  for (const Eigen::Vector3d& p : mesh.vertices) {
    if (p.allFinite()) continue;
    throw InputError(fmt::format("it has a vertex at ({}, {}, {}), which is not finite; mend the mesh", p.x(),
                                 p.y(), p.z()));
  }
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) {
      if (v >= 0 && v < count) continue;
      throw InputError(fmt::format("triangle {} names vertex {}, but there are only {}; mend the mesh", t + 1,
                                   std::int64_t{v} + 1, count));
    }
  }
}

/// Scale for the tolerance; a box so large that its diagonal overflows is no object.
double checked_diagonal(const TriangleMesh& mesh) {
  const double diagonal = bounding_box(mesh).extents().norm();
  if (std::isfinite(diagonal)) return diagonal;
  throw InputError("its coordinates are too large to compute with; scale the mesh down");
}

void turn_inside_out(TriangleMesh& mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

void tell(MeshRepair& repair) {
  const MeshTopology& topology = repair.topology;
  auto& warnings = repair.warnings;
  if (const int count = repair.flat_triangles + repair.weld.collapsed_triangles; count > 0) {
    warnings.push_back(
        counted(count, "triangle without area was dropped", "triangles without area were dropped"));
  }
  if (repair.weld.duplicate_triangles > 0) {
    warnings.push_back(counted(repair.weld.duplicate_triangles, "triangle is there", "triangles are there") +
                       " more than once");
  }
  if (topology.open_edges > 0) {
    warnings.push_back("the surface is not closed: " +
                       counted(topology.open_edges, "open edge", "open edges"));
  }
  if (topology.non_manifold_edges > 0) {
    warnings.push_back(counted(topology.non_manifold_edges, "edge belongs", "edges belong") +
                       " to three or more triangles");
  }
  if (topology.inconsistent_edges > 0) {
    warnings.push_back("the faces do not all point the same way: neighbours disagree at " +
                       counted(topology.inconsistent_edges, "edge", "edges"));
  }
  if (topology.pieces > 1) warnings.push_back(fmt::format("the mesh is in {} pieces", topology.pieces));
  if (repair.turned) warnings.emplace_back("the faces pointed inwards; turned");
}

}  // namespace

MeshRepair repair_mesh(TriangleMesh& mesh, double weld_tolerance) {
  check_mesh(mesh);
  MeshRepair repair;
  repair.weld = weld(mesh, weld_tolerance * checked_diagonal(mesh));
  repair.topology = mesh_topology(mesh);
  repair.flat_triangles = drop_flat_triangles(mesh);
  if (mesh.triangles.empty())
    throw InputError("none of its triangles has an area; give a mesh with a surface");
  if (repair.topology.bounds_volume() && volume_properties(mesh).volume < 0.0) {
    turn_inside_out(mesh);
    repair.turned = true;
  }
  tell(repair);
  return repair;
}

}  // namespace preshape
