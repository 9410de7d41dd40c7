#include "preshape/fuzzy/partition.h"

#include <algorithm>

#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "set_shapes.h"

namespace preshape {

FuzzyPartition::FuzzyPartition(std::vector<Membership> sets) : sets_(std::move(sets)) {
  if (sets_.empty()) throw InputError("a fuzzy partition needs at least one set");
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    if (const std::string wrong = set_fault(sets_[i]); !wrong.empty()) {
      throw InputError("fuzzy set '" + sets_[i].name + "': " + wrong);
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (sets_[k].name == sets_[i].name) throw InputError("fuzzy set '" + sets_[i].name + "' is named twice");
    }
  }
}

FuzzyPartition FuzzyPartition::thesis() {
  const auto set = [](const char* name, double a, double b, double c, double d) {
    return Membership{name, Membership::Shape::kTrapezoid, {a, b, c, d}, false, false};
  };
  std::vector<Membership> sets = {
      set("RwdH", -1.2, -1.2, -0.9, -0.75), set("RwdM", -0.9, -0.8, -0.5, -0.35),
      set("RwdL", -0.5, -0.35, -0.15, -0.05), set("Zero", -0.15, -0.05, 0.05, 0.15),
      set("FwdL", 0.05, 0.15, 0.35, 0.5),   set("FwdM", 0.35, 0.5, 0.8, 0.9),
      set("FwdH", 0.75, 0.9, 1.2, 1.2)};
  sets.front().open_below = true;
  sets.back().open_above = true;
  return FuzzyPartition(std::move(sets));
}

void FuzzyPartition::fuzzify(double x, std::span<double> degrees) const {
  PRESHAPE_DEMAND(degrees.size() == sets_.size());
  for (std::size_t i = 0; i < sets_.size(); ++i) degrees[i] = sets_[i](x);
}

int FuzzyPartition::best(double x) const {
  int best = 0;
  double highest = -1.0;
  for (int i = 0; i < size(); ++i) {
    const double degree = (*this)[i](x);
    if (degree > highest) highest = degree, best = i;
  }
  return best;
}

}  // namespace preshape
