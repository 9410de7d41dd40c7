// Fuzzy sets as a script describes them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/fuzzy/partition.h"
#include "set_shapes.h"

namespace preshape {

const std::vector<SetShape>& set_shapes() {
  using Shape = Membership::Shape;
  static const std::vector<SetShape> shapes = {{Shape::kTrapezoid, "trapezoid", 4, "a <= b <= c <= d"},
                                               {Shape::kTriangle, "triangle", 3, "a <= b <= c"},
                                               {Shape::kGaussian, "gaussian", 2, "centre, sigma > 0"},
                                               {Shape::kBell, "bell", 3, "half width > 0, slope > 0, centre"},
                                               {Shape::kSigmoid, "sigmoid", 2, "steepness, crossing"}};
  return shapes;
}

std::string set_fault(const Membership& set) {
  const SetShape& shape = set_shapes()[static_cast<std::size_t>(set.shape)];
  const auto& p = set.points;
  const std::string wants = fmt::format("a {} needs {} numbers ({})", shape.word, shape.points, shape.meaning);
  if (p.size() != shape.points) return fmt::format("{}, got {}", wants, p.size());
  if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); })) return wants + ", all finite";
  const bool ordered = set.shape > Membership::Shape::kTriangle || std::is_sorted(p.begin(), p.end());
  const bool positive = (set.shape != Membership::Shape::kGaussian || p[1] > 0) &&
                        (set.shape != Membership::Shape::kBell || (p[0] > 0 && p[1] > 0));
  return ordered && positive ? "" : wants;
}

namespace {

/// Reads one set; adds what is wrong to `mistakes`.
Membership read_set(const Value& value, const SourcePlace& place, std::vector<Mistake>& mistakes) {
  Membership set;
  const auto fault = [&](const std::string& sentence, const SourcePlace& at) {
    mistakes.push_back({at.known() ? at : place, "fuzzy sets: " + sentence});
  };
  if (!value.is_table()) {
    fault(fmt::format("each set is a table {{ name = ..., trapezoid = {{a, b, c, d}} }}, got {}", value.text()),
          value.place());
    return set;
  }
  std::vector<std::string> known = {"name"};
  for (const auto& shape : set_shapes()) known.push_back(shape.word);
  bool shaped = false;
  for (const auto& [key, entry] : value.entries()) {
    const auto shape = std::find_if(set_shapes().begin(), set_shapes().end(),
                                    [&key = key](const SetShape& s) { return s.word == key; });
    if (key == "name" && entry.is_string()) {
      set.name = entry.string();
    } else if (shape != set_shapes().end() && entry.is_list() && !shaped) {
      shaped = true;
      set.shape = shape->shape;
      for (const auto& number : entry.items()) set.points.push_back(number.is_number() ? number.number() : NAN);
      if (const std::string wrong = set_fault(set); !wrong.empty()) fault(wrong, entry.place());
    } else if (shape != set_shapes().end() || key == "name") {
      fault(fmt::format("'{}' cannot be {}", key, entry.text()), entry.place());
    } else {
      fault(fmt::format("unknown key '{}'{}", key, did_you_mean(key, known)), entry.place());
    }
  }
  if (set.name.empty()) fault("a set has no name", value.place());
  if (!shaped) fault(fmt::format("set '{}' has no shape; give one of trapezoid, triangle, gaussian, bell, sigmoid", set.name),
                     value.place());
  return set;
}

std::vector<Membership> read_sets(const Value& value, std::vector<Mistake>& mistakes) {
  std::vector<Membership> sets;
  if (!value.is_list() || value.items().empty()) {
    mistakes.push_back({value.place(), "fuzzy sets: expected a list of sets, got " + value.text()});
    return sets;
  }
  for (const auto& item : value.items()) {
    sets.push_back(read_set(item, value.place(), mistakes));
    for (std::size_t k = 0; k + 1 < sets.size(); ++k) {
      if (sets[k].name == sets.back().name && !sets[k].name.empty()) {
        mistakes.push_back({item.place().known() ? item.place() : value.place(),
                            fmt::format("fuzzy sets: '{}' is named twice", sets[k].name)});
      }
    }
  }
  // Values beyond the outer sets' tops belong to them wholly (spec section 7).
  sets.front().open_below = true;
  sets.back().open_above = true;
  return sets;
}

}  // namespace

std::vector<Mistake> FuzzyPartition::check(const Value& sets) {
  std::vector<Mistake> mistakes;
  read_sets(sets, mistakes);
  return mistakes;
}

FuzzyPartition FuzzyPartition::from_value(const Value& value) {
  std::vector<Mistake> mistakes;
  std::vector<Membership> sets = read_sets(value, mistakes);
  if (!mistakes.empty()) throw InputError(mistakes.front().text());
  return FuzzyPartition(std::move(sets));
}

}  // namespace preshape
