#include "place_book.h"

#include "source_map.h"

namespace preshape::lua {

std::string PlaceBook::add_source(const std::string& file, std::string_view source) {
  SourceMap map = map_source(source, pages_.size());
  for (const auto& constructor : map.constructors) {
    TablePlaces page{{file, constructor.line}, {}, {}};
    for (const auto& [key, line] : constructor.keys) page.keys[key] = {file, line};
    for (const int line : constructor.items) page.items.push_back({file, line});
    pages_.push_back(std::move(page));
  }
  last_keys_[file] = std::move(map.last_key);
  return std::move(map.marked);
}

long PlaceBook::page_of(const Value& value) {
  bool known = value.place().known();
  TablePlaces page{value.place(), {}, {}};
  std::string identity = std::string(value.kind()) + page.place.text();
  const auto note = [&](std::string_view key, const SourcePlace& place) {
    known = known || place.known();
    identity.append("\n").append(key).append("=").append(place.text());
    return place;
  };
  if (value.is_list()) {
    for (const auto& item : value.items()) page.items.push_back(note("", item.place()));
  } else {
    for (const auto& [key, item] : value.entries()) page.keys[key] = note(key, item.place());
  }
  if (!known) return -1;
  const auto [found, added] = pages_of_values_.try_emplace(std::move(identity), static_cast<long>(pages_.size()));
  if (added) pages_.push_back(std::move(page));
  return found->second;
}

const TablePlaces* PlaceBook::page(long number) const {
  return number >= 0 && number < static_cast<long>(pages_.size()) ? &pages_[static_cast<std::size_t>(number)]
                                                                   : nullptr;
}

SourcePlace PlaceBook::last_key(const std::string& file, std::string_view key) const {
  const auto keys = last_keys_.find(file);
  if (keys == last_keys_.end()) return {};
  const auto line = keys->second.find(key);
  return line == keys->second.end() ? SourcePlace{} : SourcePlace{file, line->second};
}

}  // namespace preshape::lua
