#pragma once

#include <span>
#include <string>
#include <vector>

#include "preshape/base/parameters.h"
#include "preshape/fuzzy/membership.h"

namespace preshape {

/// An ordered family of fuzzy sets over one variable.
class PRESHAPE_API FuzzyPartition {
 public:
  FuzzyPartition() = default;
  /// @throws InputError when there are no sets, a name repeats, points have the wrong count or order
  explicit FuzzyPartition(std::vector<Membership> sets);

  /// The thesis's seven trapezoids RwdH .. FwdH (figure 3.18).
  static FuzzyPartition thesis();
  /// From a script: a list of { name, trapezoid = {a, b, c, d} } and the like; the first and the last set
  /// are shoulders.
  /// @throws InputError with file and line
  static FuzzyPartition from_value(const Value& sets);
  /// The mistakes that from_value would name, all of them.
  static std::vector<Mistake> check(const Value& sets);

  int size() const { return static_cast<int>(sets_.size()); }
  const Membership& operator[](int i) const { return sets_[static_cast<std::size_t>(i)]; }
  std::span<const Membership> sets() const { return sets_; }

  /// Degrees of membership of x; `degrees` has size().
  void fuzzify(double x, std::span<double> degrees) const;
  /// Index of the set with the highest membership at x (the lowest index of a tie).
  int best(double x) const;

 private:
  std::vector<Membership> sets_;
};

}  // namespace preshape
