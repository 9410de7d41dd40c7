#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "preshape/script/script.h"
#include "preshape/workbench/session.h"

namespace preshape {

/// What scripts see as `preshape`: they describe scenarios, or run them one after another (studies). The binding
/// checks, calls and converts; it decides nothing. Sessions are kept, so that a loop over tasks does not load
/// everything anew.
class PRESHAPE_API ScriptHost {
 public:
  struct Options {
    std::string memory;            ///< overrides every scenario's
    Progress* progress = nullptr;
  };

  /// Both must outlive it.
  ScriptHost(const Registry& registry, const Catalogue& catalogue, Options options);
  ~ScriptHost();

  /// Adds the functions and constants to a script, before it runs. The host must outlive the script's run.
  void add_to(Script& script);

 private:
  Session& session(const Value& description, const SourcePlace& caller);

  const Registry& registry_;
  const Catalogue& catalogue_;
  Options options_;
  std::map<std::string, std::unique_ptr<Session>> sessions_;
};

/// Where scripts look for modules and what they may use.
PRESHAPE_API ScriptOptions script_options(const Catalogue& catalogue, bool trust, std::uint64_t seed);

}  // namespace preshape
