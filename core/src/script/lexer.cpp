#include "lexer.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace preshape::lua {

namespace {

constexpr std::array<std::string_view, 22> kKeywords = {
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

// Longest first.
constexpr std::array<std::string_view, 11> kLongSymbols = {
    "...", "..", "==", "~=", "<=", ">=", "//", "::", "<<", ">>", ""};

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c));
}

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    for (skip_blank(); at_ < source_.size(); skip_blank()) tokens.push_back(next());
    tokens.push_back({TokenKind::kEnd, {}, {}, source_.size(), line_});
    return tokens;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }

  /// One character on; "\r\n" and "\n\r" are one line end, as for Lua.
  void advance() {
    const char c = source_[at_++];
    if (c != '\n' && c != '\r') return;
    ++line_;
    if ((peek() == '\n' || peek() == '\r') && peek() != c) ++at_;
  }

  void advance_to(std::size_t end) {
    while (at_ < std::min(end, source_.size())) advance();
  }

  void skip_blank() {
    while (at_ < source_.size()) {
      if (std::isspace(static_cast<unsigned char>(peek()))) {
        advance();
      } else if (peek() == '-' && peek(1) == '-') {
        at_ += 2;
        if (const int level = long_bracket_level(); level >= 0) {
          skip_long_bracket(level);
        } else {
          while (at_ < source_.size() && peek() != '\n' && peek() != '\r') ++at_;
        }
      } else {
        return;
      }
    }
  }

  /// The number of '=' when a long bracket opens here, else -1.
  int long_bracket_level() const {
    if (peek() != '[') return -1;
    std::size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    return peek(1 + level) == '[' ? static_cast<int>(level) : -1;
  }

  /// Passes a long bracket and returns what is in it.
  std::string_view skip_long_bracket(int level) {
    std::string close(static_cast<std::size_t>(level) + 2, '=');
    close.front() = close.back() = ']';
    const std::size_t begin = at_ + close.size();
    const std::size_t end = std::min(source_.find(close, begin), source_.size());
    advance_to(end + close.size());
    return source_.substr(begin, end - begin);
  }

  std::string_view skip_quoted() {
    const char quote = peek();
    const std::size_t begin = ++at_;
    // A line end inside follows a backslash or "\z", so that only the escaped character needs care.
    while (at_ < source_.size() && peek() != quote) {
      if (peek() == '\\') ++at_;
      if (at_ < source_.size()) advance();
    }
    const std::size_t end = at_++;
    return source_.substr(begin, end - begin);
  }

  void skip_number() {
    const bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    while (is_name_character(peek()) || peek() == '.') {
      const char c = static_cast<char>(std::tolower(static_cast<unsigned char>(peek())));
      ++at_;
      if (c == (hexadecimal ? 'p' : 'e') && (peek() == '+' || peek() == '-')) ++at_;
    }
  }

  Token next() {
    Token token{TokenKind::kSymbol, {}, {}, at_, line_};
    const char c = peek();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      token.kind = TokenKind::kNumber;
      skip_number();
    } else if (is_name_character(c)) {
      while (is_name_character(peek())) ++at_;
      const bool keyword = std::find(kKeywords.begin(), kKeywords.end(),
                                     source_.substr(token.begin, at_ - token.begin)) != kKeywords.end();
      token.kind = keyword ? TokenKind::kKeyword : TokenKind::kName;
    } else if (c == '"' || c == '\'') {
      token.kind = TokenKind::kString;
      token.content = skip_quoted();
    } else if (const int level = long_bracket_level(); level >= 0) {
      token.kind = TokenKind::kString;
      token.content = skip_long_bracket(level);
    } else {
      const auto symbol = std::find_if(kLongSymbols.begin(), kLongSymbols.end(),
                                       [&](auto s) { return source_.substr(at_).starts_with(s); });
      at_ += std::max<std::size_t>(1, symbol->size());
    }
    token.text = source_.substr(token.begin, at_ - token.begin);
    return token;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
  return Lexer(source).run();
}

}  // namespace preshape::lua
