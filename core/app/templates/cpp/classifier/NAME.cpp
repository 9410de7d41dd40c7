#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/base/sha256.h"
#include "preshape/grasp/classifier.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::RowMatrix;
using preshape::TrainingOutcome;

using Rows = Eigen::Ref<const RowMatrix>;

static_assert(std::endian::native == std::endian::little, "a saved state is written in this byte order");

/// Everything that the classifier knows: the rows that it learned, sorted, and the weight of each feature.
struct Lesson {
  RowMatrix inputs;             ///< rows x features
  RowMatrix targets;            ///< rows x bits
  std::vector<double> weights;  ///< features

  /// Row that is nearest to x; of equally near ones the first, so the order of learning does not matter.
  Eigen::Index nearest(const Rows& x, Eigen::Index row) const {
    Eigen::Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < inputs.rows(); ++i) {
      double squares = 0.0;
      for (Eigen::Index j = 0; j < inputs.cols(); ++j) {
        const double d = (inputs(i, j) - x(row, j)) * weights[static_cast<std::size_t>(j)];
        squares += d * d;
      }
      if (squares < least) least = squares, best = i;
    }
    return best;
  }
};

void check_finite(const char* what, const Rows& rows) {
  if (!rows.allFinite()) throw InputError(std::string(what) + ": every number must be finite");
}

void check_rows(const Rows& inputs, const Rows& targets) {
  preshape::require_size("rows of the targets", static_cast<std::size_t>(inputs.rows()), static_cast<std::size_t>(targets.rows()));
  if (inputs.rows() < 1 || inputs.cols() < 1 || targets.cols() < 1) {
    throw InputError("a lesson has at least one row, one feature and one bit");
  }
  check_finite("inputs", inputs);
  if (!((targets.array() == 0.0) || (targets.array() == 1.0)).all()) throw InputError("targets: every bit is 0 or 1");
}

/// The rows in the order of their numbers.
Lesson sorted(const Rows& inputs, const Rows& targets) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(inputs.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto before = [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    if (inputs.row(a) != inputs.row(b)) return before(inputs.row(a), inputs.row(b));
    return before(targets.row(a), targets.row(b));
  });
  return {inputs(order, Eigen::all), targets(order, Eigen::all), std::vector<double>(static_cast<std::size_t>(inputs.cols()), 1.0)};
}

/// Nearest neighbour: a pattern has the bits of the learned row that is nearest to it [CoverHart1967]. With `scaled`
/// the difference in each feature is taken over the feature's range among the learned rows.
class @CLASS@ final : public preshape::Classifier {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::flag("scaled", true, "take differences over each feature's range")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "nonlinear", "interpolating", "order_invariant", "seedless", "realtime"};
  }

  explicit @CLASS@(const preshape::Parameters& p) : scaled_(p.flag("scaled")) {}

  TrainingOutcome fit(const Rows& inputs, const Rows& targets, std::uint64_t, Progress* progress) override {
    check_rows(inputs, targets);
    Lesson lesson = sorted(inputs, targets);
    if (scaled_) weigh(lesson);
    lesson_ = std::move(lesson);  // from here on nothing throws
    if (progress) progress->advance("learning", 1.0, "");
    return outcome();
  }

  TrainingOutcome extend(const Rows& inputs, const Rows& targets, std::int64_t first_new, std::uint64_t seed,
                         Progress* progress) override {
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError("first_new: expected 0 .. " + std::to_string(inputs.rows()) + ", got " + std::to_string(first_new));
    }
    return fit(inputs, targets, seed, progress);
  }

  bool trained() const noexcept override { return lesson_.inputs.rows() > 0; }

  void predict(const Rows& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (!trained()) throw InputError("the classifier has learned nothing yet; call fit or load before predict");
    const auto size = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
    preshape::require_size("features", size(lesson_.inputs.cols()), size(inputs.cols()));
    preshape::require_size("rows of the bits", size(inputs.rows()), size(bits.rows()));
    preshape::require_size("bits", size(lesson_.targets.cols()), size(bits.cols()));
    check_finite("inputs", inputs);
    for (Eigen::Index i = 0; i < inputs.rows(); ++i) bits.row(i) = lesson_.targets.row(lesson_.nearest(inputs, i));
  }

  std::string save() const override;
  void load(std::string_view state) override;

 private:
  static void weigh(Lesson& lesson) {
    for (Eigen::Index j = 0; j < lesson.inputs.cols(); ++j) {
      const double range = lesson.inputs.col(j).maxCoeff() - lesson.inputs.col(j).minCoeff();
      const double weight = 1.0 / range;
      if (std::isnormal(weight)) lesson.weights[static_cast<std::size_t>(j)] = weight;
    }
  }

  /// How well the learned rows are reproduced: fully, unless equal inputs were given different bits.
  TrainingOutcome outcome() const {
    TrainingOutcome result;
    result.epochs = 1;
    double squares = 0.0;
    for (Eigen::Index i = 0; i < lesson_.inputs.rows(); ++i) {
      const auto miss = (lesson_.targets.row(lesson_.nearest(lesson_.inputs, i)) - lesson_.targets.row(i)).eval();
      squares += miss.squaredNorm();
      result.wrong_rows += miss.isZero() ? 0 : 1;
    }
    result.mean_squared_error = squares / static_cast<double>(lesson_.targets.size());
    result.status = result.wrong_rows == 0 ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    return result;
  }

  bool scaled_;
  Lesson lesson_;
};

