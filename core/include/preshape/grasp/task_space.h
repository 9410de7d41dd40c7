#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/grasp/task.h"

namespace preshape {

/// Magnitudes of the sample task space (thesis fig. 3.11).
inline constexpr double kTaskTranslation = 1.0, kTaskRotation = 0.8;
inline constexpr double kIdleTranslation = 0.1, kIdleRotation = 0.05;

/// The 24 sample tasks T<category>_<pair>, all signs positive. The categories are T1 pivot, T2 twiddle, T3 twiddle
/// along the approach alone, T4 pivot and twiddle; the pairs (approach, opposition) are 1 XZ, 2 XY, 3 YX, 4 YZ,
/// 5 ZX, 6 ZY. Five rows of the printed table break its own rule; the rule is followed.
PRESHAPE_API std::vector<Task> task_space();

/// The task space with every sign variant, 84 tasks: the name's signs are those of the approach and of the
/// opposition axis ("T1_2+-"); T3 has no opposition part and one sign ("T3_2-"). All-positive tasks carry no sign.
PRESHAPE_API std::vector<Task> signed_task_space();

/// A task by its name, with or without signs.
/// @throws InputError with the nearest name
PRESHAPE_API Task named_task(std::string_view name);

/// One sentence on a category ("T1") or a manipulation.
struct TaskKind {
  std::string name;
  std::string text;
};
PRESHAPE_API std::vector<TaskKind> task_categories();

/// Michelman's basic manipulations (thesis fig. 3.8) by name: translate_normal, translate_parallel, twiddle, pivot,
/// log_roll, y_roll.
PRESHAPE_API std::vector<TaskKind> manipulations();

/// A named manipulation about given axes.
/// @param approach, opposition "X", "+X" or "-X" and so on; two different axes
/// @throws InputError
PRESHAPE_API Task manipulation_task(std::string_view name, std::string_view approach, std::string_view opposition);

/// "+X" -> (0, +1), "-Z" -> (2, -1), "Y" -> (1, +1).
/// @throws InputError
struct SignedAxis {
  int axis = 0;
  int sign = 1;
};
PRESHAPE_API SignedAxis parse_axis(std::string_view text);

}  // namespace preshape
