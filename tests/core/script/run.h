#pragma once

#include <fstream>
#include <string>
#include <utility>

#include "preshape/base/error.h"
#include "preshape/script/script.h"
#include "support/data.h"
#include "support/near.h"

namespace preshape::test {

/// The result of a script that is called scenario.lua in messages.
inline Value run_text(const std::string& text, ScriptOptions options = {}) {
  return Script::from_text(text, "scenario.lua", std::move(options)).run();
}

/// The message with which it fails, or "no error".
inline std::string error_of(const std::string& text, ScriptOptions options = {}) {
  try {
    run_text(text, std::move(options));
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "no error";
}

/// "file:line" of the entry that a dotted key leads to; numbers count items from 1.
inline std::string place_of(const Value& root, std::string_view key) {
  const Value* at = &root;
  for (std::size_t begin = 0; begin < key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    const std::string part(key.substr(begin, end - begin));
    at = at->is_list() ? &at->items().at(std::stoul(part) - 1) : at->find(part);
    if (!at) return "no '" + part + "'";
    begin = end + 1;
  }
  return at->place().text();
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

}  // namespace preshape::test
