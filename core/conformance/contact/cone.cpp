#include "cone.h"

#include <algorithm>
#include <vector>

#include <Eigen/QR>

namespace preshape::conformance {

namespace {

constexpr double kZeroWeight = 1e-12;

/// Least squares over the chosen columns alone; zero elsewhere.
Eigen::VectorXd fitted(const WrenchBasis& edges, const std::vector<Eigen::Index>& chosen,
                       const Eigen::Matrix<double, 6, 1>& vector) {
  WrenchBasis columns(6, static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = edges.col(chosen[i]);
  const Eigen::VectorXd part = columns.colPivHouseholderQr().solve(vector);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(edges.cols());
  for (std::size_t i = 0; i < chosen.size(); ++i) weights[chosen[i]] = part[static_cast<Eigen::Index>(i)];
  return weights;
}

}  // namespace

double distance_from_cone(const WrenchBasis& edges, const Eigen::Matrix<double, 6, 1>& vector) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(edges.cols());
  std::vector<Eigen::Index> chosen;
  Eigen::Matrix<double, 6, 1> left = vector;
  for (Eigen::Index turn = 0; turn < 3 * edges.cols() && edges.cols() > 0; ++turn) {
    // The edge that points most along what is left comes in.
    Eigen::VectorXd pull = edges.transpose() * left;
    for (const Eigen::Index taken : chosen) pull[taken] = 0.0;
    Eigen::Index best = 0;
    if (pull.maxCoeff(&best) <= kZeroWeight) break;
    chosen.push_back(best);
    Eigen::VectorXd wanted = fitted(edges, chosen, vector);
    // Edges whose weight would be negative go out where they reach zero.
    while (std::any_of(chosen.begin(), chosen.end(), [&](Eigen::Index i) { return wanted[i] <= kZeroWeight; })) {
      double step = 1.0;
      for (const Eigen::Index i : chosen) {
        if (wanted[i] <= kZeroWeight && weights[i] > wanted[i]) step = std::min(step, weights[i] / (weights[i] - wanted[i]));
      }
      weights += step * (wanted - weights);
      std::erase_if(chosen, [&](Eigen::Index i) { return weights[i] <= kZeroWeight; });
      for (Eigen::Index i = 0; i < weights.size(); ++i) {
        if (weights[i] <= kZeroWeight) weights[i] = 0.0;
      }
      if (chosen.empty()) break;
      wanted = fitted(edges, chosen, vector);
    }
    if (chosen.empty()) break;
    weights = wanted;
    left = vector - edges * weights;
  }
  return left.norm();
}

Wrench loaded(const ContactFrame& contact, double multiple, const Eigen::Matrix<double, 6, 1>& direction) {
  return {contact.n + multiple * direction.head<3>(), multiple * direction.tail<3>()};
}

double reach(const ContactLimits& limits, const ContactFrame& contact, const Eigen::Matrix<double, 6, 1>& direction,
             double most) {
  const auto bears = [&](double multiple) { return limits.admits(contact, loaded(contact, multiple, direction), 1e-12); };
  if (!bears(1e-9)) return 0.0;
  if (bears(most)) return most;
  double within = 1e-9, beyond = most;
  while (beyond - within > 1e-10 * beyond) {
    const double middle = 0.5 * (within + beyond);
    (bears(middle) ? within : beyond) = middle;
  }
  return within;
}

}  // namespace preshape::conformance
