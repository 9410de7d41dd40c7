#pragma once

#include <array>
#include <string>

#include "preshape/fuzzy/pattern.h"

namespace preshape {

/// A manipulation task Q = [T; R]: a desired spatial displacement of the object about O, written as a screw and
/// compared one to one with a wrench in ray coordinates (thesis sec. 3.4, 3.8). No unit: 1 is a full primitive.
struct Task {
  std::array<double, kComponents> screw{};  ///< Tx, Ty, Tz, Rx, Ry, Rz
  double stability = 6.0;                   ///< wanted, 0..6
  double manipulability = 5.0;              ///< wanted, 0..6
  std::string name;                         ///< of the task space, or empty
};

/// "T1_2", or "(1, 1, 0.1, 0.05, 0.8, 0.05)" for a task without a name.
PRESHAPE_API std::string task_text(const Task& task);

}  // namespace preshape
