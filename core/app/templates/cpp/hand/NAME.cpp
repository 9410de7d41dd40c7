#include <cmath>
#include <string>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/hand/chain.h"
#include "preshape/hand/hand_model.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

constexpr double kWidest = -0.5;  ///< [rad] of a finger's first joint, outward

/// A gripper: a thumb and one to three forefingers of two links each, which close towards each other. Frame H has its
/// origin in the middle of the palm, +Z away from the palm, +Y from the thumb to the forefingers; at q = 0 every finger
/// is stretched along +Z, and a positive q bends it inwards.
class @CLASS@ final : public HandModel {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::integer("forefingers", 2, 1, 3, "fingers", "fingers that oppose the thumb"),
            D::number("proximal", 0.06, 0.01, 0.5, "m", "length of the link at the palm"),
            D::number("distal", 0.045, 0.01, 0.5, "m", "length of the link with the fingertip"),
            D::number("radius", 0.007, 0.001, 0.009, "m", "radius of the links"),
            D::number("half_width", 0.05, 0.01, 0.5, "m", "finger bases from the middle of the palm"),
            D::number("spacing", 0.03, 0.02, 0.2, "m", "between neighbouring forefingers"),
            D::number("bend", 1.7, 0.1, 2.5, "rad", "most that a joint bends inwards"),
            D::number("unit", 0.03, 0.001, 1.0, "m", "U, by which objects and depths are measured")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "identical_fingers"}; }

  explicit @CLASS@(const Parameters& p) {
    const double proximal = p.number("proximal"), distal = p.number("distal"), half_width = p.number("half_width");
    const int forefingers = static_cast<int>(p.integer("forefingers"));
    dimensions_ = {p.number("unit"), p.number("spacing"), half_width + (proximal + distal) * std::sin(-kWidest),
                   2.0 * half_width};
    add_palm(half_width, p.number("radius"));
    add_finger("thumb", FingerRole::kThumb, {0, -half_width, 0}, p);
    static constexpr const char* kNames[] = {"index", "middle", "ring"};
    static constexpr FingerRole kRoles[] = {FingerRole::kIndex, FingerRole::kMiddle, FingerRole::kRing};
    for (int i = 0; i < forefingers; ++i) {
      const double x = (0.5 * (forefingers - 1) - i) * p.number("spacing");
      add_finger(kNames[i], kRoles[i], {x, half_width, 0}, p);
    }
  }

  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return fingers_; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return solids_; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    chain(finger, q).forward(q, poses_H);
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    chain(finger, q).jacobian(q, jacobian);
  }

 private:
  const Chain& chain(int finger, std::span<const double> q) const {
    if (finger < 0 || finger >= static_cast<int>(chains_.size())) {
      throw InputError("finger: expected 0 .. " + std::to_string(chains_.size() - 1) + ", got " + std::to_string(finger));
    }
    for (const double angle : q) {
      if (!std::isfinite(angle)) throw InputError("q: every joint value must be a finite number");
    }
    return chains_[static_cast<std::size_t>(finger)];
  }

  /// A box behind the finger bases, just clear of them.
  void add_palm(double half_width, double radius) {
    LinkSolid palm;
    palm.solid.kind = Solid::Kind::kBox;
    palm.solid.half_extents = {half_width, half_width + radius, 0.01};
    palm.X_LS.p = {0, 0, -0.01 - 1.5 * radius};
    solids_.push_back(palm);
  }

  /// Frames along a finger have x to its tip and z about its bending axis.
  void add_finger(const std::string& name, FingerRole role, const Eigen::Vector3d& p_HB, const Parameters& p) {
    const double inward = p_HB.y() < 0.0 ? 1.0 : -1.0;  // along H's y
    Pose X_HB;
    X_HB.R << 0, 0, -inward,  //
        0, inward, 0,         //
        1, 0, 0;
    X_HB.p = p_HB;
    ChainJoint proximal, distal;
    distal.X_PJ.p.x() = p.number("proximal");
    Pose X_LD;
    X_LD.p.x() = p.number("distal");

    const int index = static_cast<int>(chains_.size());
    chains_.emplace_back(X_HB, std::vector<ChainJoint>{proximal, distal}, X_LD);
    fingers_.push_back({name, role, static_cast<int>(joints_.size()), 2});
    const double unknown = std::nan("");
    joints_.push_back({name + "_proximal", false, kWidest, p.number("bend"), unknown});
    joints_.push_back({name + "_distal", false, 0.0, p.number("bend"), unknown});
    solids_.push_back(link(index, 1, p.number("proximal"), p.number("radius"), 0.0));
    solids_.push_back(link(index, 2, p.number("distal"), p.number("radius"), p.number("radius")));
  }

  /// A capsule along x of the link's frame; `tip` is cut from its far end, so that the fingertip is its foremost point.
  static LinkSolid link(int finger, int joint, double length, double radius, double tip) {
    LinkSolid link;
    link.finger = finger;
    link.link = joint;
    link.solid.kind = Solid::Kind::kCapsule;
    link.solid.radius = radius;
    link.solid.half_length = 0.5 * (length - tip);
    link.X_LS.R << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // the capsule's z is the link's x
    link.X_LS.p.x() = 0.5 * (length - tip);
    return link;
  }

  HandDimensions dimensions_;
  std::vector<Finger> fingers_;
  std::vector<Joint> joints_;
  std::vector<LinkSolid> solids_;
  std::vector<Chain> chains_;
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "A gripper given by its lengths"}),
                ({"hand/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Gripper of a thumb and one to three forefingers"))
