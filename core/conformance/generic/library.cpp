// The library as a file and in memory.
#include <dlfcn.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>

#include <fmt/ranges.h>

#include "../allocation.h"
#include "elf_symbols.h"
#include "generic.h"
#include "preshape/base/error.h"
#include "preshape/plugin/entry.h"

namespace preshape::conformance {

namespace {

void require_native(Context& context) {
  if (!context.subject().native()) context.skip("a Lua component has no library");
}

bool is_mapped(const std::filesystem::path& file) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.ends_with(file.string())) return true;
  }
  return false;
}

/// Memory that the process has, but for what malloc keeps of freed blocks.
std::ptrdiff_t resident_bytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  std::ptrdiff_t pages = 0;
  statm >> pages >> pages;
  return pages * sysconf(_SC_PAGESIZE);
}

/// Bytes by which memory has grown: blocks that were not freed, and the process, which counts what was mapped past malloc
/// too, but by whole pages.
struct Growth {
  std::ptrdiff_t heap = std::numeric_limits<std::ptrdiff_t>::max(), resident = heap;

  Growth smaller(const Growth& other) const { return {std::min(heap, other.heap), std::min(resident, other.resident)}; }
  /// Whether it is more than what a component may lose itself (G22), or more pages than free blocks between those in use.
  bool told(int loads) const { return heap >= std::ptrdiff_t{1024} * loads || resident >= std::ptrdiff_t{128} << 10; }
};

class GrowthWatch {
 public:
  Growth growth() const {
    const std::ptrdiff_t heap = heap_.growth();
    return {heap, resident_bytes() - before_};
  }

 private:
  std::ptrdiff_t before_ = resident_bytes();
  HeapWatch heap_;
};

/// The library's table, loaded for the scope.
class Opened {
 public:
  explicit Opened(Context& context) : handle_(dlopen(context.subject().file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    context.require(handle_, "it cannot be loaded: {}", dlerror());
    entry_ = static_cast<const PluginEntry*>(dlsym(handle_, "preshape_entry"));
    if (!entry_) dlclose(handle_);
    context.require(entry_, "it exports no 'preshape_entry'");
  }
  ~Opened() { dlclose(handle_); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  const PluginEntry* operator->() const { return entry_; }

 private:
  void* handle_;
  const PluginEntry* entry_ = nullptr;
};

const std::vector<std::string>& unknown_ids() {
  static const std::vector<std::string> kIds = {"", "no.such.extension/1", "preshape.contact_limits/1x", std::string(4096, 'x')};
  return kIds;
}

}  // namespace

void g03_symbols(Context& context) {
  require_native(context);
  const DynamicTable table = dynamic_table(context.subject().file);
  context.require(table.exported == std::vector<std::string>{"preshape_entry"},
                  "it exports {} instead of 'preshape_entry' alone; build it with preshape_add_plugin",
                  fmt::join(std::span(table.exported).first(std::min<std::size_t>(table.exported.size(), 5)), ", "));
  context.require(table.unique.empty(), "it has unique symbols ({}), which pin it in memory; build it with preshape_add_plugin",
                  table.unique.empty() ? "" : table.unique.front());
  context.require(!table.text_relocations, "its code is relocated at load; compile it with -fPIC");
  for (const auto& folder : table.run_paths) {
    context.require(folder.empty() || folder.front() != '/', "it looks for libraries in '{}', a folder of this machine; use $ORIGIN", folder);
  }
}

void g04_needed_libraries(Context& context) {
  require_native(context);
  const DynamicTable table = dynamic_table(context.subject().file);
  const auto needs = [&](std::string_view part) {
    return std::any_of(table.needed.begin(), table.needed.end(), [&](const auto& n) { return n.find(part) != std::string::npos; });
  };
  for (const char* interpreter : {"liblua", "libpython"}) {
    context.require(!needs(interpreter), "it needs {}, of which one process can hold one only; leave it to the host", interpreter);
  }
  const bool uses_core = std::any_of(table.undefined.begin(), table.undefined.end(),
                                     [](const auto& symbol) { return symbol.find("8preshape") != std::string::npos; });
  context.require(!uses_core || needs("libpreshape_core"),
                  "it uses preshape's functions without naming libpreshape_core among its libraries; link preshape::core");
  context.record();  // loads it with every symbol bound
}

void g06_unknown_asked(Context& context) {
  const Subject& subject = context.subject();
  for (const std::string& name : {subject.name + " ", subject.name + "x", std::string(), std::string(4096, 'x')}) {
    bool refused = false;
    try {
      probe_of(subject.kind).create(context.registry(), name, {});
    } catch (const PluginError& error) {
      refused = *error.what() != '\0';
    }
    context.require(refused, "asked for '{}' it made a component", name.substr(0, 100));
  }
  const Specimen whole = specimen(context);
  for (const auto& id : unknown_ids()) {
    context.require(!whole.probe.extension(whole.component.get(), id.c_str()),
                    "it offers an extension '{}', which it cannot know", id.substr(0, 100));
  }
  if (!subject.native()) return;
  const Opened entry(context);
  for (const auto& id : unknown_ids()) {
    context.require(!entry->extension(id.c_str()), "the library offers an extension '{}'", id.substr(0, 100));
  }
  std::uint32_t count = 0;
  entry->components(&count);
  char text[200] = "";
  CreateError status = CreateError::kNone;
  const Parameters none;
  context.require(!entry->create(count, &none, &status, text, sizeof text) && *text,
                  "asked for component {} of {} it gave one, or no reason", count + 1, count);
}

void g23_unloads(Context& context) {
  require_native(context);
  const std::filesystem::path file = context.subject().file;
  const auto load = [&](int times) {
    for (int i = 0; i < times; ++i) {
      specimen(context);
      context.forget_registry();
      context.require(!is_mapped(file), "after {} loads it stays in memory when nothing of it is alive", i + 1);
    }
  };
  load(5);
  if (!allocations_watched()) return;  // a sanitizer keeps what is freed for a while
  const int times = context.cases(8);
  // A cache may still fill in one stretch; what is left behind grows in every one.
  Growth least;
  for (int stretch = 0; stretch < 3 && least.told(times); ++stretch) {
    const GrowthWatch watch;
    load(times);
    least = least.smaller(watch.growth());
  }
  context.require(!least.told(times), "over {} loads it leaves {} KiB that it allocated, and the process has grown by {} KiB", times,
                  least.heap >> 10, least.resident >> 10);
}

}  // namespace preshape::conformance
