#include "preshape/io/report_text.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/simulation_text.h"
#include "preshape/agent/internal_critic.h"
#include "preshape/io/hand_notes.h"
#include "preshape/spatial/reciprocal.h"

namespace preshape {

namespace {

constexpr std::array<const char*, kComponents> kRows = {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
constexpr int kBar = 10;  // characters of a full bar

/// Writes the report line by line.
class Writer : private TextWriter {
 public:
  Writer(const RunRecord& record, const ReportTextOptions& options) : TextWriter(options.colour), record_(record), report_(record.report), options_(options) {}

  std::string quiet() {
    line("{}: {}, {} (mode {})", record_.object->object.name, task_text(report_.task), status_name(report_.status), report_.mode);
    line("{}", report_.verdict);
    if (report_.result) line("{}", preshape_line(*report_.result));
    if (record_.simulation) {
      line("carried out: {}{}{}", in_words(record_.simulation->status),
           record_.simulation->reason.empty() ? "" : ", ", record_.simulation->reason);
      write_second_try(*this, record_, other_line());
    }
    if (report_.nearest) line("nearest task that a grasp serves: {}", task_text(report_.nearest->task));
    return text();
  }

  std::string full() {
    asked();
    verdict();
    if (report_.result) {
      preshape(*report_.result);
      match(*report_.result);
    }
    if (record_.simulation) write_simulation(*this, record_, other_line());
    modes();
    others();
    if (report_.result) fuzzy(components(report_.result->grasp.resultant));
    object();
    hand();
    if (options_.timings) timings();
    return text();
  }

 private:
  std::string preshape_line(const JudgedGrasp& judged) const {
    const VirtualGrasp& grasp = judged.grasp;
    return words("plane {} ({}), x = {:+.2f} of the half extent, thumb and {} forefinger{}, {} {:.2f}",
                       grasp.plane + 1, plane_text(grasp), grasp.approach_fraction, grasp.virtual_fingers,
                       grasp.virtual_fingers == 1 ? "" : "s", record_.measure, judged.criticism.first);
  }

  /// Of what was carried out in the result's place.
  std::string other_line() const {
    return record_.second_try && record_.second_try->grasp ? preshape_line(*record_.second_try->grasp) : "";
  }

  std::string plane_text(const VirtualGrasp& grasp) const {
    return record_.planes[static_cast<std::size_t>(grasp.plane)].text();
  }

  void asked() {
    const auto& q = report_.task.screw;
    line("{}  object {}, hand {}, task {}", paint("1", "preshape"), record_.object->object.name, record_.hand,
         report_.task.name.empty() ? "given as numbers" : report_.task.name);
    line("  asked for      T = ({:.2f}, {:.2f}, {:.2f})   R = ({:.2f}, {:.2f}, {:.2f})", q[0], q[1], q[2], q[3], q[4], q[5]);
  }

  void verdict() {
    const char* colour = report_.served() ? "32" : report_.status == RunStatus::kRecognised ? "33" : "31";
    line("  {}   {}", paint(colour, fmt::format("{:<12}", status_name(report_.status))), wrapped(report_.verdict, 17));
  }

  void preshape(const JudgedGrasp& judged) {
    const VirtualGrasp& grasp = judged.grasp;
    const PreshapeTaxonomy names = taxonomy({judged.preshape.plane, judged.preshape.symbol, grasp.virtual_fingers});
    heading(report_.served() ? "Preshape" : "Best grasp that was tried (it does not serve the task)");
    line("  plane          {} ({})", grasp.plane + 1, plane_text(grasp));
    line("  approach       x = {:+.1f} mm = {:+.3f} L = {:+.2f} of the half extent, symbol {}", grasp.approach_m * 1e3,
         grasp.approach_m / record_.object->length_m, grasp.approach_fraction,
         record_.symbol_names[static_cast<std::size_t>(judged.preshape.symbol - 1)]);
    if (grasp.transverse_fraction != 0.0) {
      line("  transverse     {:+.2f} of the section's half width", grasp.transverse_fraction);
    }
    line("  fingers        {} (VF {}, dynamic depth {:.2f} U)", fmt::join(grasp.fingers, ", "), grasp.virtual_fingers,
         grasp.depth_m / record_.hand_dimensions.unit_length_m);
    line("  type           {}, {} grasp, {}", names.opposition, names.grasp, names.type);
    line("  opening        {:.1f} mm of at most {:.1f} mm{}", grasp.opening_m * 1e3,
         2e3 * record_.hand_dimensions.maximum_opening_m,
         grasp.opening_m > 2.0 * record_.hand_dimensions.maximum_opening_m ? paint("33", "  wider than its description says it opens") : "");
    for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
      const auto& C = grasp.contacts[i];
      line("  {:<14} at ({:+.1f}, {:+.1f}, {:+.1f}) mm, inward normal ({:+.2f}, {:+.2f}, {:+.2f})", grasp.fingers[i],
           C.p_OC.x() * 1e3, C.p_OC.y() * 1e3, C.p_OC.z() * 1e3, C.n.x(), C.n.y(), C.n.z());
    }
    const auto twists = reciprocal_twists(grasp.wrench_union);
    line("  stability      {:.0f} of 6, manipulability {:.0f} of 6, reciprocal twist space of dimension {}", grasp.stability,
         grasp.manipulability, twists.size());
    for (const auto& twist : twists) {
      line("    twist        v = ({:+.2f}, {:+.2f}, {:+.2f})  w = ({:+.2f}, {:+.2f}, {:+.2f})", twist.linear().x(),
           twist.linear().y(), twist.linear().z(), twist.angular().x(), twist.angular().y(), twist.angular().z());
    }
    for (std::size_t i = 0; i < grasp.quality.size(); ++i) {
      const auto& number = record_.quality_numbers[i];
      if (number.name == "stability" || number.name == "manipulability") continue;
      line("  {:<14} {:.4g}{}", number.name, grasp.quality[i], number.unit == "1" || number.unit == "-" ? "" : " " + number.unit);
    }
    if (std::isfinite(judged.confidence)) line("  confidence     {:.0f} % of the classifier", judged.confidence * 100);
  }

  void match(const JudgedGrasp& judged) {
    const auto& task = report_.task.screw;
    const auto wrench = components(judged.grasp.resultant);
    heading("How well the grasp's wrench matches the task");
    line("           task    wrench    {}", record_.measure);
    for (std::size_t i = 0; i < kComponents; ++i) {
      const double degree = judged.criticism.components[i];
      const double share = (degree - record_.scale.farthest / kComponents) /
                           ((record_.scale.nearest - record_.scale.farthest) / kComponents);
      line("  {}  {:8.2f}  {:8.2f}    {:5.2f}  {}", kRows[i], task[i], wrench[i], degree, bar(share));
    }
    line("  {} {:.2f} of {:.4g} (estimation threshold {:.2f}), {} {:.2f}", record_.measure, judged.criticism.first,
         record_.scale.nearest, report_.thresholds.estimation, record_.second_measure, judged.criticism.second);
  }

  std::string bar(double share) const {
    const int filled = std::clamp(static_cast<int>(std::lround(share * kBar)), 0, kBar);
    const std::string full(static_cast<std::size_t>(filled), '#'), rest(static_cast<std::size_t>(kBar - filled), '.');
    return paint(share >= 0.5 ? "32" : "31", full) + rest;
  }

  void modes() {
    heading("How it was decided");
    for (const auto& attempt : report_.attempts) {
      const double threshold = attempt.mode == 2 ? report_.thresholds.recognition : report_.thresholds.estimation;
      const bool reached = attempt.score && record_.scale.reaches(*attempt.score, threshold);
      const bool up = record_.scale.higher_is_nearer();
      const std::string score = attempt.score ? words("{:.2f} {} {:.2f}", *attempt.score,
                                                            reached ? (up ? ">=" : "<=") : (up ? "< " : "> "), threshold)
                                              : "no grasp";
      line("  mode {}  {:<13} {}", attempt.mode, score, wrapped(attempt.words, 24));
    }
    if (report_.lesson) {
      const auto& t = report_.lesson->training;
      line("  lesson  {} row{} added; training {} after {} epochs{} at a mean squared error of {:.2g}, {} rows wrong",
           report_.lesson->rows_added, report_.lesson->rows_added == 1 ? "" : "s",
           t.status == TrainingOutcome::Status::kArrived ? "arrived" : "stalled", t.epochs,
           t.restarts ? fmt::format(" and {} restarts", t.restarts) : "", t.mean_squared_error, t.wrong_rows);
    }
  }

  void others() {
    if (report_.unrecalled) {
      heading("A grasp that would serve the task, but is not recalled");
      line("  {}", preshape_line(*report_.unrecalled));
    }
    if (report_.served()) return;
    heading("Nearest task of the task space that a grasp of this object serves");
    if (!report_.nearest) {
      line("  none");
      return;
    }
    const auto& q = report_.nearest->task.screw;
    line("  {}  T = ({:.2f}, {:.2f}, {:.2f})  R = ({:.2f}, {:.2f}, {:.2f}), {} {:.2f} to the task asked", task_text(report_.nearest->task),
         q[0], q[1], q[2], q[3], q[4], q[5], record_.measure, report_.nearest->similarity);
    line("  {}", preshape_line(report_.nearest->grasp));
  }

  void fuzzy(const std::array<double, kComponents>& wrench) {
    heading("Fuzzy task                                       Fuzzy wrench");
    const auto names = [&] {
      std::string row;
      for (const auto& set : record_.partition.sets()) row += fmt::format("{:>6}", set.name.substr(0, 5));
      return row;
    };
    line("    {}   {}", names(), names());
    for (std::size_t i = 0; i < kComponents; ++i) {
      line("  {}{}   {}", kRows[i], degrees(report_.task.screw[i]), degrees(wrench[i]));
    }
  }

  std::string degrees(double x) const {
    std::vector<double> values(static_cast<std::size_t>(record_.partition.size()));
    record_.partition.fuzzify(x, values);
    std::string row;
    for (const double value : values) row += value == 0.0 ? "     ." : fmt::format("{:6.2f}", value);
    return row;
  }

  void object() {
    const SensedObject& sensed = *record_.object;
    const Eigen::Vector3d extents = sensed.object.box_O.extents();
    const double unit = record_.hand_dimensions.unit_length_m;
    heading("Object");
    line("  width {:.1f}, height {:.1f}, depth {:.1f} mm = {:.2f}, {:.2f}, {:.2f} U = {:.3f}, {:.3f}, {:.3f} L", extents.x() * 1e3,
         extents.y() * 1e3, extents.z() * 1e3, extents.x() / unit, extents.y() / unit, extents.z() / unit,
         sensed.attributes.width_normalised, sensed.attributes.height_normalised, sensed.attributes.depth_normalised);
    line("  {} triangles; per triangle {:.3f} vertices, {:.3f} normals, {:.3f} faces", sensed.object.mesh_O.triangles.size(),
         sensed.attributes.vertices_per_triangle, sensed.attributes.normals_per_triangle, sensed.attributes.faces_per_triangle);
    for (const auto& warning : sensed.object.warnings) line("  {}: {}", paint("33", "note"), warning);
  }

  /// Nothing but what was left out of its description: the hand itself is told by `preshape hand`.
  void hand() {
    if (!record_.hand_model) return;
    const auto notes = hand_notes_in_short(*record_.hand_model);
    if (notes.empty()) return;
    heading("Hand");
    for (const auto& note : notes) line("  {}: {}", paint("33", "note"), note);
    line("  What is left out cannot be seen to collide.");
  }

  void timings() {
    if (record_.timings.empty()) return;
    std::string parts;
    for (const auto& timing : record_.timings) {
      parts += fmt::format("{}{} {:.0f} ms", parts.empty() ? "" : ", ", timing.stage, timing.seconds * 1e3);
    }
    line("\n{}", paint("2", parts));
  }

  const RunRecord& record_;
  const Report& report_;
  ReportTextOptions options_;
};

}  // namespace

std::string report_text(const RunRecord& record, const ReportTextOptions& options) {
  Writer writer(record, options);
  return options.quiet ? writer.quiet() : writer.full();
}

}  // namespace preshape
