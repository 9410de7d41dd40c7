#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

namespace preshape {

/// A number that is printed without a sign where only zeros are left of it: "-0.00" is no number to a reader.
struct Plain {
  double value;
};
inline Plain plain(double x) { return {x}; }
template <class T>
const T& plain(const T& x) {
  return x;
}
template <class T>
using Plained = std::conditional_t<std::is_same_v<std::remove_cvref_t<T>, double>, Plain, std::remove_cvref_t<T>>;

}  // namespace preshape

template <>
struct fmt::formatter<preshape::Plain> : fmt::formatter<double> {
  template <class Context>
  auto format(preshape::Plain number, Context& context) const {
    fmt::memory_buffer text;
    fmt::format_context trial(fmt::appender(text), {}, {});
    fmt::formatter<double>::format(number.value, trial);
    const std::string_view digits(text.data(), text.size());
    const bool zero = digits.find('-') != digits.npos && digits.find_first_of("123456789aefin") == digits.npos;
    return fmt::formatter<double>::format(zero ? 0.0 : number.value, context);
  }
};

namespace preshape {

/// Words broken at blanks so that no line is longer than a terminal of 100 columns; later lines begin at `indent`.
std::string wrapped(const std::string& words, std::size_t indent);

/// A text for a terminal, line by line.
class TextWriter {
 public:
  explicit TextWriter(bool colour) : colour_(colour) {}

  template <class... A>
  static std::string words(fmt::format_string<Plained<A>...> format, A&&... arguments) {
    const auto write = [&](const auto&... values) {
      return fmt::vformat(fmt::string_view(format), fmt::make_format_args(values...));
    };
    return write(plain(arguments)...);
  }
  template <class... A>
  void line(fmt::format_string<Plained<A>...> format, A&&... arguments) {
    text_ += words(format, std::forward<A>(arguments)...) + '\n';
  }
  void heading(std::string_view words) { line("\n{}", paint("1", words)); }

  /// Terminal colour, where it is wanted.
  std::string paint(std::string_view code, std::string_view words) const {
    return colour_ ? fmt::format("\x1b[{}m{}\x1b[0m", code, words) : std::string(words);
  }
  const std::string& text() const { return text_; }

 private:
  bool colour_;
  std::string text_;
};

}  // namespace preshape
