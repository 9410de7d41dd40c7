// Distances of solids: B09 and B10.
#include <algorithm>
#include <cmath>

#include "queries.h"

namespace preshape::conformance {

void b09_distances_to_the_surface(Context& context) {
  Scenes scenes(context);
  auto blocks = solid_blocks();
  blocks.insert(blocks.begin(), body_block());
  blocks.push_back({"moved by", 3, -0.3, 0.3});
  context.for_all(blocks, context.cases(120), [&](Case c) -> std::string {
    const Body& body = body_of(c);
    const double size = std::max(body.extent(), 0.05);  // a hand's solids are not of micrometres
    const PosedSolid solid = solid_at(c.subspan(1), body.centre(), size);
    const double here = distance_one(scenes.of(body), solid);
    const std::string wrong =
        wrong_distance(here, surface_distance(body.mesh, solid), size + 1e-3 * body.centre().norm());
    if (!wrong.empty()) return fmt::format("{} ({})", wrong, body.name);
    PosedSolid shifted = solid;
    const Eigen::Vector3d step =
        size * Eigen::Vector3d(c[1 + kSolidNumbers], c[2 + kSolidNumbers], c[3 + kSolidNumbers]);
    shifted.X_OS.p += step;
    const double there = distance_one(scenes.of(body), shifted);
    if (std::abs(there - here) <= step.norm() + 2 * distance_slack(size)) return "";
    return fmt::format("moved by {} m a solid's distance goes from {} to {} ({})", step.norm(), here, there,
                       body.name);
  });
}

void b10_distances_of_pairs(Context& context) {
  const auto backend = context.create<CollisionBackend>();
  auto blocks = solid_blocks("first");
  for (const Block& block : solid_blocks("second")) blocks.push_back(block);
  blocks.push_back({"growth", 1, 0.0, 0.2});
  context.for_all(blocks, context.cases(600), [&](Case c) -> std::string {
    const PosedSolid a = solid_at(c, Eigen::Vector3d::Zero(), 1.0);
    const PosedSolid b = solid_at(c.subspan(kSolidNumbers), Eigen::Vector3d::Zero(), 1.0);
    const double ab = distance_one(*backend, a, b), ba = distance_one(*backend, b, a);
    if (std::string wrong = wrong_distance(ab, solid_distance(a, b), 1.0); !wrong.empty()) return wrong;
    if (!(std::abs(ab - ba) <= 2 * distance_slack(1.0)))
      return fmt::format("the distance is {}, with the solids exchanged {}", ab, ba);
    PosedSolid grown = a;
    grown.solid.radius += c.back();
    grown.solid.half_extents.array() += c.back();
    const double less = distance_one(*backend, grown, b);
    if (less <= ab + 2 * distance_slack(1.0)) return "";
    return fmt::format("grown by {} m on all sides a solid's distance goes from {} to {}", c.back(), ab,
                       less);
  });
}

}  // namespace preshape::conformance
