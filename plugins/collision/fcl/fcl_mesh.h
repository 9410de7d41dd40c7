#pragma once

#include <new>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "preshape/geometry/triangle_mesh.h"

/// Fills a model with the named triangles, numbered by their place in `triangles`.
template <class Volume>
void fill(fcl::BVHModel<Volume>& model, preshape::TriangleMeshView mesh,
          const std::vector<std::int32_t>& triangles) {
  if (triangles.empty()) return;
  std::vector<fcl::Triangle> corners;
  for (const std::int32_t t : triangles) {
    const auto c = mesh.triangles[static_cast<std::size_t>(t)].cast<std::size_t>().eval();
    corners.emplace_back(c[0], c[1], c[2]);
  }
  const bool built =
      model.beginModel(static_cast<int>(corners.size()), static_cast<int>(mesh.vertices.size())) == fcl::BVH_OK &&
      model.addSubModel({mesh.vertices.begin(), mesh.vertices.end()}, corners) == fcl::BVH_OK &&
      model.endModel() == fcl::BVH_OK;
  if (!built) throw std::bad_alloc();  // FCL's only other reasons are calls out of order
}
