#include <algorithm>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "hand_drawing.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/hand/inverse_kinematics.h"
#include "preshape/hand/manipulability.h"
#include "preshape/hand/workspace.h"
#include "preshape/io/hand_notes.h"
#include "preshape/io/table.h"

namespace preshape::app {

namespace {

constexpr double kDegree = 0.017453292519943295;

struct HandOptions {
  std::string hand, finger, csv, svg;
  std::vector<double> posture, at;
  int samples = 100000;
  double cell_mm = 5.0;
};

using Hand = std::shared_ptr<const HandModel>;

/// Degrees, or millimetres of a joint that slides.
double shown(const Joint& joint, double value) { return joint.prismatic ? 1e3 * value : value / kDegree; }
double taken(const Joint& joint, double value) { return joint.prismatic ? 1e-3 * value : value * kDegree; }

int finger_index(const HandModel& hand, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < hand.fingers().size(); ++i) {
    names.push_back(hand.fingers()[i].name);
    if (names.back() == name) return static_cast<int>(i);
  }
  throw InputError(fmt::format("the hand has no finger '{}'{}", name, did_you_mean(name, names)));
}

/// The fingers asked for: one, or all.
std::vector<int> fingers_of(const HandModel& hand, const std::string& name) {
  if (!name.empty()) return {finger_index(hand, name)};
  std::vector<int> all;
  for (int i = 0; i < static_cast<int>(hand.fingers().size()); ++i) all.push_back(i);
  return all;
}

void give(const HandOptions& options, const Table& table) {
  if (options.csv == "-") fmt::print("{}", table_csv(table));
  else if (!options.csv.empty()) write_file(options.csv, table_csv(table));
  else fmt::print("{}", table_text(table));
}

Table limits_table(const HandModel& hand) {
  Table table;
  table.columns = {"joint", "finger", "unit", "lower", "upper", "torque_limit", "follows", "ratio", "offset"};
  for (const Finger& finger : hand.fingers()) {
    for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j) {
      const Joint& joint = hand.joints()[static_cast<std::size_t>(j)];
      const bool follows = joint.leader >= 0;
      table.rows.push_back({joint.name, finger.name, joint.prismatic ? "mm" : "deg", shown(joint, joint.lower), shown(joint, joint.upper),
                            std::isnan(joint.torque_limit) ? Value{} : Value(joint.torque_limit),
                            follows ? Value(hand.joints()[static_cast<std::size_t>(joint.leader)].name) : Value{},
                            follows ? Value(joint.ratio) : Value{}, follows ? Value(shown(joint, joint.offset)) : Value{}});
    }
  }
  return table;
}

void limits(const HandModel& hand, const HandOptions& options) {
  give(options, limits_table(hand));
  if (!options.svg.empty()) write_file(options.svg, limits_svg(hand, options.hand + ", limits of its joints"));
}

/// A posture from what was given: a value for each drive, or for each joint; the middle of the ranges where none is.
Posture posture_of(const HandModel& hand, const std::vector<double>& given) {
  Posture posture = middle_posture(hand);
  if (given.empty()) return posture;
  const auto drives = driven_joints(hand);
  const auto joints = hand.joints();
  if (given.size() != drives.size() && given.size() != joints.size()) {
    throw InputError(fmt::format("--posture: the hand has {} joints, {} of them with a drive of their own; got {} numbers", joints.size(),
                                 drives.size(), given.size()));
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::size_t joint = given.size() == joints.size() ? i : static_cast<std::size_t>(drives[i]);
    posture[joint] = taken(joints[joint], given[i]);
  }
  apply_couplings(hand, posture);
  return posture;
}

void fk(const HandModel& hand, const HandOptions& options) {
  const Posture posture = posture_of(hand, options.posture);
  Table table;
  table.columns = {"finger", "frame", "x_mm", "y_mm", "z_mm", "zx", "zy", "zz"};
  for (const int finger : fingers_of(hand, options.finger)) {
    const auto poses = finger_poses(hand, finger, posture);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const std::string frame = k == 0 ? "base" : k + 1 == poses.size() ? "tip" : fmt::format("link {}", k);
      const Eigen::Vector3d p = 1e3 * poses[k].p, z = poses[k].R.col(2);
      table.rows.push_back({hand.fingers()[static_cast<std::size_t>(finger)].name, frame, p.x(), p.y(), p.z(), z.x(), z.y(), z.z()});
    }
  }
  give(options, table);
  if (!options.svg.empty())
    write_file(options.svg, posture_svg(hand, posture, fingers_of(hand, options.finger), options.hand + ", a posture", {}));
  if (!within_limits(hand, posture, 1e-9)) fmt::print(stderr, "note: the posture is beyond the limits of a joint\n");
}

