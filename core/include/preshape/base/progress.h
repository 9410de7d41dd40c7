#pragma once

#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

/// Told how far a long piece of work is. Implementations draw; they are called from one thread at a time.
class PRESHAPE_API Progress {
 public:
  virtual ~Progress();
  /// @param stage what is being done, in words; @param fraction 0..1, or negative when unknown
  virtual void advance(std::string_view stage, double fraction, std::string_view detail) = 0;
};

}  // namespace preshape
