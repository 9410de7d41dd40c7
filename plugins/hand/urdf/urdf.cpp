#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "document.h"
#include "fingers.h"
#include "preshape/base/error.h"
#include "preshape/plugin/entry.h"
#include "solids.h"

namespace {

using preshape::ParameterDeclaration;
using preshape::Pose;

/// A hand read from a URDF. Immutable once read.
class UrdfHand final : public preshape::HandModel {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::description("description", "the hand's table: file, base, sizes, fingers")};
  }

  static std::vector<std::string> capabilities() { return {"propagates_nonfinite"}; }

  explicit UrdfHand(const preshape::Parameters& parameters) {
    const auto description = preshape::urdf_hand::read_description(parameters.value("description"));
    const auto document = preshape::urdf_hand::read_document(description.file);
    dimensions_ = description.dimensions;
    fingers_ = preshape::urdf_hand::build_fingers(description, document);
    solids_ = preshape::urdf_hand::build_solids(description, document, fingers_);
  }

  const preshape::HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const preshape::Finger> fingers() const noexcept override { return fingers_.fingers; }
  std::span<const preshape::Joint> joints() const noexcept override { return fingers_.joints; }
  std::span<const preshape::LinkSolid> solids() const noexcept override { return solids_.solids; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    chain(finger).forward(q, poses_H);
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    chain(finger).jacobian(q, jacobian);
  }

  /// "hand/urdf/notes": a const std::vector<std::string>*, a sentence on each piece of geometry that was left
  /// out.
  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == "hand/urdf/notes" ? &solids_.notes : nullptr;
  }

 private:
  const preshape::Chain& chain(int finger) const {
    if (finger < 0 || finger >= static_cast<int>(fingers_.chains.size())) {
      throw preshape::InputError(
          fmt::format("the hand has fingers 0 .. {}, got {}", fingers_.chains.size() - 1, finger));
    }
    return fingers_.chains[static_cast<std::size_t>(finger)];
  }

  preshape::HandDimensions dimensions_;
  preshape::urdf_hand::Fingers fingers_;
  preshape::urdf_hand::Solids solids_;
};

}  // namespace

PRESHAPE_PLUGIN(({"urdf", "1.0.0", "BSD-3-Clause", "the preshape developers", "Hands given by a URDF"}),
                ({"hand/urdf"}),
                preshape::component<UrdfHand>("urdf", "Fingers of a URDF, named by a small Lua table"))
