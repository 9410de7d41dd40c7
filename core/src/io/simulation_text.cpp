#include "io/simulation_text.h"

#include <numbers>

#include "io/run_approach.h"

namespace preshape {

namespace {

constexpr std::size_t kIndent = 17;  ///< of what stands beside a name

std::string ordinal(int i) { return i == 1 ? "first" : i == 2 ? "second" : i == 3 ? "third" : fmt::format("{}th", i); }

void write_approach(TextWriter& out, const RunRecord& record, const VirtualGrasp& grasp) {
  const auto volume = approach_volume_of(record, grasp, *record.simulation);
  if (!volume) return;
  const double angle = volume->angle_to(record.planes[static_cast<std::size_t>(grasp.plane)].a) * 180.0 / std::numbers::pi;
  out.line("  open           approach volume {:.0f} cm3, entered {:.1f} degrees from the approach axis", 1e6 * volume->volume_m3, angle);
}

void write_imparted(TextWriter& out, const RunRecord& record, const ImpartedTwists& imparted) {
  out.line("  imparts        {} of 6 independent motions to the object, {:.0f} % of the task's among them", imparted.twists_O.size(),
           100.0 * share_of(imparted, record.report.task));
}

void write_fingers(TextWriter& out, const HandModel& hand, const Simulation& simulation) {
  for (const auto& outcome : simulation.fingers) {
    if (outcome.finger < 0) continue;  // no finger was free for the contact; the reason says so
    std::string limits;
    for (const int joint : outcome.at_limit) limits += (limits.empty() ? "" : ", ") + hand.joints()[static_cast<std::size_t>(joint)].name;
    out.line("  {:<14} {:.2f} mm from its contact{}", hand.fingers()[static_cast<std::size_t>(outcome.finger)].name, 1e3 * outcome.error_m,
             limits.empty() ? "" : ", at a limit: " + limits);
  }
}

std::string none_carried_out(const RunRecord& record) {
  const int attempts = record.second_try->attempts;
  if (attempts == 1) return "neither does it carry out the one other station that was tried";
  const Value* execution = record.description.find("execution");
  const Value* most = execution ? execution->find("attempts") : nullptr;
  const bool more = most && most->is_number() && attempts >= most->number();
  return fmt::format("neither does it carry out any of the next-best {} stations that were tried{}", attempts,
                     more ? "; execution.attempts lets it try more" : "");
}

}  // namespace

std::string_view in_words(Simulation::Status status) {
  return status == Simulation::Status::kTooFewFingers ? "refused" : simulation_status_name(status);
}

void write_simulation(TextWriter& out, const RunRecord& record, const std::string& other) {
  const Simulation& simulation = *record.simulation;
  const bool reached = simulation.status == Simulation::Status::kReached;
  out.heading("Carried out by the hand");
  out.line("  {} {}", out.paint(reached ? "32" : "33", fmt::format("{:<14}", in_words(simulation.status))),
           wrapped(reached ? fmt::format("fingertips within {:.2f} mm of their contacts", 1e3 * simulation.contact_error_m) : simulation.reason, kIndent));
  if (!simulation.path.empty()) {
    const Eigen::Vector3d p_mm = 1e3 * simulation.X_OH.p;
    out.line("  hand base      at ({:+.1f}, {:+.1f}, {:+.1f}) mm, {} postures on the way", p_mm.x(), p_mm.y(), p_mm.z(), simulation.path.size());
  }
  if (record.report.result) write_approach(out, record, record.report.result->grasp);
  if (record.imparted) write_imparted(out, record, *record.imparted);
  if (record.hand_model) write_fingers(out, *record.hand_model, simulation);
  write_second_try(out, record, other);
}

void write_second_try(TextWriter& out, const RunRecord& record, const std::string& other) {
  if (!record.second_try || record.second_try->attempts == 0) return;
  const SecondTry& tried = *record.second_try;
  const std::string words = tried.grasp ? fmt::format("the hand carries out another station that serves the task, the {} that was tried: {}",
                                                      ordinal(tried.attempts), other)
                                        : none_carried_out(record);
  out.line("  second try     {}", wrapped(words, kIndent));
  if (tried.imparted) write_imparted(out, record, *tried.imparted);
}

}  // namespace preshape
