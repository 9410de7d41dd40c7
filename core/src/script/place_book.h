#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "preshape/base/value.h"

namespace preshape::lua {

/// Where the entries of a table were written.
struct TablePlaces {
  SourcePlace place;
  std::map<std::string, SourcePlace, std::less<>> keys;
  std::vector<SourcePlace> items;
};

/// All that is known about where tables were written. A table of the Lua state refers to its page by number.
class PlaceBook {
 public:
  /// Adds the constructors of a file.
  /// @returns the file's source in which each constructor carries the number of its page
  std::string add_source(const std::string& file, std::string_view source);

  /// The page for a table made from a value that knows its places (the same page for the same places), or -1
  /// when it knows none.
  long page_of(const Value& value);

  /// nullptr when there is no such page.
  const TablePlaces* page(long number) const;

  /// The last line at which `file` writes this key of any table; unknown when it never does.
  SourcePlace last_key(const std::string& file, std::string_view key) const;

 private:
  std::vector<TablePlaces> pages_;
  std::unordered_map<std::string, long> pages_of_values_;
  std::map<std::string, std::map<std::string, int, std::less<>>> last_keys_;
};

}  // namespace preshape::lua
