#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/agent/memory_csv.h"
#include "preshape/base/error.h"
#include "preshape/base/installation.h"
#include "preshape/base/suggest.h"
#include "preshape/io/table.h"

namespace preshape::app {

namespace {

struct MemoryOptions {
  std::string memory = "default";
  std::string file = "-";
  std::string what;
};

Memory open(const MemoryOptions& options, Memory::Mode mode) { return Memory::open(memory_path(options.memory), mode); }

void list_memories() {
  Table table;
  table.columns = {"memory", "objects", "samples", "sessions", "file"};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(user_folder() / "memories", error)) {
    if (entry.path().extension() != ".memory") continue;
    const auto statistics = Memory::open(entry.path(), Memory::Mode::kReadOnly).statistics();
    table.rows.push_back({entry.path().stem().string(), statistics.objects, statistics.samples(), statistics.sessions,
                          entry.path().string()});
  }
  if (table.rows.empty()) fmt::print("There is no memory in {}; 'preshape pretrain' makes one.\n", (user_folder() / "memories").string());
  else fmt::print("{}", table_text(table));
}

void show(const Memory& memory) {
  const auto s = memory.statistics();
  fmt::print("{}\n  {} objects, {} samples ({} pretraining, {} wrench, {} task), {} classifier states, {} sessions, {} bytes\n\n",
             memory.name(), s.objects, s.samples(), s.pretrain_samples, s.wrench_samples, s.task_samples, s.states, s.sessions, s.bytes);
  Table table;
  table.columns = {"object", "width_mm", "height_mm", "depth_mm", "kilotriangles", "samples", "hash"};
  for (const auto& object : memory.objects()) {
    table.rows.push_back({object.name, object.extents_m[0] * 1e3, object.extents_m[1] * 1e3, object.extents_m[2] * 1e3,
                          object.attributes.kilotriangles, static_cast<std::int64_t>(memory.samples_of(object.hash).size()),
                          object.hash.substr(0, 12)});
  }
  fmt::print("{}", table_text(table));
}

void forget(Memory& memory, const std::string& what) {
  std::vector<std::string> names;
  std::vector<std::string> hashes;
  for (const auto& object : memory.objects()) {
    names.push_back(object.name);
    if (object.name == what || (what.size() >= 6 && object.hash.starts_with(what))) hashes.push_back(object.hash);
  }
  if (hashes.empty()) throw InputError(fmt::format("memory '{}' holds no object '{}'{}", memory.name(), what, did_you_mean(what, names)));
  if (hashes.size() > 1) {
    throw InputError(fmt::format("memory '{}' holds {} objects '{}'; name one by the first digits of its hash (preshape memory show)",
                                 memory.name(), hashes.size(), what));
  }
  auto learning = memory.begin_learning();
  const Forgotten forgotten = learning.forget_object(hashes.front());
  learning.commit();
  fmt::print("forgot {}: {} samples, {} classifier states\n", what, forgotten.samples, forgotten.states);
}

CLI::App* add_verb(CLI::App& memory, const std::shared_ptr<MemoryOptions>& options, const char* name, const char* text) {
  CLI::App* verb = memory.add_subcommand(name, text);
  verb->add_option("--memory", options->memory, "memory: a name or a file")->type_name("NAME|FILE")->capture_default_str();
  return verb;
}

}  // namespace

void add_memory(CLI::App& root, Application&) {
  auto options = std::make_shared<MemoryOptions>();
  CLI::App* memory = root.add_subcommand("memory", "List, show, export, import or forget what was learned");
  memory->require_subcommand(1);
  memory->footer("Examples:\n  preshape memory show\n  preshape memory export --memory my.memory rows.csv\n  preshape memory forget mug");
  memory->add_subcommand("list", "The memories in the user's folder")->callback([] { list_memories(); });
  add_verb(*memory, options, "show", "What a memory holds")->callback([options] { show(open(*options, Memory::Mode::kReadOnly)); });

  CLI::App* exporting = add_verb(*memory, options, "export", "Write the samples as CSV");
  exporting->add_option("file", options->file, "file; - for standard output")->capture_default_str();
  exporting->callback([options] {
    std::ostringstream text;
    export_samples(open(*options, Memory::Mode::kReadOnly), text);
    if (options->file == "-") std::cout << text.str();
    else write_file(options->file, text.str());
  });

  CLI::App* importing = add_verb(*memory, options, "import", "Read samples from CSV, all or nothing");
  importing->add_option("file", options->file, "file")->required();
  importing->callback([options] {
    std::ifstream stream(options->file);
    if (!stream) throw InputError(fmt::format("'{}' cannot be read; name a CSV file that 'preshape memory export' wrote", options->file));
    Memory target = open(*options, Memory::Mode::kCreate);
    const auto before = target.statistics().samples();
    import_samples(target, stream, options->file);
    fmt::print("{}: {} samples imported\n", target.name(), target.statistics().samples() - before);
  });

  CLI::App* forgetting = add_verb(*memory, options, "forget", "Take an object out of a memory, with its samples");
  forgetting->add_option("object", options->what, "name, or the first digits of its hash")->required();
  forgetting->callback([options] {
    Memory target = open(*options, Memory::Mode::kReadWrite);
    forget(target, options->what);
  });
}

}  // namespace preshape::app
