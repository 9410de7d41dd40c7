#include <fmt/format.h>

#include "hand_description.h"
#include "preshape/base/error.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ParameterDeclaration;
using preshape::Pose;

/// A hand of serial chains given by Denavit-Hartenberg parameters (thesis sec. 4.4). Immutable once read.
class DhHand final : public preshape::HandModel {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::description("description", "the hand's table: sizes, palm, fingers")};
  }

  static std::vector<std::string> capabilities() { return {"propagates_nonfinite"}; }

  explicit DhHand(const preshape::Parameters& parameters)
      : hand_(preshape::dh::read_hand(parameters.value("description"))) {}

  const preshape::HandDimensions& dimensions() const noexcept override { return hand_.dimensions; }
  std::span<const preshape::Finger> fingers() const noexcept override { return hand_.fingers; }
  std::span<const preshape::Joint> joints() const noexcept override { return hand_.joints; }
  std::span<const preshape::LinkSolid> solids() const noexcept override { return hand_.solids; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    chain(finger).forward(q, poses_H);
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    chain(finger).jacobian(q, jacobian);
  }

 private:
  const preshape::Chain& chain(int finger) const {
    if (finger < 0 || finger >= static_cast<int>(hand_.chains.size())) {
      throw preshape::InputError(fmt::format("the hand has fingers 0 .. {}, got {}", hand_.chains.size() - 1, finger));
    }
    return hand_.chains[static_cast<std::size_t>(finger)];
  }

  preshape::dh::HandDescription hand_;
};

}  // namespace

PRESHAPE_PLUGIN(({"dh", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Hands given by Denavit-Hartenberg parameters"}),
                ({"hand/dh"}),
                preshape::component<DhHand>("dh", "Serial fingers by standard Denavit-Hartenberg parameters"))
