#include "io/text_writer.h"

#include <sstream>

namespace preshape {

std::string wrapped(const std::string& words, std::size_t indent) {
  std::string text, line;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > 100) {
      text += line + "\n" + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line;
}

}  // namespace preshape
