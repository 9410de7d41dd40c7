#include "native_loader.h"

#include <cfenv>
#include <clocale>
#include <cstring>

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>
#include <fmt/format.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace preshape {

namespace {

/// State of the process that loading a library must not change.
class ProcessState {
 public:
  ProcessState() : locale_(std::setlocale(LC_ALL, nullptr)), control_(float_control()) {
    std::error_code ignored;
    folder_ = std::filesystem::current_path(ignored);
  }

  /// What differs now, put back; "" when nothing does.
  std::string restore() const {
    std::string changed;
    if (float_control() != control_) {
      set_float_control(control_);
      changed = "the floating-point mode (link it without -ffast-math)";
    }
    if (locale_ != std::setlocale(LC_ALL, nullptr)) {
      std::setlocale(LC_ALL, locale_.c_str());
      changed = "the locale";
    }
    std::error_code ignored;
    if (std::filesystem::current_path(ignored) != folder_) {
      std::filesystem::current_path(folder_, ignored);
      changed = "the working directory";
    }
    return changed;
  }

 private:
  // Only the control bits: the low six are sticky flags.
  static unsigned float_control() {
#if defined(__SSE__)
    return _mm_getcsr() & ~0x3fu;
#else
    return static_cast<unsigned>(std::fegetround());
#endif
  }
  static void set_float_control([[maybe_unused]] unsigned control) {
#if defined(__SSE__)
    _mm_setcsr(control);
#endif
  }

  std::string locale_;
  unsigned control_;
  std::filesystem::path folder_;
};

/// Boost wraps the loader's own words and ends with an unrelated errno; keep the loader's words.
std::string loader_reason(const std::string& text) {
  constexpr std::string_view kBegin = "dlerror system message: ";
  const auto begin = text.find(kBegin);
  if (begin == std::string::npos) return text;
  const auto end = text.rfind("): ");
  return text.substr(begin + kBegin.size(), end == std::string::npos ? end : end - begin - kBegin.size());
}

class NativeLibrary final : public ComponentLibrary, public std::enable_shared_from_this<NativeLibrary> {
 public:
  NativeLibrary(boost::dll::shared_library library, const PluginEntry& entry)
      : library_(std::move(library)), entry_(&entry) {
    std::uint32_t count = 0;
    const ComponentBinding* first = entry.components(&count);
    for (std::uint32_t i = 0; i < count; ++i) declarations_.push_back(first[i].declaration);
  }

  std::span<const ComponentDeclaration> components() const noexcept override { return declarations_; }

  std::shared_ptr<void> create(std::size_t number, const Parameters& parameters) const override {
    const auto index = static_cast<std::uint32_t>(number);
    char error[1024] = "";
    CreateError status = CreateError::kNone;
    void* object = entry_->create(index, &parameters, &status, error, sizeof error);
    if (!object && status == CreateError::kInput) throw InputError(error);
    if (!object) throw PluginError(error);
    return {object, [library = shared_from_this(), index](void* component) { library->entry_->destroy(index, component); }};
  }

 private:
  boost::dll::shared_library library_;
  const PluginEntry* entry_;
  std::vector<ComponentDeclaration> declarations_;  // copies: destroyed before the library is let go
};

const PluginEntry& checked_entry(const boost::dll::shared_library& library, const std::filesystem::path& file,
                                 const Manifest& manifest) {
  if (!library.has("preshape_entry")) {
    throw PluginError(fmt::format("plugin '{}' does not export 'preshape_entry'; end its source with PRESHAPE_PLUGIN",
                                  file.string()));
  }
  const auto& entry = library.get<const PluginEntry>("preshape_entry");
  if (entry.size < sizeof(PluginEntry) || !entry.manifest ||
      std::memcmp(entry.manifest, &manifest, sizeof(Manifest)) != 0) {
    throw PluginError(fmt::format("plugin '{}' has another manifest in memory than in its file; rebuild it",
                                  file.string()));
  }
  return entry;
}

void check_components(const ComponentLibrary& library, const std::filesystem::path& file, const Manifest& manifest) {
  const auto components = library.components();
  bool same = components.size() == manifest.component_count;
  for (std::size_t i = 0; same && i < components.size(); ++i) {
    const auto& d = components[i];
    same = fmt::format("{}/{}", d.kind, d.name) == manifest.components[i];
  }
  if (!same) {
    throw PluginError(fmt::format("plugin '{}' declares other components than its manifest lists; name the same in "
                                  "both parts of PRESHAPE_PLUGIN, in the same order",
                                  file.string()));
  }
}

}  // namespace

std::shared_ptr<const ComponentLibrary> NativeLoader::load(const std::filesystem::path& file,
                                                           const Manifest& manifest) const {
  const std::lock_guard lock(mutex_);
  const ProcessState before;
  boost::dll::shared_library library;
  try {
    library.load(std::filesystem::absolute(file), boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
  } catch (const std::exception& problem) {
    throw PluginError(fmt::format("plugin '{}' cannot be loaded: {}; install what it needs or rebuild it", file.string(),
                                  loader_reason(problem.what())));
  }
  if (const std::string changed = before.restore(); !changed.empty()) {
    throw PluginError(fmt::format("plugin '{}' changed {} when it was loaded; it was put back and the plugin refused",
                                  file.string(), changed));
  }
  const PluginEntry& entry = checked_entry(library, file, manifest);
  auto loaded = std::make_shared<NativeLibrary>(std::move(library), entry);
  check_components(*loaded, file, manifest);
  return loaded;
}

}  // namespace preshape
