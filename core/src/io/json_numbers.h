#pragma once

#include <cmath>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace preshape {

using Json = nlohmann::ordered_json;  ///< members in the order in which they are written

/// A number, or null where JSON has none for it.
inline Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
inline Json vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace preshape
