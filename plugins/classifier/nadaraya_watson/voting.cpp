#include "voting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace preshape::nadaraya_watson {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

/// A spread below this share of the group's largest number is its rounding.
constexpr double kLeastSpread = 1e-12;

/// A code that wins without a majority is given this share, and what the others say is squeezed to the rest.
constexpr double kMajority = 0.51;

/// The parts that add up to `whole`, else one part.
std::vector<int> parts_of(const std::vector<int>& parts, Eigen::Index whole) {
  if (std::accumulate(parts.begin(), parts.end(), 0) == whole) return parts;
  return {static_cast<int>(whole)};
}

/// One over the root mean square deviation of a group's features from their means; 0 where they are constant.
double scale_of(const Eigen::Ref<const RowMatrix, 0, Eigen::OuterStride<>>& group) {
  const double largest = group.cwiseAbs().maxCoeff();
  if (!(largest > 0.0)) return 0.0;
  const RowMatrix unit = group / largest;  // so that no square overflows
  const RowMatrix deviations = unit.rowwise() - unit.colwise().mean();
  const double spread = std::sqrt(deviations.squaredNorm() / static_cast<double>(deviations.size()));
  const double scale = 1.0 / (spread * largest);
  return spread <= kLeastSpread || !std::isnormal(scale) ? 0.0 : scale;
}

std::uint32_t pattern_of(const RowMatrix& targets, Eigen::Index row, int first_bit, int bits) {
  std::uint32_t pattern = 0;
  for (int b = 0; b < bits; ++b) pattern = pattern << 1 | (targets(row, first_bit + b) > 0.5 ? 1u : 0u);
  return pattern;
}

}  // namespace

Voting::Voting(const Lesson& lesson, const VotingSettings& settings)
    : power_(settings.power), asinh_(settings.asinh), rows_(lesson.inputs()) {
  if (asinh_) rows_ = rows_.unaryExpr([](double x) { return std::asinh(x); });
  Eigen::Index first = 0;
  const auto groups = parts_of(settings.groups, rows_.cols());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const double scale = scale_of(rows_.middleCols(first, groups[g])) / settings.widths[g];
    scales_.insert(scales_.end(), static_cast<std::size_t>(groups[g]), scale);
    rows_.middleCols(first, groups[g]) *= scale;
    first += groups[g];
  }
  int first_bit = 0;
  for (const int bits : parts_of(settings.fields, lesson.targets().cols())) {
    Field field{first_bit, bits, {}, {}};
    std::vector<std::uint32_t> of_row;
    for (Eigen::Index r = 0; r < rows_.rows(); ++r) of_row.push_back(pattern_of(lesson.targets(), r, first_bit, bits));
    const std::set<std::uint32_t> patterns(of_row.begin(), of_row.end());
    field.patterns.assign(patterns.begin(), patterns.end());
    for (const std::uint32_t pattern : of_row) {
      field.of_row.push_back(static_cast<std::size_t>(
          std::lower_bound(field.patterns.begin(), field.patterns.end(), pattern) - field.patterns.begin()));
    }
    fields_.push_back(std::move(field));
    first_bit += bits;
  }
}

/// The logarithm of the kernel exp(-q / 2) q^(-power / 2) at each row, but for a constant; rows at no distance
/// vote alone.
std::vector<double> Voting::log_votes(const double* question) const {
  std::vector<double> votes(static_cast<std::size_t>(rows_.rows())), asked(scales_.size());
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i] = scales_[i] * (asinh_ ? std::asinh(question[i]) : question[i]);
  bool alone = false;
  for (std::size_t r = 0; r < votes.size(); ++r) {
    const double* row = rows_.row(static_cast<Eigen::Index>(r)).data();
    double q = 0.0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (scales_[i] > 0.0) q += (row[i] - asked[i]) * (row[i] - asked[i]);
    }
    votes[r] = q <= std::numeric_limits<double>::max() ? q : std::numeric_limits<double>::max();
    alone = alone || q == 0.0;
  }
  for (double& q : votes) {
    q = alone ? (q == 0.0 ? 0.0 : kNone) : -0.5 * q - 0.5 * power_ * std::log(q);
  }
  return votes;
}

/// Shares out the votes among the field's patterns. @returns the pattern that has most of them, the first of equals
std::size_t Voting::decide(const Field& field, std::span<const double> log_votes, std::span<double> bits) {
  std::vector<double> shares(field.patterns.size());
  const double most = *std::max_element(log_votes.begin(), log_votes.end());
  double sum = 0.0;
  for (std::size_t r = 0; r < log_votes.size(); ++r) {
    const double vote = std::exp(log_votes[r] - most);
    shares[field.of_row[r]] += vote;
    sum += vote;
  }
  for (double& share : shares) share /= sum;
  const auto winner = static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  if (shares[winner] < kMajority) {
    const double rest = (1.0 - kMajority) / (1.0 - shares[winner]);
    for (double& share : shares) share *= rest;
    shares[winner] = kMajority;
  }
  for (std::size_t p = 0; p < shares.size(); ++p) {
    for (int b = 0; b < field.bits; ++b) {
      if (field.patterns[p] >> (field.bits - 1 - b) & 1u) bits[static_cast<std::size_t>(field.first_bit + b)] += shares[p];
    }
  }
  return winner;
}

void Voting::ask(const double* question, std::span<double> bits) const {
  std::fill(bits.begin(), bits.end(), 0.0);
  std::vector<double> votes = log_votes(question);
  for (const Field& field : fields_) {
    const std::size_t decided = decide(field, votes, bits);
    for (std::size_t r = 0; r < votes.size(); ++r) {
      if (field.of_row[r] != decided) votes[r] = kNone;
    }
  }
  for (double& bit : bits) bit = std::min(bit, 1.0);  // sums of shares may miss the border by a rounding
}

}  // namespace preshape::nadaraya_watson
