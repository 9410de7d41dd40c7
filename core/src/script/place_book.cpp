#include "place_book.h"

#include <algorithm>

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

namespace {

bool knows_places(const Value& value) {
  if (value.place().known()) return true;
  if (value.is_list()) {
    return std::any_of(value.items().begin(), value.items().end(),
                       [](const auto& v) { return v.place().known(); });
  }
  return std::any_of(value.entries().begin(), value.entries().end(),
                     [](const auto& entry) { return entry.second.place().known(); });
}

}  // namespace

long PlaceBook::page_of(const Value& value) {
  if (!knows_places(value)) return -1;
  TablePlaces page{value.place(), {}, {}};
  std::string identity = std::string(value.kind()) + page.place.text();
  const auto note = [&](std::string_view key, const SourcePlace& place) {
    identity.append("\n").append(key).append("=").append(place.text());
    return place;
  };
  if (value.is_list()) {
    for (const auto& item : value.items()) page.items.push_back(note("", item.place()));
  } else {
    for (const auto& [key, item] : value.entries()) page.keys[key] = note(key, item.place());
  }
  const auto [found, added] =
      pages_of_values_.try_emplace(std::move(identity), static_cast<long>(pages_.size()));
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
