#include "preshape/io/report_text.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/run_approach.h"
#include "preshape/agent/internal_critic.h"
#include "preshape/io/hand_notes.h"
#include "preshape/spatial/reciprocal.h"

namespace preshape {

namespace {

/// A number that is printed without a sign where only zeros are left of it: "-0.00" is no number to a reader.
struct Plain {
  double value;
};
Plain plain(double x) { return {x}; }
template <class T>
const T& plain(const T& x) {
  return x;
}
template <class T>
using Plained = std::conditional_t<std::is_same_v<std::remove_cvref_t<T>, double>, Plain, std::remove_cvref_t<T>>;

}  // namespace

}  // namespace preshape

template <>
struct fmt::formatter<preshape::Plain> : fmt::formatter<double> {
  template <class Context>
  auto format(preshape::Plain number, Context& context) const {
    fmt::memory_buffer text;
    fmt::format_context trial(fmt::appender(text), {}, {});
    fmt::formatter<double>::format(number.value, trial);
    const std::string_view digits(text.data(), text.size());
    const bool zero = digits.find('-') != digits.npos && digits.find_first_of("123456789aefin") == digits.npos;
    return fmt::formatter<double>::format(zero ? 0.0 : number.value, context);
  }
};

namespace preshape {

namespace {

constexpr std::array<const char*, kComponents> kRows = {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
constexpr int kBar = 10;  // characters of a full bar
constexpr std::size_t kColumns = 100;

/// Words broken at blanks so that no line is longer than the terminal; later lines begin at `indent`.
std::string wrapped(const std::string& words, std::size_t indent) {
  std::string text, line;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kColumns) {
      text += line + "\n" + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line;
}

/// Writes the report line by line.
class Writer {
 public:
  Writer(const RunRecord& record, const ReportTextOptions& options) : record_(record), report_(record.report), options_(options) {}

  std::string quiet() {
    line("{}: {}, {} (mode {})", record_.object->object.name, task_text(report_.task), status_name(report_.status), report_.mode);
    line("{}", report_.verdict);
    if (report_.result) line("{}", preshape_line(*report_.result));
    if (record_.simulation) {
      line("carried out: {}{}{}", in_words(record_.simulation->status),
           record_.simulation->reason.empty() ? "" : ", ", record_.simulation->reason);
      if (record_.second_try) second_try(*record_.second_try);
    }
    if (report_.nearest) line("nearest task that a grasp serves: {}", task_text(report_.nearest->task));
    return text_;
  }

  std::string full() {
    asked();
    verdict();
    if (report_.result) {
      preshape(*report_.result);
      match(*report_.result);
    }
    if (record_.simulation) simulation(*record_.simulation);
    modes();
    others();
    if (report_.result) fuzzy(components(report_.result->grasp.resultant));
    object();
    hand();
    if (options_.timings) timings();
    return text_;
  }

 private:
  template <class... A>
  static std::string words(fmt::format_string<Plained<A>...> format, A&&... arguments) {
    const auto write = [&](const auto&... values) {
      return fmt::vformat(fmt::string_view(format), fmt::make_format_args(values...));
    };
    return write(plain(arguments)...);
  }
  template <class... A>
  void line(fmt::format_string<Plained<A>...> format, A&&... arguments) {
    text_ += words(format, std::forward<A>(arguments)...) + '\n';
  }

  void heading(std::string_view words) { line("\n{}", paint("1", words)); }

  /// Terminal colour, where it is wanted.
  std::string paint(std::string_view code, std::string_view words) const {
    return options_.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, words) : std::string(words);
  }

  std::string preshape_line(const JudgedGrasp& judged) const {
    const VirtualGrasp& grasp = judged.grasp;
    return words("plane {} ({}), x = {:+.2f} of the half extent, thumb and {} forefinger{}, {} {:.2f}",
                       grasp.plane + 1, plane_text(grasp), grasp.approach_fraction, grasp.virtual_fingers,
                       grasp.virtual_fingers == 1 ? "" : "s", record_.measure, judged.criticism.first);
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

  static std::string_view in_words(Simulation::Status status) {
    return status == Simulation::Status::kTooFewFingers ? "refused" : simulation_status_name(status);
  }

  void simulation(const Simulation& simulation) {
    heading("Carried out by the hand");
    const bool reached = simulation.status == Simulation::Status::kReached;
    line("  {} {}", paint(reached ? "32" : "33", fmt::format("{:<14}", in_words(simulation.status))),
         wrapped(reached ? fmt::format("fingertips within {:.2f} mm of their contacts", 1e3 * simulation.contact_error_m)
                         : simulation.reason, 17));
    if (!simulation.path.empty())
      line("  hand base      at ({:+.1f}, {:+.1f}, {:+.1f}) mm, {} postures on the way", simulation.X_OH.p.x() * 1e3,
           simulation.X_OH.p.y() * 1e3, simulation.X_OH.p.z() * 1e3, simulation.path.size());
    if (report_.result) approach(report_.result->grasp, simulation);
    if (record_.imparted) imparts(*record_.imparted);
    const auto joints = record_.hand_model ? record_.hand_model->joints() : std::span<const Joint>{};
    for (const auto& outcome : simulation.fingers) {
      if (outcome.finger < 0) continue;  // no finger was free for the contact; the reason says so
      std::string limits;
      for (const int joint : outcome.at_limit) limits += (limits.empty() ? "" : ", ") + joints[static_cast<std::size_t>(joint)].name;
      line("  {:<14} {:.2f} mm from its contact{}", record_.hand_model->fingers()[static_cast<std::size_t>(outcome.finger)].name,
           1e3 * outcome.error_m, limits.empty() ? "" : ", at a limit: " + limits);
    }
    if (record_.second_try) second_try(*record_.second_try);
  }

  void approach(const VirtualGrasp& grasp, const Simulation& simulation) {
    const auto volume = approach_volume_of(record_, grasp, simulation);
    if (!volume) return;
    const double angle =
        volume->angle_to(record_.planes[static_cast<std::size_t>(grasp.plane)].a) * 180.0 / std::numbers::pi;
    line("  open           approach volume {:.0f} cm3, entered {:.1f} degrees from the approach axis",
         1e6 * volume->volume_m3, angle);
  }

  void imparts(const ImpartedTwists& imparted) {
    line("  imparts        {} of 6 independent motions to the object, {:.0f} % of the task's among them", imparted.twists_O.size(),
         100.0 * share_of(imparted, report_.task));
  }

  void second_try(const SecondTry& other) {
    if (other.grasp) {
      line("  second try     {}", wrapped(fmt::format("the hand carries out another station that serves the task, the {} that was tried: {}",
                                                     ordinal(other.attempts), preshape_line(*other.grasp)), 17));
    } else if (other.attempts > 0) {
      const Value* execution = record_.description.find("execution");
      const Value* most = execution ? execution->find("attempts") : nullptr;
      const bool more = most && most->is_number() && other.attempts >= most->number();
      line("  second try     {}", wrapped(other.attempts == 1 ? std::string("neither does it carry out the one other station that was tried")
                                                     : fmt::format("neither does it carry out any of the next-best {} stations that were tried{}", other.attempts,
                                                                   more ? "; execution.attempts lets it try more" : ""), 17));
    }
  }

  static std::string ordinal(int i) { return i == 1 ? "first" : i == 2 ? "second" : i == 3 ? "third" : fmt::format("{}th", i); }

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
  std::string text_;
};

}  // namespace

std::string report_text(const RunRecord& record, const ReportTextOptions& options) {
  Writer writer(record, options);
  return options.quiet ? writer.quiet() : writer.full();
}

}  // namespace preshape
