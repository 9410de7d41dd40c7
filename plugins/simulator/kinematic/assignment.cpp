#include "assignment.h"

#include <algorithm>
#include <numeric>

#include "preshape/hand/posture.h"

namespace preshape::kinematic {

namespace {

/// Across the hand, +X first.
double place_of(const HandModel& hand, int finger) {
  return finger_poses(hand, finger, middle_posture(hand)).front().p.x();
}

/// Subsets of `count` of `all`, in their order.
void choose(const std::vector<int>& all, std::size_t count, std::size_t from, std::vector<int>& chosen,
            std::vector<std::vector<int>>& subsets) {
  if (chosen.size() == count) {
    subsets.push_back(chosen);
    return;
  }
  for (std::size_t i = from; i < all.size(); ++i) {
    chosen.push_back(all[i]);
    choose(all, count, i + 1, chosen, subsets);
    chosen.pop_back();
  }
}

struct Ranked {
  Assignment assignment;
  double spread = 0.0;   ///< how far the fingers would have to go sideways when the hand is centred [m]
  int other_roles = 0;
};

}  // namespace

std::vector<Assignment> assignments(const SimulationTask& task, const Eigen::Matrix3d& R_OH) {
  const auto fingers = task.hand.fingers();
  std::vector<int> forefingers;
  int thumb = -1;
  for (int i = 0; i < static_cast<int>(fingers.size()); ++i) {
    if (fingers[static_cast<std::size_t>(i)].role == FingerRole::kThumb) thumb = i;
    else forefingers.push_back(i);
  }
  const std::size_t needed = task.contacts.size() - 1;
  if (thumb < 0 || forefingers.size() < needed || needed < 1) return {};
  std::sort(forefingers.begin(), forefingers.end(), [&](int a, int b) { return place_of(task.hand, a) > place_of(task.hand, b); });

  const auto across = [&](std::size_t contact) { return R_OH.col(0).dot(task.contacts[contact].p_OC); };
  std::vector<std::size_t> order(needed);
  std::iota(order.begin(), order.end(), std::size_t{1});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return across(a) > across(b); });

  std::vector<std::vector<int>> subsets;
  std::vector<int> chosen;
  choose(forefingers, needed, 0, chosen, subsets);
  std::vector<Ranked> ranked;
  for (const auto& subset : subsets) {
    Ranked one{Assignment(task.contacts.size(), thumb), 0.0, 0};
    double middle = 0.0;
    for (std::size_t k = 0; k < needed; ++k) {
      one.assignment[order[k]] = subset[k];
      middle += (place_of(task.hand, subset[k]) - across(order[k])) / static_cast<double>(needed);
      one.other_roles += fingers[static_cast<std::size_t>(subset[k])].role != task.fingers[order[k]];
    }
    for (std::size_t k = 0; k < needed; ++k) {
      one.spread += std::abs(place_of(task.hand, subset[k]) - across(order[k]) - middle);
    }
    one.spread += std::abs(place_of(task.hand, thumb) - across(0) - middle);
    ranked.push_back(std::move(one));
  }
  constexpr double kAlike = 1e-6;
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::abs(a.spread - b.spread) > kAlike ? a.spread < b.spread : a.other_roles < b.other_roles;
  });
  std::vector<Assignment> all;
  for (auto& one : ranked) all.push_back(std::move(one.assignment));
  return all;
}

}  // namespace preshape::kinematic