int ik(const HandModel& hand, const HandOptions& options) {
  const int finger = finger_index(hand, options.finger);
  const FingertipTarget target{finger, 1e-3 * Eigen::Vector3d(options.at[0], options.at[1], options.at[2])};
  Random random(1);
  const auto solution = solve_fingertips(hand, {&target, 1}, middle_posture(hand), {.tolerance_m = 1e-7, .iterations = 100, .starts = 40}, random);
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  Table table;
  table.columns = {"joint", "unit", "value", "at_limit"};
  for (int j = about.first_joint; j < about.first_joint + about.joint_count; ++j) {
    const Joint& joint = hand.joints()[static_cast<std::size_t>(j)];
    const bool stopped = std::find(solution.at_limit.begin(), solution.at_limit.end(), j) != solution.at_limit.end();
    table.rows.push_back({joint.name, joint.prismatic ? "mm" : "deg", shown(joint, solution.posture[static_cast<std::size_t>(j)]), stopped ? "yes" : "no"});
  }
  give(options, table);
  if (!options.svg.empty()) {
    const auto words = fmt::format("{}, {} to {:g}, {:g}, {:g} mm: {}", options.hand, options.finger, options.at[0], options.at[1],
                                   options.at[2], solution.reached ? "reached" : "not reached");
    write_file(options.svg, posture_svg(hand, solution.posture, fingers_of(hand, {}), words, target.p_HD));
  }
  fmt::print(options.csv == "-" ? stderr : stdout, "{}: the fingertip is {:.3g} mm from there; manipulability {:.3g} cm3\n",
             solution.reached ? "reached" : "not reached", 1e3 * solution.residual_m,
             1e6 * manipulability(hand, finger, solution.posture).measure);
  return solution.reached ? kServed : kOther;
}

std::vector<FingerWorkspace> workspaces(const HandModel& hand, const HandOptions& options) {
  std::vector<FingerWorkspace> all;
  for (const int finger : fingers_of(hand, options.finger)) {
    Random random(1);
    all.push_back(finger_workspace(hand, finger, options.samples, 1e-3 * options.cell_mm, random));
  }
  return all;
}

void workspace(const HandModel& hand, const HandOptions& options) {
  const auto all = workspaces(hand, options);
  const auto fingers = fingers_of(hand, options.finger);
  if (!options.svg.empty()) write_file(options.svg, workspace_svg(hand, fingers, all, "Workspaces of " + options.hand));
  Table table;
  if (!options.csv.empty()) {  // every cell
    table.columns = {"finger", "x_mm", "y_mm", "z_mm"};
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const auto& p : all[i].cells_H) table.rows.push_back({hand.fingers()[static_cast<std::size_t>(fingers[i])].name, 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z()});
    }
    give(options, table);
    return;
  }
  table.columns = {"finger", "volume_cm3", "x_mm", "to", "y_mm", "to", "z_mm", "to"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Box& b = all[i].box_H;
    table.rows.push_back({hand.fingers()[static_cast<std::size_t>(fingers[i])].name, 1e6 * all[i].volume_m3(), 1e3 * b.lower.x(), 1e3 * b.upper.x(),
                          1e3 * b.lower.y(), 1e3 * b.upper.y(), 1e3 * b.lower.z(), 1e3 * b.upper.z()});
  }
  fmt::print("{}", table_text(table));
}

/// What a hand plugin left out of a file, such as meshes that are not there.
void tell_notes(const HandModel& hand) {
  for (const auto& note : hand_notes_in_short(hand)) fmt::print(stderr, "note: {}\n", note);
}