// A state is a head, the digest of what follows it, and three sizes and all numbers as eight bytes each.

constexpr std::string_view kHead = "preshape @NAME@ 1\n";
constexpr std::size_t kDigest = 64, kSizes = 3 * sizeof(std::uint64_t);

template <class T>
void append(std::string& bytes, const T* first, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(first), count * sizeof(T));
}

std::string @CLASS@::save() const {
  const std::uint64_t sizes[3] = {static_cast<std::uint64_t>(lesson_.inputs.rows()), static_cast<std::uint64_t>(lesson_.inputs.cols()),
                                  static_cast<std::uint64_t>(lesson_.targets.cols())};
  std::string body;
  append(body, sizes, 3);
  append(body, lesson_.weights.data(), lesson_.weights.size());
  append(body, lesson_.inputs.data(), static_cast<std::size_t>(lesson_.inputs.size()));
  append(body, lesson_.targets.data(), static_cast<std::size_t>(lesson_.targets.size()));
  return std::string(kHead) + preshape::sha256_hex(body) + body;
}

void @CLASS@::load(std::string_view state) {
  const auto refuse = [](const char* why) { throw InputError(std::string("this is no state of @NAME@: ") + why); };
  if (!state.starts_with(kHead)) refuse("it begins with other words, or is of another version");
  state.remove_prefix(kHead.size());
  if (state.size() < kDigest + kSizes) refuse("it is cut off");
  const std::string_view digest = state.substr(0, kDigest), body = state.substr(kDigest);
  if (preshape::sha256_hex(body) != digest) refuse("its digest does not fit, so it was damaged");
  std::uint64_t sizes[3];
  std::memcpy(sizes, body.data(), kSizes);
  const std::uint64_t numbers = (body.size() - kSizes) / sizeof(double);
  const auto [rows, features, bits] = sizes;
  // No product of the sizes is trusted before each is known to be small.
  if (rows > numbers || features > numbers || bits > numbers || numbers > std::uint64_t{1} << 31 ||
      (rows * (features + bits) + features) * sizeof(double) + kSizes != body.size()) {
    refuse("its sizes do not fit its length");
  }
  if ((rows == 0) != (features == 0) || (rows == 0) != (bits == 0)) refuse("its sizes do not fit each other");
  std::vector<double> all(numbers);
  if (numbers > 0) std::memcpy(all.data(), body.data() + kSizes, numbers * sizeof(double));
  const auto matrix = [](const double* first, std::uint64_t m, std::uint64_t n) {
    return Eigen::Map<const RowMatrix>(first, static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(n));
  };
  Lesson lesson{matrix(all.data() + features, rows, features), matrix(all.data() + features + rows * features, rows, bits),
                std::vector<double>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(features))};
  if (rows > 0) check_rows(lesson.inputs, lesson.targets);
  lesson_ = std::move(lesson);
}

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Nearest neighbour classifier"}),
                ({"classifier/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "The bits of the nearest learned row"))
