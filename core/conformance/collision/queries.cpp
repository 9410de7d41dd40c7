#include "queries.h"

#include <cmath>

#include "preshape/base/error.h"

namespace preshape::conformance {

const CollisionScene& Scenes::of(const Body& body) {
  auto& scene = scenes_[static_cast<std::size_t>(&body - bodies().data())];
  if (!scene) scene = build(body.mesh);
  return *scene;
}

std::vector<Block> ray_blocks() {
  return {{"through", 3, -0.55, 0.55}, {"direction", 3, -1.0, 1.0}, {"way", 1, 0.0, 2.0}};
}

Ray ray_at(const Body& body, Case numbers) {
  const Eigen::Vector3d through(numbers[0], numbers[1], numbers[2]),
      along(numbers[3], numbers[4], numbers[5]);
  if (along.norm() < 1e-3) return {body.centre(), Eigen::Vector3d::Zero()};
  const Eigen::Vector3d direction = along.normalized();
  const Eigen::Vector3d place = body.centre() + through.cwiseProduct(bounding_box(body.mesh).extents());
  return {place - numbers[6] * body.extent() * direction, direction};
}

std::vector<Block> solid_blocks(const std::string& name) {
  return {{name + " kind", 1, 0, 2, {}, true},
          {name + " sizes", 3, 0.01, 0.4},
          {name + " turn", 4, -1.0, 1.0},
          {name + " place", 3, -1.0, 1.0}};
}

PosedSolid solid_at(Case numbers, const Eigen::Vector3d& centre, double size) {
  PosedSolid posed;
  posed.solid.kind = static_cast<Solid::Kind>(static_cast<int>(numbers[0]));
  posed.solid.radius = size * numbers[1];
  posed.solid.half_length = size * numbers[2];
  posed.solid.half_extents = size * Eigen::Vector3d(numbers[1], numbers[2], numbers[3]);
  const Eigen::Quaterniond turn(numbers[4], numbers[5], numbers[6], numbers[7]);
  if (turn.norm() > 1e-3) posed.X_OS.R = turn.normalized().toRotationMatrix();
  posed.X_OS.p = centre + size * Eigen::Vector3d(numbers[8], numbers[9], numbers[10]);
  return posed;
}

Block body_block() {
  return {"body", 1, 0, static_cast<double>(bodies().size() - 1), {}, true};
}

const Body& body_of(Case numbers) {
  return bodies()[static_cast<std::size_t>(numbers[0])];
}

std::string not_refused(const std::function<void()>& call, std::string* message) {
  try {
    call();
  } catch (const InputError& error) {
    if (message) *message = error.what();
    return "";
  } catch (const std::exception& error) {
    return fmt::format("it threw \"{}\", which is no InputError", error.what());
  }
  return "it was accepted";
}

}  // namespace preshape::conformance
