#include "preshape/agent/settings.h"

namespace preshape {

using D = ParameterDeclaration;

const ParameterSchema& analysis_schema() {
  static const ParameterSchema schema(
      "analysis",
      {D::number("length", 6.0, 0.1, 100.0, "U", "characteristic length L by which lengths in wrenches are divided"),
       D::number("opposition_angle_deg", 45.0, 0.0, 90.0, "deg", "most deviation of opposed contact normals from exact opposition"),
       D::choice("virtual_fingers", "rule", {"rule", "any"}, "who decides the finger count: rules R1 to R3, or the search"),
       D::number("station_step", 0.05, 0.001, 0.5, "1", "step of the station grid, over the half extent along the approach axis"),
       D::list("transverse_offsets", {0.0}, -1.0, 1.0, "1", "places of the thumb that searches try, from the middle of the section over its half width"),
       D::number("ray_margin", 0.5, 0.0, 10.0, "U", "least distance of the opened fingertips from the object"),
       D::choice("universe", "half_extent", {"half_extent", "normalised"}, "what approach symbols are read over: the object's half extent, or L")});
  return schema;
}

AnalysisSettings AnalysisSettings::from(const Parameters& p) {
  AnalysisSettings s;
  s.length_U = p.number("length");
  s.opposition_angle_deg = p.number("opposition_angle_deg");
  s.free_virtual_fingers = p.text("virtual_fingers") == "any";
  s.station_step = p.number("station_step");
  s.transverse_offsets = p.numbers("transverse_offsets");
  s.ray_margin_U = p.number("ray_margin");
  s.universe = p.text("universe") == "half_extent" ? ApproachSymbols::Universe::kHalfExtent
                                                   : ApproachSymbols::Universe::kNormalised;
  return s;
}

const ParameterSchema& threshold_schema() {
  static const ParameterSchema schema(
      "thresholds",
      {D::number("estimation", 3.0, -1e9, 1e9, "of the measure", "similarity at which a grasp serves the task"),
       D::number("recognition", 5.5, -1e9, 1e9, "of the measure", "similarity at which a recalled pattern shows that the object is known"),
       D::number("search", 0.5, 0.0, 1.0, "1", "mode 1 searches |x - x0| <= (1 - search) * extent along the approach axis")});
  return schema;
}

Thresholds Thresholds::from(const Parameters& p) {
  return {p.number("estimation"), p.number("recognition"), p.number("search")};
}

const ParameterSchema& learning_schema() {
  static const ParameterSchema schema(
      "learning",
      {D::choice("policy", "ask", {"ask", "learn"}, "of a known object whose new task some grasp would serve: stop and ask, or learn it"),
       D::choice("teach", "both", {"wrench", "task", "both"}, "rows that a lesson adds: the grasp's own wrench, the task as asked, or both"),
       D::integer("budget", 20000, 1, 1e9, "stations", "most stations that one exploration evaluates")});
  return schema;
}

const ParameterSchema& execution_schema() {
  static const ParameterSchema schema(
      "execution",
      {D::integer("attempts", 4, 0, 1000, "stations", "next-best stations that are tried when the hand cannot carry out the first"),
       D::flag("reachable", false, "only grasps that the simulated hand carries out count, recalled or found"),
       D::choice("support", "none", {"none", "+X", "-X", "+Y", "-Y", "+Z", "-Z"}, "side of the object on which it stands")});
  return schema;
}

ExecutionSettings ExecutionSettings::from(const Parameters& p) {
  ExecutionSettings s;
  s.attempts = static_cast<int>(p.integer("attempts"));
  s.reachable = p.flag("reachable");
  const std::string& support = p.text("support");
  if (support == "none") return s;
  s.support_axis = support[1] - 'X';
  s.support_sign = support[0] == '-' ? -1.0 : 1.0;
  return s;
}

const ParameterSchema& exploration_schema() {
  static const ParameterSchema schema(
      "exploration", {D::integer("budget", 0, 0, 1e9, "stations", "most stations that one exploration evaluates; 0: learning.budget")});
  return schema;
}

LearningSettings LearningSettings::from(const Parameters& p) {
  LearningSettings s;
  s.policy = p.text("policy") == "ask" ? Policy::kAsk : Policy::kLearn;
  s.teach = p.text("teach") == "both" ? Teach::kBoth : p.text("teach") == "task" ? Teach::kTask : Teach::kWrench;
  s.budget = p.integer("budget");
  return s;
}

}  // namespace preshape
