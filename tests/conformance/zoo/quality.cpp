// Quality measures: a good one, and one for each check that it breaks.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "preshape/base/require.h"
#include "preshape/grasp/quality.h"
#include "preshape/plugin/entry.h"
#include "preshape/spatial/reciprocal.h"

namespace {

using preshape::GraspView;
using preshape::QualityNumber;
using Names = std::vector<std::string>;

/// Distances of the contacts from the thumb, shortest and longest, over the characteristic length.
std::pair<double, double> distances(const GraspView& grasp) {
  double shortest = 0.0, longest = 0.0;
  for (const auto& contact : grasp.contacts.subspan(1)) {
    const double distance = (contact.p_OC - grasp.contacts.front().p_OC).norm() / grasp.length_m;
    shortest = longest == 0.0 ? distance : std::min(shortest, distance);
    longest = std::max(longest, distance);
  }
  return {shortest, longest};
}

/// How evenly the fingers stand off the thumb. What is wrong with the others is wrong in its one number.
class Evenness : public preshape::QualityMeasure {
 public:
  explicit Evenness(const preshape::Parameters&) {}
  std::span<const QualityNumber> numbers() const noexcept override { return numbers_; }
  void evaluate(const GraspView& grasp, std::span<double> values) const override {
    preshape::require_size("values", numbers_.size(), values.size());
    for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = evenness(grasp);
    write(grasp, values.back());
  }

 protected:
  static double evenness(const GraspView& grasp) {
    const auto [shortest, longest] = distances(grasp);
    return longest > 0.0 ? shortest / longest : 0.0;
  }
  virtual double value(const GraspView& grasp) const { return evenness(grasp); }
  virtual void write(const GraspView& grasp, double& place) const { place = value(grasp); }
  std::vector<QualityNumber> numbers_ = {{"evenness", "1", 0.0, 1.0, true}};
};

struct GoodEvenness final : Evenness {
  using Evenness::Evenness;
  static Names capabilities() { return {"frame_invariant", "frame_invariant_first", "permutation_invariant", "force_scale_invariant"}; }
};

/// The number of independent wrenches.
class Rank : public Evenness {
 public:
  explicit Rank(const preshape::Parameters& p) : Evenness(p) { numbers_ = {{"stability", "1", 0.0, 6.0, true}}; }
};
struct GoodRank final : Rank {
  using Rank::Rank;
  static Names capabilities() { return {"frame_invariant", "permutation_invariant", "force_scale_invariant"}; }
  double value(const GraspView& grasp) const override { return preshape::wrench_rank(grasp.wrench_union); }
};

struct Q01MoreThanOne final : Evenness {
  using Evenness::Evenness;
  double value(const GraspView& grasp) const override { return evenness(grasp) * (1.0 + 0.1 * std::abs(grasp.contacts.front().a.y())); }
};

struct Q02OneNameTwice final : Evenness {
  explicit Q02OneNameTwice(const preshape::Parameters& p) : Evenness(p) { numbers_.push_back(numbers_.front()); }
};

/// The first number is right, the second looks along x.
struct Q03SecondLooksAlongX final : Evenness {
  explicit Q03SecondLooksAlongX(const preshape::Parameters& p) : Evenness(p) { numbers_.push_back({"slant", "1", 0.0, 1.0, true}); }
  static Names capabilities() { return {"frame_invariant"}; }
  double value(const GraspView& grasp) const override { return std::abs(grasp.contacts.front().n.x()); }
};

struct Q04LooksAlongX final : Evenness {
  using Evenness::Evenness;
  static Names capabilities() { return {"frame_invariant_first"}; }
  double value(const GraspView& grasp) const override { return std::abs(grasp.contacts.front().n.x()); }
};

struct Q05PrefersTheLast final : Evenness {
  using Evenness::Evenness;
  static Names capabilities() { return {"permutation_invariant"}; }
  double value(const GraspView& grasp) const override { return std::abs(grasp.contacts.back().n.x()); }
};

struct Q06WeighsForces final : Evenness {
  using Evenness::Evenness;
  static Names capabilities() { return {"force_scale_invariant"}; }
  double value(const GraspView& grasp) const override { return 1.0 / (1.0 + grasp.resultant.force().norm()); }
};

struct Q07DividesByTheSpread final : Evenness {
  using Evenness::Evenness;
  double value(const GraspView& grasp) const override {
    const auto [shortest, longest] = distances(grasp);
    return shortest / longest;
  }
};

struct Q08AddsToWhatIsThere final : Evenness {
  using Evenness::Evenness;
  void write(const GraspView& grasp, double& place) const override { place += value(grasp); }
};

struct Q09MeasuresInMetres final : Evenness {
  using Evenness::Evenness;
  double value(const GraspView& grasp) const override { return 1.0 / (1.0 + grasp.contacts.front().p_OC.norm()); }
};

struct Q10CountsRows final : Rank {
  using Rank::Rank;
  double value(const GraspView& grasp) const override { return std::min(6.0, static_cast<double>(grasp.wrench_union.rows())); }
};

}  // namespace

using preshape::component;
PRESHAPE_PLUGIN(({"zoo_quality", "1.0.0", "BSD-3-Clause", "the preshape developers", "Quality measures, most of them broken"}),
                ({"quality/good_evenness", "quality/good_rank", "quality/q01_more_than_one", "quality/q02_one_name_twice",
                  "quality/q03_second_looks_along_x", "quality/q04_looks_along_x", "quality/q05_prefers_the_last",
                  "quality/q06_weighs_forces", "quality/q07_divides_by_the_spread", "quality/q08_adds_to_what_is_there",
                  "quality/q09_measures_in_metres", "quality/q10_counts_rows"}),
                component<GoodEvenness>("good_evenness", "How evenly the fingers stand off the thumb"),
                component<GoodRank>("good_rank", "Independent wrenches"),
                component<Q01MoreThanOne>("q01_more_than_one", "Leaves its range"),
                component<Q02OneNameTwice>("q02_one_name_twice", "Two numbers of one name"),
                component<Q03SecondLooksAlongX>("q03_second_looks_along_x", "Its second number looks along x"),
                component<Q04LooksAlongX>("q04_looks_along_x", "Looks along x"),
                component<Q05PrefersTheLast>("q05_prefers_the_last", "Looks at the last contact"),
                component<Q06WeighsForces>("q06_weighs_forces", "Weighs the resultant"),
                component<Q07DividesByTheSpread>("q07_divides_by_the_spread", "Divides by zero where contacts meet"),
                component<Q08AddsToWhatIsThere>("q08_adds_to_what_is_there", "Adds where it should write"),
                component<Q09MeasuresInMetres>("q09_measures_in_metres", "Takes lengths in metres"),
                component<Q10CountsRows>("q10_counts_rows", "Counts wrenches, independent or not"))
