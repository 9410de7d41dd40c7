#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace preshape::lua {

enum class TokenKind { kName, kKeyword, kString, kNumber, kSymbol, kEnd };

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string_view text;     ///< as written
  std::string_view content;  ///< of a string: between its quotes or brackets, escapes as written
  std::size_t begin = 0;     ///< offset in the source
  int line = 0;              ///< of its first character

  bool is(std::string_view other) const {
    return text == other && (kind == TokenKind::kSymbol || kind == TokenKind::kKeyword);
  }
};

/// The tokens of Lua 5.4 source that is known to compile, ended by one kEnd. They point into `source`.
std::vector<Token> tokens_of(std::string_view source);

}  // namespace preshape::lua
