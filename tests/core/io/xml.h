#pragma once

#include <regex>
#include <string>
#include <vector>

namespace preshape::test {

/// "" when every tag is closed in order and no mark of XML's grammar stands bare; else what is wrong.
inline std::string xml_fault(const std::string& text) {
  static const std::regex tag(R"rx(<(/?)([a-z]+)((?: [-a-zA-Z0-9:]+="[^"<>]*")*)(/?)>)rx");
  static const std::regex bare(R"rx([<>]|&(?!(?:amp|lt|gt|quot);))rx");
  std::vector<std::string> open;
  std::size_t after = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const auto at = static_cast<std::size_t>(it->position());
    const std::string between = text.substr(after, at - after), name = (*it)[2];
    if (std::regex_search(between, bare)) return "a bare mark in: " + between;
    if (std::regex_search((*it)[3].str(), std::regex("&(?!(?:amp|lt|gt|quot);)")))
      return "a bare & in: " + it->str();
    after = at + it->str().size();
    if ((*it)[1].length() == 0 && (*it)[4].length() == 0) open.push_back(name);
    if ((*it)[1].length() == 0) continue;
    if (open.empty() || open.back() != name) return "closed out of order: " + name;
    open.pop_back();
    if (open.empty() && name != "svg") return "the outermost is " + name;
  }
  return open.empty() && text.substr(after) == "\n" ? "" : "not closed";
}

inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace preshape::test
