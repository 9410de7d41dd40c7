#include "description.h"

#include <algorithm>

#include <fmt/format.h>

namespace preshape::urdf_hand {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kRoles = {"thumb", "index", "middle", "ring", "little"};

std::vector<ParameterDeclaration> hand_keys() {
  auto unit = positive_length("unit_length", "U: length of the middle finger's middle phalanx");
  unit.maximum = 1.0;  // a hand in centimetres or millimetres
  auto base = ParameterDeclaration::description("base", "the link of the palm, and H in it");
  return {ParameterDeclaration::choice("model", "urdf", {"urdf"}, "the plugin that reads this table"),
          ParameterDeclaration::label("summary", "", "one line on the hand"),
          required_label("file", "the URDF, beside this file"),
          base,
          unit,
          positive_length("finger_spacing", "between neighbouring forefingers"),
          positive_length("maximum_opening", "from the middle of the grasp to an opened fingertip"),
          positive_length("base_width", "across the fingers"),
          ParameterDeclaration::description("fingers", "list of fingers")};
}

std::vector<ParameterDeclaration> finger_keys() {
  auto role = ParameterDeclaration::choice("role", "", kRoles, "thumb, index, middle, ring or little");
  role.default_value = Value{};
  return {required_label("name", "name of the finger"), role,
          ParameterDeclaration::description("tip",
                                            "the link that the finger ends with, and the fingertip in it")};
}

std::vector<ParameterDeclaration> base_keys() {
  return {required_label("link", "name of the palm's link"), point("position", "of H in the link"),
          roll_pitch_yaw("rotation", "of H in the link")};
}

std::vector<ParameterDeclaration> tip_keys() {
  return {required_label("link", "name of the last link"), point("position", "of the fingertip in the link")};
}

/// Beside the Lua file, or as it is given.
fs::path find_file(const Table& table) {
  const fs::path given = table.text("file");
  const fs::path beside = fs::path(table.place_of("file").file).parent_path() / given;
  std::error_code ignored;
  for (const fs::path& file : {beside, given}) {
    if (fs::is_regular_file(file, ignored)) return file;
  }
  table.refuse("file",
               fmt::format("names no file, got '{}'; it is looked for beside the hand's Lua file, here '{}'",
                           given.string(), beside.lexically_normal().string()));
}

std::string label_of(std::size_t index, const Value& table) {
  const Value* name = table.find("name");
  return name && name->is_string() ? fmt::format("finger {} '{}'", index + 1, name->string())
                                   : fmt::format("finger {}", index + 1);
}

FingerDescription read_finger(std::size_t index, const Value& given, const SourcePlace& place) {
  Table table(label_of(index, given), finger_keys(), given, place);
  const Table tip(table.owner() + ", tip", tip_keys(), table.given("tip"), table.place());
  const auto role = std::find(kRoles.begin(), kRoles.end(), table.text("role")) - kRoles.begin();
  std::string name = table.text("name");
  return {std::move(table), std::move(name), static_cast<FingerRole>(role), tip.text("link"),
          tip.vector("position")};
}

void demand_distinct(const std::vector<FingerDescription>& fingers) {
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (fingers[k].name == fingers[i].name) {
        fingers[i].table.refuse("name", fmt::format("'{}' is taken by another finger", fingers[i].name));
      }
      if (fingers[k].role == fingers[i].role) {
        fingers[i].table.refuse("role", fmt::format("'{}' is taken by finger '{}'",
                                                    fingers[i].table.text("role"), fingers[k].name));
      }
      if (fingers[k].tip_link == fingers[i].tip_link && fingers[k].p_LD == fingers[i].p_LD) {
        fingers[i].table.refuse("tip", fmt::format("is that of finger '{}'; name the link that ends this one",
                                                   fingers[k].name));
      }
    }
  }
}

}  // namespace

Description read_description(const Value& given) {
  Table table("hand description", hand_keys(), given, given.place());
  const Table base("hand description, base", base_keys(), table.given("base"), table.place());
  fs::path file = find_file(table);
  const HandDimensions dimensions{table.number("unit_length"), table.number("finger_spacing"),
                                  table.number("maximum_opening"), table.number("base_width")};
  std::vector<FingerDescription> fingers;
  for (const Value& finger : table.list("fingers"))
    fingers.push_back(read_finger(fingers.size(), finger, table.place()));
  if (fingers.empty()) table.refuse("fingers", "must have at least one finger");
  demand_distinct(fingers);
  return {std::move(table), std::move(file), dimensions, base.text("link"), base.pose(), std::move(fingers)};
}

}  // namespace preshape::urdf_hand
