#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "application.h"
#include "conformance/fresh_process.h"
#include "conformance/report.h"
#include "conformance/runner.h"
#include "preshape/base/error.h"
#include "preshape/script/setting.h"
#include "terminal.h"

namespace preshape::app {

namespace {

using namespace preshape::conformance;

struct ConformOptions {
  std::string what, kind, component, junit, json, markdown, tier = "quick";
  std::vector<std::string> only, settings;
  std::uint64_t seed = 1;
  int jobs = 0;
  bool all = false, in_process = false, quiet = false, answer = false, list = false;
};

/// By the manifests alone: the checks' processes shall find the library not loaded.
Subject subject_of(const Registry& registry, const ComponentKey& key) {
  const std::string wanted = key.kind + "/" + key.name;
  for (const auto& library : registry.libraries()) {
    if (library.status != LibraryRecord::Status::kUsable) continue;
    const auto& names = library.manifest.components;
    const auto* end = names + library.manifest.component_count;
    if (std::any_of(names, end, [&](const char* name) { return wanted == name; })) return {library.file, key.kind, key.name};
  }
  registry.describe(key.kind, key.name);  // says why there is none
  throw PluginError(fmt::format("there is no component '{}'", wanted));
}

/// What the person named: a file, a component's name, or everything.
std::vector<Subject> named_subjects(Application& application, const ConformOptions& options) {
  std::vector<Subject> subjects;
  if (options.all) {
    for (const auto& key : application.registry().components()) subjects.push_back(subject_of(application.registry(), key));
  } else if (options.what.find('/') != std::string::npos || std::filesystem::exists(options.what) ||
             options.what.ends_with(".so") || options.what.ends_with(".lua")) {
    const bool is_key = !std::filesystem::exists(options.what) && !options.what.ends_with(".so") && !options.what.ends_with(".lua");
    if (is_key) subjects = {subject_of(application.registry(), find_component(application.registry(), options.what))};
    else subjects = subjects_in(options.what);
  } else {
    subjects = {subject_of(application.registry(), find_component(application.registry(), options.what))};
  }
  std::erase_if(subjects, [&](const Subject& s) {
    return (!options.kind.empty() && s.kind != options.kind) || (!options.component.empty() && s.title() != options.component);
  });
  if (subjects.empty()) {
    throw InputError(fmt::format("'{}' has no component{}{}", options.all ? "--all" : options.what,
                                 options.kind.empty() ? "" : " of kind " + options.kind,
                                 options.component.empty() ? "" : " named " + options.component));
  }
  return subjects;
}

Plan plan_of(const ConformOptions& options) {
  Plan plan;
  plan.settings.seed = options.seed;
  plan.settings.tier = options.tier == "soak" ? Tier::kSoak : options.tier == "full" ? Tier::kFull : Tier::kQuick;
  plan.settings.command = std::filesystem::canonical("/proc/self/exe");
  for (const auto& text : options.settings) {
    const Setting setting = parse_setting(text);
    set_path(plan.settings.parameters, setting.key, setting.value);
  }
  plan.only = options.only;
  plan.in_process = options.in_process;
  plan.jobs = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return plan;
}

void list_checks() {
  for (const auto kind : {"", "contact", "similarity", "classifier", "collision", "hand", "quality", "explorer", "simulator"}) {
    for (const Check& check : *kind ? checks_of(kind) : generic_checks()) {
      fmt::print("{}  {:<10}  {}{}\n", check.id, *kind ? kind : "every kind", check.property,
                 *check.capability ? fmt::format(" (if it promises '{}')", check.capability) : "");
    }
  }
}

/// The hidden side of Context::in_fresh_process.
int answer(const ConformOptions& options, const Plan& plan) {
  const Subject subject = {options.what, options.component.substr(0, options.component.find('/')),
                           options.component.substr(options.component.find('/') + 1)};
  const auto checks = planned_checks(plan, subject.kind);
  if (checks.size() != 1 || !checks.front()->fresh) return kUsage;
  return answer_as_fresh_process(*checks.front(), subject, plan.settings);
}

int conform(Application& application, const ConformOptions& options) {
  const Plan plan = plan_of(options);
  if (options.answer) return answer(options, plan);
  const Value* description = plan.settings.parameters.find("description");
  if (description && description->is_string()) named_description(description->string());  // or says at once what is wrong
  std::vector<ComponentReport> reports;
  const ReportStyle style{output_takes_colour(), options.quiet};
  for (const Subject& subject : named_subjects(application, options)) {
    reports.push_back(run_suite(subject, plan));
    fmt::print("{}", component_text(reports.back(), plan, style));
    std::fflush(stdout);
  }
  if (reports.size() > 1) fmt::print("{}", summary_text(reports));
  if (!options.junit.empty()) write_file(options.junit, junit_text(reports, plan));
  if (!options.json.empty()) write_file(options.json, json_text(reports, plan));
  if (!options.markdown.empty()) write_file(options.markdown, markdown_text(reports));
  const bool all = std::all_of(reports.begin(), reports.end(), [](const auto& r) { return r.conforms(); });
  return all ? kServed : kBadInput;
}

}  // namespace

void add_conform(CLI::App& root, Application& application) {
  auto options = std::make_shared<ConformOptions>();
  CLI::App* verb = root.add_subcommand("conform", "Hold components to what their kind and they themselves promise");
  verb->add_option("what", options->what, "plugin library, Lua component, or name of a component")->type_name("LIB.so|SCRIPT.lua|NAME");
  verb->add_flag("--all", options->all, "every component on the search path");
  verb->add_option("--kind", options->kind, "components of that kind only")->type_name("KIND");
  verb->add_option("--component", options->component, "of a library with several, that one only")->type_name("KIND/NAME");
  verb->add_option("--only", options->only, "these checks only, such as S03,G09")->delimiter(',')->type_name("CHECK");
  verb->add_option("--tier", options->tier, "how thorough: quick (under 5 s a component), full, soak")
      ->check(CLI::IsMember({"quick", "full", "soak"}))->type_name("TIER");
  verb->add_option("--seed", options->seed, "of all random cases")->type_name("N");
  verb->add_option("--set", options->settings, "a parameter of the components, such as mu=0.4; may be repeated")->type_name("KEY=VALUE");
  verb->add_option("--jobs", options->jobs, "checks at once; 0: one a processor")->type_name("N");
  verb->add_option("--junit", options->junit, "also write the outcomes as JUnit XML")->type_name("FILE");
  verb->add_option("--json", options->json, "also write the outcomes as JSON")->type_name("FILE");
  verb->add_option("--markdown", options->markdown, "also write the outcomes as a table of checks and components")->type_name("FILE");
  verb->add_flag("--in-process", options->in_process, "run the checks in this process, for a debugger");
  verb->add_flag("--quiet,-q", options->quiet, "print what does not pass only");
  verb->add_flag("--list", options->list, "list the checks and end");
  verb->add_flag("--answer", options->answer, "")->group("");
  verb->footer("Exit code 0 when everything conforms, 5 when something does not.\nExamples:\n  preshape conform ./build/contact/mine.so\n"
               "  preshape conform cosine.plugin.lua --only S03 --seed 7\n  preshape conform --all --tier full --junit conform.xml");
  verb->callback([options, &application] {
    if (options->list) return list_checks();
    if (options->what.empty() != options->all) {
      throw CLI::ValidationError("conform", "name one library, script or component, or say --all");
    }
    application.exit_code = conform(application, *options);
  });
}

}  // namespace preshape::app
