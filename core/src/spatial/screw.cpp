#include "preshape/spatial/screw.h"

#include <limits>

namespace preshape {

Screw poinsot_reduce(const Wrench& F_P, double couple_limit) {
  const double force = F_P.force().norm();
  const double moment = F_P.moment().norm();
  Screw screw;
  if (force > couple_limit * moment) {
    screw.magnitude = force;
    screw.direction = F_P.force() / force;
    screw.point = F_P.force().cross(F_P.moment()) / (force * force);
    screw.pitch = F_P.force().dot(F_P.moment()) / (force * force);
  } else if (moment > 0.0) {
    screw.magnitude = moment;
    screw.direction = F_P.moment() / moment;
    screw.pitch = std::numeric_limits<double>::infinity();
  }
  return screw;
}

}  // namespace preshape
