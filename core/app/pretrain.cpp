#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "terminal.h"

namespace preshape::app {

void add_pretrain(CLI::App& root, Application& application) {
  auto options = std::make_shared<ScenarioOptions>();
  CLI::App* verb = root.add_subcommand("pretrain", "Teach a memory its first object (scripts/pretrain/cube.lua unless a script is given)");
  options->add_to(*verb, false);
  verb->footer("Examples:\n  preshape pretrain --memory my.memory\n  preshape pretrain --set classifier.trainer=backprop --memory bp.memory");
  verb->callback([options, &application] {
    if (options->script.empty()) options->script = application.catalogue().script("pretrain/cube.lua").string();
    TerminalProgress progress(false);
    const ScriptRun run = run_script(application, *options, &progress);
    Session session(checked_scenario(application, run.result, options->script, ScenarioUse::kPretrain), application.registry(),
                    application.catalogue(), {options->memory, &progress, nullptr});
    const LessonReport lesson = session.pretrain();
    const TrainingOutcome& t = lesson.training;
    const auto status = session.memory().statistics();
    fmt::print("{}: {} of {} stations taught on the {}, {} new rows; training {} after {} epochs{} at a mean squared error of "
               "{:.2g}, {} rows wrong\n",
               session.memory().name(), status.pretrain_samples, lesson.evaluations, session.object().object.name, lesson.rows_added,
               t.status == TrainingOutcome::Status::kArrived ? "arrived" : "stalled", t.epochs,
               t.restarts ? fmt::format(" and {} restarts", t.restarts) : "", t.mean_squared_error, t.wrong_rows);
    if (t.status != TrainingOutcome::Status::kArrived) application.exit_code = kOther;
  });
}

}  // namespace preshape::app