void overview(const HandModel& hand, const HandOptions& options) {
  tell_notes(hand);
  const auto& d = hand.dimensions();
  fmt::print("{}: {} fingers, {} joints, {} drives\n", options.hand, hand.fingers().size(), hand.joints().size(), driven_joints(hand).size());
  fmt::print("U {:.1f} mm, finger spacing {:.1f} mm, base {:.1f} mm wide, opens to {:.1f} mm from the middle of a grasp\n\n", 1e3 * d.unit_length_m,
             1e3 * d.finger_spacing_m, 1e3 * d.base_width_m, 1e3 * d.maximum_opening_m);
  fmt::print("{}\n", table_text(limits_table(hand)));
  const auto all = workspaces(hand, options);
  std::size_t thumb = all.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (hand.fingers()[i].role == FingerRole::kThumb) thumb = i;
  }
  Table table;
  table.columns = {"finger", "role", "length_mm", "workspace_cm3", "opposes_thumb_from_mm", "to_mm"};
  static constexpr const char* kRoles[] = {"thumb", "index", "middle", "ring", "little"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Finger& finger = hand.fingers()[i];
    const auto poses = finger_poses(hand, static_cast<int>(i), middle_posture(hand));
    double length = 0.0;
    for (std::size_t k = 1; k < poses.size(); ++k) length += (poses[k].p - poses[k - 1].p).norm();
    std::vector<Value> row = {finger.name, kRoles[static_cast<int>(finger.role)], 1e3 * length, 1e6 * all[i].volume_m3(), Value{}, Value{}};
    const OppositionRange range = i == thumb || thumb == all.size() ? OppositionRange{} : opposition_range(all[thumb], all[i]);
    if (range.opposed) row[4] = 1e3 * range.least_m, row[5] = 1e3 * range.most_m;
    table.rows.push_back(std::move(row));
  }
  fmt::print("{}", table_text(table));
}

}  // namespace

void add_hand(CLI::App& root, Application& application) {
  auto options = std::make_shared<HandOptions>();
  CLI::App* verb = root.add_subcommand("hand", "Look at a hand: joints, limits, kinematics, workspaces");
  verb->add_option("hand", options->hand, "a shipped hand, or a description file; the shipped hands when none is given")->type_name("NAME|FILE");
  const auto load = [options, &application]() -> Hand { return load_hand(Value(options->hand), {}, application.registry(), application.catalogue()); };
  const auto add = [&](const char* name, const char* text) {
    CLI::App* sub = verb->add_subcommand(name, text);
    sub->fallthrough();
    sub->add_option("--csv", options->csv, "write CSV with full precision to a file, - for standard output")->type_name("FILE");
    sub->add_option("--svg", options->svg, "also draw it to a file")->type_name("FILE");
    return sub;
  };
  add("limits", "joints with their limits and couplings")->callback([=] { limits(*load(), *options); });
  CLI::App* forward = add("fk", "poses of all links in the hand's frame");
  forward->add_option("--posture", options->posture, "a value for each drive or joint [deg or mm], commas between; the middle of the ranges when not given")->delimiter(',');
  forward->add_option("--finger", options->finger, "one finger only");
  forward->callback([=] { fk(*load(), *options); });
  CLI::App* inverse = add("ik", "joint values that bring a fingertip to a point; exit code 1 when none do");
  inverse->add_option("--finger", options->finger, "which")->required();
  inverse->add_option("--at", options->at, "x,y,z in the hand's frame [mm]")->delimiter(',')->expected(3)->required();
  inverse->callback([=, &application] { application.exit_code = ik(*load(), *options); });
  CLI::App* space = add("workspace", "volume and extent of what each fingertip can reach; with --csv every cell");
  space->add_option("--finger", options->finger, "one finger only");
  space->add_option("--samples", options->samples, "drawn postures")->check(CLI::Range(100, 100000000))->capture_default_str();
  space->add_option("--cell", options->cell_mm, "edge of a cell [mm]")->check(CLI::Range(0.5, 100.0))->capture_default_str();
  space->callback([=] { workspace(*load(), *options); });
  verb->footer("Examples:\n  preshape hand utah_mit\n  preshape hand utah_mit fk --finger index\n  preshape hand utah_mit ik --finger thumb --at 0,-30,100\n"
               "  preshape hand utah_mit workspace --svg workspace.svg");
  verb->callback([=, &application] {
    if (!verb->get_subcommands().empty()) return;
    if (!options->hand.empty()) return overview(*load(), *options);
    for (const auto& name : application.catalogue().hands()) fmt::print("{}\n", name);
  });
}

}  // namespace preshape::app
