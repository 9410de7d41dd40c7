#pragma once

#include <mutex>

#include "preshape/plugin/loader.h"

namespace preshape {

/// Shared objects with one exported symbol, preshape_entry. Loading one checks that the entry fits the
/// manifest read from the file, and that locale, working directory and floating-point mode are left as they
/// were.
class NativeLoader final : public ComponentLoader {
 public:
  std::string_view language() const noexcept override { return "C++"; }
  bool sandboxed() const noexcept override { return false; }
  bool claims(const std::filesystem::path& file) const override { return file.extension() == ".so"; }
  ManifestReading read(const std::filesystem::path& file) const override { return read_manifest(file); }
  std::shared_ptr<const ComponentLibrary> load(const std::filesystem::path& file,
                                               const Manifest& manifest) const override;

 private:
  mutable std::mutex mutex_;  ///< the state of the process is watched for one library at a time
};

}  // namespace preshape
