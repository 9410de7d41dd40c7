#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "preshape/base/random.h"
#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ExplorationProblem;
using preshape::ExplorationResult;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::Random;
using preshape::Station;
using preshape::StationScore;

/// Golden sections from random starts: each start draws a plane, a finger count, an offset and a middle, and narrows the interval
/// of `width` around the middle by golden sections [Kiefer1953]. The order of the evaluations does not depend on the
/// budget, so that a larger one never ends with a worse station.
class @CLASS@ final : public preshape::Explorer {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::integer("starts", 40, 1, 100000, "starts", "random starts"),
            ParameterDeclaration::integer("sections", 4, 0, 100, "sections", "golden sections of each start"),
            ParameterDeclaration::number("width", 0.5, 0.001, 2.0, "1", "interval of a start, over the half extent")};
  }
  static std::vector<std::string> capabilities() { return {"anytime"}; }

  explicit @CLASS@(const preshape::Parameters& p)
      : starts_(p.integer("starts")), sections_(p.integer("sections")), width_(p.number("width")) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t seed,
                            Progress* progress) const override {
    Search search{problem, budget, {}};
    const auto counts = problem.finger_counts();
    const auto offsets = problem.transverse_offsets();
    if (problem.planes() < 1 || counts.empty() || offsets.empty()) return search.result;
    Random random(seed);
    for (std::int64_t start = 0; start < starts_ && !search.result.budget_spent; ++start) {
      if (progress) progress->advance("exploring", static_cast<double>(start) / static_cast<double>(starts_), "");
      const int plane = static_cast<int>(random.below(static_cast<std::uint64_t>(problem.planes())));
      const int fingers = counts[random.below(counts.size())];
      const double offset = offsets[random.below(offsets.size())];
      const double middle = random.uniform(problem.lowest_approach(), problem.highest_approach());
      search.narrow({plane, 0.0, fingers, offset}, std::max(problem.lowest_approach(), middle - width_ / 2),
                    std::min(problem.highest_approach(), middle + width_ / 2), sections_);
    }
    if (progress) progress->advance("exploring", 1.0, "");
    return search.result;
  }

 private:
  struct Search {
    const ExplorationProblem& problem;
    std::int64_t budget;
    ExplorationResult result;

    /// Score of a station, and whether the budget allowed to ask for it.
    std::pair<StationScore, bool> ask(const Station& station) {
      StationScore score;
      if (result.evaluations >= budget) {
        result.budget_spent = true;
        return {score, false};
      }
      problem.evaluate({&station, 1}, {&score, 1});
      ++result.evaluations;
      if (score.better_than(result.score)) result.best = station, result.score = score;
      return {score, true};
    }

    /// Along the approach axis, the rest as in `at`.
    void narrow(const Station& at, double low, double high, std::int64_t sections) {
      const auto ask_at = [&](double approach) { return ask({at.plane, approach, at.virtual_fingers, at.transverse}); };
      const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
      double left = high - ratio * (high - low), right = low + ratio * (high - low);
      auto [at_left, left_told] = ask_at(left);
      auto [at_right, right_told] = ask_at(right);
      for (std::int64_t i = 0; i < sections && left_told && right_told; ++i) {
        if (at_left.better_than(at_right)) {
          high = right, right = left, at_right = at_left;
          left = high - ratio * (high - low);
          std::tie(at_left, left_told) = ask_at(left);
        } else {
          low = left, left = right, at_left = at_right;
          right = low + ratio * (high - low);
          std::tie(at_right, right_told) = ask_at(right);
        }
      }
    }
  };

  std::int64_t starts_, sections_;
  double width_;
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Golden sections from random starts"}),
                ({"explorer/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Golden-section search from random starts"))
