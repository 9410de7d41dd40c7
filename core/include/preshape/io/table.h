#pragma once

#include <string>
#include <vector>

#include "preshape/base/value.h"

namespace preshape {

/// Rows of numbers, texts and gaps (nil) under named columns.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

/// Aligned columns for a terminal, numbers with three decimals at most.
PRESHAPE_API std::string table_text(const Table& table);
/// RFC 4180, numbers with every digit that they need.
PRESHAPE_API std::string table_csv(const Table& table);

}  // namespace preshape
