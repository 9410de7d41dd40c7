#include "preshape/grasp/task_space.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape {

namespace {

/// Which of the task's axes move: T and R of an axis share their sign (thesis fig. 3.11, note).
struct Motion {
  bool approach_translation = false, opposition_translation = false;
  bool approach_rotation = false, opposition_rotation = false, transverse_rotation = false;
};

Task make_task(std::string name, const Motion& motion, SignedAxis approach, SignedAxis opposition) {
  Task task;
  task.name = std::move(name);
  auto& q = task.screw;
  for (std::size_t i = 0; i < 3; ++i) q[i] = kIdleTranslation, q[i + 3] = kIdleRotation;
  const auto a = static_cast<std::size_t>(approach.axis), o = static_cast<std::size_t>(opposition.axis);
  if (motion.approach_translation) q[a] = approach.sign * kTaskTranslation;
  if (motion.opposition_translation) q[o] = opposition.sign * kTaskTranslation;
  if (motion.approach_rotation) q[a + 3] = approach.sign * kTaskRotation;
  if (motion.opposition_rotation) q[o + 3] = opposition.sign * kTaskRotation;
  if (motion.transverse_rotation) q[3 - a - o + 3] = kTaskRotation;
  return task;
}

struct Category {
  const char* text;
  Motion motion;
};

constexpr Category kCategories[] = {
    {"pivot: translate along approach and opposition, rotate about the opposition axis", {true, true, false, true, false}},
    {"twiddle: translate along approach and opposition, rotate about the approach axis", {true, true, true, false, false}},
    {"twiddle along the approach: translate along and rotate about the approach axis", {true, false, true, false, false}},
    {"pivot and twiddle: translate along and rotate about both axes", {true, true, true, true, false}},
};
constexpr int kPairs[6][2] = {{0, 2}, {0, 1}, {1, 0}, {1, 2}, {2, 0}, {2, 1}};  // (approach, opposition)

struct Manipulation {
  const char* name;
  const char* text;
  Motion motion;
};

constexpr Manipulation kManipulations[] = {
    {"translate_normal", "translate along the palm normal: along the approach axis", {true, false, false, false, false}},
    {"translate_parallel", "translate along the palm: along the opposition axis", {false, true, false, false, false}},
    {"log_roll", "roll between thumb and fingers: rotate about the transverse axis", {false, false, false, false, true}},
    {"twiddle", "rotate about the approach axis", {false, false, true, false, false}},
    {"pivot", "rotate about the opposition axis", {false, false, false, true, false}},
    {"y_roll", "roll with three fingers: rotate about approach and opposition", {false, false, true, true, false}},
};

Task space_task(int category, int pair, int approach_sign, int opposition_sign) {
  const bool t3 = category == 3;
  std::string name = fmt::format("T{}_{}", category, pair);
  if (approach_sign < 0 || opposition_sign < 0) {
    name += approach_sign < 0 ? '-' : '+';
    if (!t3) name += opposition_sign < 0 ? '-' : '+';
  }
  return make_task(std::move(name), kCategories[category - 1].motion, {kPairs[pair - 1][0], approach_sign},
                   {kPairs[pair - 1][1], opposition_sign});
}

}  // namespace

std::string task_text(const Task& task) {
  return task.name.empty() ? fmt::format("({})", fmt::join(task.screw, ", ")) : task.name;
}

std::vector<Task> task_space() {
  std::vector<Task> tasks;
  for (int category = 1; category <= 4; ++category) {
    for (int pair = 1; pair <= 6; ++pair) tasks.push_back(space_task(category, pair, 1, 1));
  }
  return tasks;
}

std::vector<Task> signed_task_space() {
  std::vector<Task> tasks;
  for (int category = 1; category <= 4; ++category) {
    for (int pair = 1; pair <= 6; ++pair) {
      for (const int approach : {1, -1}) {
        for (const int opposition : {1, -1}) {
          if (category == 3 && opposition < 0) continue;
          tasks.push_back(space_task(category, pair, approach, opposition));
        }
      }
    }
  }
  return tasks;
}

Task named_task(std::string_view name) {
  std::vector<std::string> names;
  for (const Task& task : signed_task_space()) {
    const bool plain = task.name.size() == 4;
    // A name may also say that its signs are positive.
    if (task.name == name || (plain && (name == task.name + "++" || (name == task.name + "+" && name[1] == '3')))) {
      return task;
    }
    if (plain) names.push_back(task.name);
  }
  throw InputError(fmt::format("there is no task '{}'{}", name, did_you_mean(name, names)));
}

std::vector<TaskKind> task_categories() {
  std::vector<TaskKind> kinds;
  for (int i = 0; i < 4; ++i) kinds.push_back({fmt::format("T{}", i + 1), kCategories[i].text});
  return kinds;
}

std::vector<TaskKind> manipulations() {
  std::vector<TaskKind> kinds;
  for (const auto& manipulation : kManipulations) kinds.push_back({manipulation.name, manipulation.text});
  return kinds;
}

Task manipulation_task(std::string_view name, std::string_view approach, std::string_view opposition) {
  std::vector<std::string> names;
  for (const auto& manipulation : kManipulations) {
    names.push_back(manipulation.name);
    if (name != manipulation.name) continue;
    const SignedAxis a = parse_axis(approach), o = parse_axis(opposition);
    if (a.axis == o.axis) throw InputError(fmt::format("approach and opposition must be different axes, both are {}", approach));
    return make_task(std::string(name), manipulation.motion, a, o);
  }
  throw InputError(fmt::format("there is no manipulation '{}'{}", name, did_you_mean(name, names)));
}

SignedAxis parse_axis(std::string_view text) {
  SignedAxis axis;
  std::string_view letter = text;
  if (!letter.empty() && (letter.front() == '+' || letter.front() == '-')) {
    axis.sign = letter.front() == '-' ? -1 : 1;
    letter.remove_prefix(1);
  }
  const auto index = std::string_view("XYZ").find(letter);
  if (letter.size() != 1 || index == std::string_view::npos) {
    throw InputError(fmt::format("'{}' is no axis; use X, Y or Z with an optional + or -", text));
  }
  axis.axis = static_cast<int>(index);
  return axis;
}

}  // namespace preshape
