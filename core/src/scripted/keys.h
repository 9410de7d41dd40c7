#pragma once

#include <string>
#include <vector>

#include "preshape/base/parameters.h"

namespace preshape::scripted {

/// The keys that a table of a component may have: data as declarations, functions by name, and keys that
/// whoever reads them checks. The table may be a list where it is empty.
struct Keys {
  std::string owner;  ///< what the table is, in messages
  std::vector<ParameterDeclaration> data;
  std::vector<std::string> functions;  ///< must be there
  std::vector<std::string> optional_functions;
  std::vector<std::string> others;

  /// The data with defaults filled in.
  /// @throws ScriptError with the first mistake: place, owner, key and the nearest right key
  Parameters check(const Value& table, const SourcePlace& place) const;
};

/// "file:line: owner: sentence" as a ScriptError.
[[noreturn]] void refuse(const SourcePlace& place, const std::string& owner, const std::string& sentence);

/// The place of a value, or else that of what encloses it.
const SourcePlace& place_of(const Value& value, const SourcePlace& enclosing);

/// Declarations with the defaults that the tables of components need.
ParameterDeclaration required_text(std::string name, std::string text);
ParameterDeclaration required_choice(std::string name, std::vector<std::string> choices, std::string text);
ParameterDeclaration required_number(std::string name, double minimum, double maximum, std::string unit,
                                     std::string text);
ParameterDeclaration required_table(std::string name, std::string text);
/// A table that may be left out; it is then empty.
ParameterDeclaration optional_table(std::string name, std::string text);

}  // namespace preshape::scripted
