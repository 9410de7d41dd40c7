#include "voting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace preshape::nadaraya_watson {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();  ///< the logarithm of no vote
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

/// A spread below this share of the group's largest number is its rounding.
constexpr double kLeastSpread = 1e-12;

/// A pattern that wins without a majority is given this share, and what the others say is squeezed to the rest.
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

/// Each pattern's share of the votes.
std::vector<double> shares_of(std::span<const double> log_votes, std::span<const std::size_t> of_row,
                              std::size_t patterns) {
  std::vector<double> shares(patterns);
  const double most = *std::max_element(log_votes.begin(), log_votes.end());
  double sum = 0.0;
  for (std::size_t r = 0; r < log_votes.size(); ++r) {
    const double vote = std::exp(log_votes[r] - most);
    shares[of_row[r]] += vote;
    sum += vote;
  }
  for (double& share : shares) share /= sum;
  return shares;
}

std::vector<double> sharpened(std::vector<double> shares, double sharpness) {
  double sum = 0.0;
  for (double& share : shares) sum += share = std::pow(share, sharpness);
  for (double& share : shares) share /= sum;
  return shares;
}

/// With the winner above one half.
std::vector<double> decided(std::vector<double> shares, std::size_t winner) {
  if (shares[winner] >= kMajority) return shares;
  const double rest = (1.0 - kMajority) / (1.0 - shares[winner]);
  for (double& share : shares) share *= rest;
  shares[winner] = kMajority;
  return shares;
}

double brier(const std::vector<double>& shares, std::size_t right) {
  double score = 0.0;
  for (std::size_t p = 0; p < shares.size(); ++p) score += (shares[p] - (p == right)) * (shares[p] - (p == right));
  return score;
}

/// Takes the votes from rows with another pattern.
void keep_only(std::span<double> log_votes, std::span<const std::size_t> of_row, std::size_t pattern) {
  for (std::size_t r = 0; r < log_votes.size(); ++r) {
    if (of_row[r] != pattern) log_votes[r] = kNone;
  }
}

std::uint32_t pattern_of(const RowMatrix& targets, Eigen::Index row, int first_bit, int bits) {
  std::uint32_t pattern = 0;
  for (int b = 0; b < bits; ++b) pattern = pattern << 1 | (targets(row, first_bit + b) > 0.5 ? 1u : 0u);
  return pattern;
}

}  // namespace

Voting::Voting(const TaughtRows& lesson, const VotingSettings& settings)
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
  for (const int bits : parts_of(settings.fields, lesson.targets().cols())) add_field(lesson.targets(), bits);
  sharpness_ = settings.sharpness > 0.0 ? settings.sharpness : calibrated_sharpness();
}

void Voting::add_field(const RowMatrix& targets, int bits) {
  const int first_bit = fields_.empty() ? 0 : fields_.back().first_bit + fields_.back().bits;
  Field field{first_bit, bits, {}, {}};
  std::vector<std::uint32_t> of_row;
  for (Eigen::Index r = 0; r < rows_.rows(); ++r) of_row.push_back(pattern_of(targets, r, first_bit, bits));
  const std::set<std::uint32_t> patterns(of_row.begin(), of_row.end());
  field.patterns.assign(patterns.begin(), patterns.end());
  for (const std::uint32_t pattern : of_row) {
    field.of_row.push_back(static_cast<std::size_t>(
        std::lower_bound(field.patterns.begin(), field.patterns.end(), pattern) - field.patterns.begin()));
  }
  fields_.push_back(std::move(field));
}

/// The logarithm of the kernel exp(-q / 2) q^(-power / 2) at each row, but for a constant; rows at no distance
/// vote alone. @param left_out a row that does not vote, or none
std::vector<double> Voting::log_votes(const double* scaled, std::size_t left_out) const {
  constexpr double kMost = std::numeric_limits<double>::max();
  std::vector<double> votes(static_cast<std::size_t>(rows_.rows()));
  bool alone = false;
  for (std::size_t r = 0; r < votes.size(); ++r) {
    const double* row = rows_.row(static_cast<Eigen::Index>(r)).data();
    double q = 0.0;
    for (std::size_t i = 0; i < scales_.size(); ++i) q += (row[i] - scaled[i]) * (row[i] - scaled[i]);
    votes[r] = q <= kMost ? q : kMost;
    alone = alone || (q == 0.0 && r != left_out);
  }
  for (double& q : votes) {
    q = alone ? (q == 0.0 ? 0.0 : kNone) : -0.5 * q - 0.5 * power_ * std::log(q);
  }
  if (left_out < votes.size()) votes[left_out] = kNone;
  return votes;
}

void Voting::ask(const double* question, std::span<double> bits) const {
  std::vector<double> scaled(scales_.size());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    // A constant feature does not count, also where its question is beyond all bounds.
    scaled[i] = scales_[i] > 0.0 ? scales_[i] * (asinh_ ? std::asinh(question[i]) : question[i]) : 0.0;
  }
  std::fill(bits.begin(), bits.end(), 0.0);
  std::vector<double> votes = log_votes(scaled.data(), kNobody);
  for (const Field& field : fields_) {
    const auto shares = shares_of(votes, field.of_row, field.patterns.size());
    const auto winner = static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    const auto probabilities = decided(sharpened(shares, sharpness_), winner);
    for (std::size_t p = 0; p < probabilities.size(); ++p) {
      for (int b = 0; b < field.bits; ++b) {
        const bool is_set = field.patterns[p] >> (field.bits - 1 - b) & 1u;
        if (is_set) bits[static_cast<std::size_t>(field.first_bit + b)] += probabilities[p];
      }
    }
    keep_only(votes, field.of_row, winner);
  }
  for (double& bit : bits) bit = std::min(bit, 1.0);  // sums of shares may miss the border by a rounding
}

double Voting::calibrated_sharpness() const {
  constexpr std::size_t kMostLeftOut = 500;  // of many rows every few are left out: it is one number that is sought
  constexpr std::size_t kTrials = 20;
  constexpr double kStep = 0.1;
  const auto count = static_cast<std::size_t>(rows_.rows()), step = count / kMostLeftOut + 1;
  if (count < 2) return 1.0;
  std::vector<double> scores(kTrials);
  for (std::size_t r = 0; r < count; r += step) {
    std::vector<double> votes = log_votes(rows_.row(static_cast<Eigen::Index>(r)).data(), r);
    for (const Field& field : fields_) {
      if (*std::max_element(votes.begin(), votes.end()) == kNone) break;  // no other row has the fields before
      const auto shares = shares_of(votes, field.of_row, field.patterns.size());
      for (std::size_t t = 0; t < kTrials; ++t) scores[t] += brier(sharpened(shares, kStep * (t + 1.0)), field.of_row[r]);
      keep_only(votes, field.of_row, field.of_row[r]);
    }
  }
  return kStep * static_cast<double>(std::min_element(scores.begin(), scores.end()) - scores.begin() + 1);
}

}  // namespace preshape::nadaraya_watson
