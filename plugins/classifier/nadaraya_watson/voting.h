#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "preshape/grasp/taught_rows.h"

namespace preshape::nadaraya_watson {

struct VotingSettings {
  std::vector<int> groups, fields;  ///< features of each group, bits of each field
  std::vector<double> widths;       ///< of the kernel in each group, in its spreads
  double power = 4.0;
  double sharpness = 0.0;  ///< 0: found by leaving rows out
  bool asinh = true;
};

/// A lesson prepared for questions: features in groups scaled by their spread, codes cut into fields. A pattern's
/// probability is its share of the votes to a power, the sharpness, over the sum of those. No decision depends on
/// it; it is chosen so that the rows, each left out in turn, get the best probabilities (least Brier score).
class Voting {
 public:
  Voting() = default;
  Voting(const TaughtRows& lesson, const VotingSettings& settings);

  /// Probabilities of the bits for one question. Each field is decided in turn: its patterns share the votes
  /// of all rows that agree with what was decided before, so that the code is one that some row has.
  /// @param question features numbers, finite; @param bits overwritten
  void ask(const double* question, std::span<double> bits) const;

 private:
  struct Field {
    int first_bit = 0, bits = 0;
    std::vector<std::uint32_t> patterns;  ///< ascending, the field's first bit the most significant
    std::vector<std::size_t> of_row;      ///< each row's place among them
  };

  void add_field(const RowMatrix& targets, int bits);
  std::vector<double> log_votes(const double* scaled, std::size_t left_out) const;
  double calibrated_sharpness() const;

  double power_ = 0.0, sharpness_ = 1.0;
  bool asinh_ = false;
  RowMatrix rows_;              ///< scaled
  std::vector<double> scales_;  ///< of each feature
  std::vector<Field> fields_;
};

}  // namespace preshape::nadaraya_watson
