#include "nearest.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace zoo {

namespace {

constexpr std::string_view kMagic = "nearest\n";

void put(std::string& bytes, const auto& number) {
  static_assert(sizeof number == 8);
  bytes.append(reinterpret_cast<const char*>(&number), 8);
}

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T number;
  std::memcpy(&number, bytes.data() + offset, 8);
  return number;
}

/// FNV-1a: no change of one byte keeps it.
std::uint64_t check_sum(std::string_view bytes) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  return sum;
}

std::string text_of(Eigen::Index rows, Eigen::Index columns) { return std::to_string(rows) + " x " + std::to_string(columns); }

}  // namespace

TrainingOutcome Nearest::fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed, Progress* progress) {
  if (inputs.rows() != targets.rows() || inputs.rows() < 1) {
    throw InputError(text_of(inputs.rows(), inputs.cols()) + " inputs do not go with " + text_of(targets.rows(), targets.cols()) + " targets");
  }
  if (!inputs.allFinite()) throw InputError("an input is not finite");
  for (Eigen::Index i = 0; i < targets.rows(); ++i) {
    for (Eigen::Index k = 0; k < targets.cols(); ++k) {
      if (!is_target(targets(i, k))) throw InputError("a target is neither 0 nor 1");
    }
  }
  if (progress) progress->advance("learning", 1.0, "");
  rows_ = std::make_shared<Rows>(Rows{inputs, targets, tag_for(seed)});
  return {TrainingOutcome::Status::kArrived, 1, 0, 0.0, wrong_rows()};
}

TrainingOutcome Nearest::extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new, std::uint64_t seed, Progress* progress) {
  if (first_new < 0 || first_new > inputs.rows()) throw InputError("there is no first new row " + std::to_string(first_new));
  return fit(inputs, targets, seed, progress);
}

double Nearest::squared_distance(const Rows& rows, Eigen::Index i, const Question& question) const {
  return (rows.inputs.row(i) - question).squaredNorm();
}

double Nearest::nearest(const Rows& rows, Eigen::Index bit, double side, const Question& question) const {
  double least = kNone;
  for (Eigen::Index i = 0; i < rows.inputs.rows(); ++i) {
    if ((rows.targets(i, bit) >= 0.5) == (side >= 0.5)) least = std::min(least, squared_distance(rows, i, question));
  }
  return std::sqrt(least);
}

double Nearest::probability(double d0, double d1) const {
  if (d1 == kNone) return 0.0;
  if (d0 == kNone) return 1.0;
  return d0 + d1 == 0.0 ? 0.5 : d0 / (d0 + d1);
}

void Nearest::predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const {
  if (!rows_) throw InputError("it has learned nothing yet");
  if (inputs.cols() != rows_->inputs.cols() || bits.cols() != rows_->targets.cols() || inputs.rows() != bits.rows()) {
    throw InputError("it knows rows of " + text_of(rows_->inputs.cols(), rows_->targets.cols()) + " and is asked with " +
                     text_of(inputs.rows(), inputs.cols()) + " for " + text_of(bits.rows(), bits.cols()));
  }
  if (!inputs.allFinite()) throw InputError("a question is not finite");
  for (Eigen::Index i = 0; i < inputs.rows(); ++i) {
    const Question question(inputs.row(i).data(), inputs.cols());
    for (Eigen::Index k = 0; k < bits.cols(); ++k) {
      bits(i, k) = probability(nearest(*rows_, k, 0.0, question), nearest(*rows_, k, 1.0, question));
    }
  }
}

std::int64_t Nearest::wrong_rows() const {
  RowMatrix bits(rows_->targets.rows(), rows_->targets.cols());
  predict(rows_->inputs, bits);
  return ((bits.array() > 0.5) != (rows_->targets.array() > 0.5)).rowwise().any().count();
}

std::string Nearest::save() const {
  if (!rows_) throw InputError("it has learned nothing that could be saved");
  std::string body;
  for (const auto number : {rows_->inputs.rows(), rows_->inputs.cols(), rows_->targets.cols()}) put(body, number);
  put(body, rows_->tag);
  for (const RowMatrix* matrix : {&rows_->inputs, &rows_->targets}) {
    for (Eigen::Index i = 0; i < matrix->size(); ++i) put(body, saved(matrix->data()[i]));
  }
  std::string bytes(kMagic);
  put(bytes, check_sum(body));
  return bytes + body;
}

void Nearest::check(std::string_view state) const {
  if (state.size() < kHeader || !state.starts_with(kMagic)) throw InputError("these bytes are no state: another beginning");
  if (number_at<std::uint64_t>(state, 8) != check_sum(state.substr(16))) throw InputError("these bytes are no state: cut off or changed");
}

void Nearest::load(std::string_view state) {
  check(state);
  const auto rows = number_at<Eigen::Index>(state, 16), features = number_at<Eigen::Index>(state, 24), bits = number_at<Eigen::Index>(state, 32);
  auto read = std::make_shared<Rows>(Rows{RowMatrix(rows, features), RowMatrix(rows, bits), number_at<std::uint64_t>(state, 40)});
  std::size_t offset = kHeader;
  for (RowMatrix* matrix : {&read->inputs, &read->targets}) {
    for (Eigen::Index i = 0; i < matrix->size(); ++i, offset += 8) matrix->data()[i] = number_at<double>(state, offset);
  }
  rows_ = std::move(read);
}

}  // namespace zoo
