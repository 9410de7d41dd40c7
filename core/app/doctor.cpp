#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/base/installation.h"
#include "preshape/io/page.h"
#include "preshape/plugin/fingerprint.h"
#include "preshape/version.h"
#include "scene_files.h"

namespace preshape::app {

namespace {

/// Prints findings; counts those that need something done.
class Doctor {
 public:
  void good(const std::string& words) { fmt::print("  ok    {}\n", words); }
  void note(const std::string& words) { fmt::print("  note  {}\n", words); }
  void bad(const std::string& words, const std::string& mend) {
    fmt::print("  BAD   {}\n        {}\n", words, mend);
    ++bad_;
  }
  int bad_count() const { return bad_; }

 private:
  int bad_ = 0;
};

/// Components that a scenario takes when it names none, and the package that brings what they need.
struct Standard {
  const char *kind, *name, *package;
};
constexpr Standard kStandard[] = {
    {"contact", "salisbury_soft_finger", ""}, {"similarity", "tfvadi", ""}, {"similarity", "tfdist", ""},
    {"classifier", "mlp", ""},                {"collision", "fcl", "libfcl-dev"}, {"hand", "dh", ""},
    {"quality", "sta_manu", ""},              {"explorer", "beam", ""},     {"explorer", "exhaustive", ""}};

void examine_plugins(const Registry& registry, Doctor& doctor) {
  fmt::print("\nPlugins\n");
  for (const auto& folder : registry.folders()) {
    std::error_code error;
    const bool there = std::filesystem::is_directory(folder.path, error);
    if (there) doctor.good(fmt::format("folder {} ({})", folder.path.string(), folder.origin));
    else doctor.note(fmt::format("folder {} ({}) is not there", folder.path.string(), folder.origin));
  }
  for (const auto& library : registry.libraries()) {
    const std::string reasons = fmt::format("{}", fmt::join(library.reasons, "; "));
    if (library.status == LibraryRecord::Status::kRefused) doctor.bad(library.file.string() + " is refused", reasons);
    if (library.status == LibraryRecord::Status::kShadowed) doctor.note(library.file.string() + " is shadowed: " + reasons);
  }
  for (const auto& key : registry.components()) {
    try {
      doctor.good(fmt::format("{:<11} {:<24} {}", key.kind, key.name, registry.describe(key.kind, key.name).summary));
    } catch (const Error& problem) {
      doctor.bad(fmt::format("{} {}", key.kind, key.name), problem.what());
    }
  }
  for (const auto& standard : kStandard) {
    if (registry.has(standard.kind, standard.name)) continue;
    doctor.bad(fmt::format("the default {} '{}' is not there", standard.kind, standard.name),
               *standard.package ? fmt::format("install {} and build again, or choose another in the scenario", standard.package)
                                 : "build or install the shipped plugins");
  }
}

void examine_data(const Catalogue& catalogue, Doctor& doctor) {
  fmt::print("\nObjects, hands and scripts\n");
  for (const auto& root : catalogue.roots()) {
    std::error_code error;
    if (std::filesystem::is_directory(root, error)) doctor.good("folder " + root.string());
    else doctor.note("folder " + root.string() + " is not there");
  }
  const auto told = [&](const char* what, const std::vector<std::string>& names) {
    if (names.empty()) doctor.bad(fmt::format("no {} found", what), "set PRESHAPE_DATA_PATH to the folder that holds objects, hands and scripts");
    else doctor.good(fmt::format("{}: {}", what, fmt::join(names, ", ")));
  };
  told("objects", catalogue.objects());
  told("hands", catalogue.hands());
}

/// A build without the page is whole; a page that is there has to be usable.
void examine_page(const Catalogue& catalogue, Doctor& doctor) {
  fmt::print("\nPages (run --page)\n");
  const auto file = page_template(catalogue);
  if (file.empty()) {
    doctor.note("no page can be written: its template, page/template.html, is in none of the folders of objects; install node and "
                "npm and build again where the npm registry can be reached, or use --scene");
    return;
  }
  try {
    read_page_template(file);
    doctor.good("template " + file.string());
  } catch (const Error& problem) {
    doctor.bad(file.string(), fmt::format("{}; build it again, or take the file away", problem.what()));
  }
}

void examine_memory(Doctor& doctor) {
  fmt::print("\nMemory\n");
  const auto folder = user_folder();
  if (folder.empty()) {
    doctor.bad("there is no user folder", "set HOME or XDG_DATA_HOME, or give --memory FILE");
    return;
  }
  std::error_code error;
  const auto path = memory_path("default");
  if (!std::filesystem::exists(path, error)) {
    doctor.note(fmt::format("{} does not exist yet; the first run makes it", path.string()));
    return;
  }
  try {
    const Memory memory = Memory::open(path, Memory::Mode::kReadOnly);
    const auto faults = memory.integrity_faults();
    if (faults.empty()) doctor.good(fmt::format("{}: {} objects, {} samples", path.string(), memory.statistics().objects, memory.statistics().samples()));
    else doctor.bad(path.string() + " is damaged", fmt::format("{}", fmt::join(faults, "; ")));
  } catch (const Error& problem) {
    doctor.bad(path.string(), problem.what());
  }
}

}  // namespace

void add_doctor(CLI::App& root, Application& application) {
  CLI::App* verb = root.add_subcommand("doctor", "Say what is installed, found and loadable, and what to do about what is not");
  verb->callback([&application] {
    Doctor doctor;
    fmt::print("preshape {}\n  {}\n  library folder {}\n", PRESHAPE_VERSION_STRING, fingerprint_text(host_fingerprint()),
               library_folder().string());
    examine_plugins(application.registry(), doctor);
    examine_data(application.catalogue(), doctor);
    examine_page(application.catalogue(), doctor);
    examine_memory(doctor);
    fmt::print("\n{}\n", doctor.bad_count() == 0 ? "Nothing to mend." : fmt::format("{} to mend.", doctor.bad_count()));
    if (doctor.bad_count() > 0) application.exit_code = kOther;
  });
}

}  // namespace preshape::app
