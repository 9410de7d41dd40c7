#pragma once

#include <stdexcept>
#include <string>

#include "preshape/base/export.h"

namespace preshape {

/// Root of every exception that preshape throws. An outcome ("no grasp found") is never an exception:
/// it is a status in the returned result. The message is one or more clear sentences: what is wrong, where
/// (file:line where known), the given value, and the mend.
class PRESHAPE_API Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
  ~Error() override;
};

/// Bad input from a file or a caller: an object, a hand, a task, a memory, a number out of its bounds.
class PRESHAPE_API InputError : public Error {
 public:
  using Error::Error;
  ~InputError() override;
};

/// A plugin that is absent, refused, or fails.
class PRESHAPE_API PluginError : public Error {
 public:
  using Error::Error;
  ~PluginError() override;
};

/// A mistake in a Lua script; the message carries file and line.
class PRESHAPE_API ScriptError : public Error {
 public:
  using Error::Error;
  ~ScriptError() override;
};

}  // namespace preshape
