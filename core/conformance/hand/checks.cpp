// The kinematics and the data of hand models: H01 and on.
#include <cmath>
#include <numbers>
#include <set>

#include "kinematics.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

// Of poses, per unit of rotation and of a finger's reach: a dozen products of matrices with entries of 1.
constexpr double kRounding = 1e-12;

/// Runs the check for each finger with random joint values.
void for_postures(Context& context, const HandModel& hand, int count, double share,
                  const std::function<std::string(int finger, const std::vector<double>& q, Random&)>& law) {
  Random random = context.random("postures");
  for (int finger = 0; finger < std::ssize(hand.fingers()); ++finger) {
    for (int i = 0; i < context.cases(count); ++i) {
      const auto q = posture(hand, finger, random, share);
      const std::string wrong = law(finger, q, random);
      context.require(wrong.empty(), "{}: {}", finger_text(hand, finger, q), wrong);
    }
  }
}

bool rigid(const Pose& X) {
  return X.p.allFinite() &&
         (X.R.transpose() * X.R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= kRounding * 10 &&
         X.R.determinant() > 0.0;
}

void h01_fingers_and_joints(Context& context) {
  const auto hand = context.create<HandModel>();
  const auto fingers = hand->fingers();
  const auto joints = hand->joints();
  context.require(!fingers.empty(), "it has no finger");
  std::set<std::string> names;
  std::set<FingerRole> roles;
  int next = 0;
  for (const Finger& f : fingers) {
    context.require(!f.name.empty() && names.insert(f.name).second,
                    "the finger's name '{}' is empty or there twice", f.name);
    context.require(roles.insert(f.role).second, "finger '{}' has the role of another one", f.name);
    context.require(f.first_joint == next && f.joint_count >= 0,
                    "finger '{}' has {} joints from {}, the one before ends at {}", f.name, f.joint_count,
                    f.first_joint, next);
    next += f.joint_count;
  }
  context.require(next == std::ssize(joints), "its fingers have {} joints, the hand {}", next, joints.size());
  std::set<std::string> joint_names;
  for (const Joint& j : joints) {
    context.require(!j.name.empty() && joint_names.insert(j.name).second,
                    "the joint's name '{}' is empty or there twice", j.name);
    context.require(std::isfinite(j.lower) && std::isfinite(j.upper) && j.lower < j.upper,
                    "joint '{}' has the limits {} .. {}", j.name, j.lower, j.upper);
    context.require(std::isnan(j.torque_limit) || j.torque_limit > 0.0, "joint '{}' has the torque limit {}",
                    j.name, j.torque_limit);
  }
  const HandDimensions& d = hand->dimensions();
  for (const double length : {d.unit_length_m, d.finger_spacing_m, d.maximum_opening_m, d.base_width_m}) {
    context.require(std::isfinite(length) && length > 0.0, "one of its dimensions is {} m", length);
  }
  context.require(fingers.data() == hand->fingers().data() && joints.data() == hand->joints().data(),
                  "asked again it names its fingers or joints in another place");
}

void h02_rigid_poses(Context& context) {
  const auto hand = context.create<HandModel>();
  for_postures(context, *hand, 200, 1.0, [&](int finger, const auto& q, Random&) -> std::string {
    const auto poses = poses_at(*hand, finger, q);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (!rigid(poses[k])) return fmt::format("pose {} is not rigid", k);
    }
    return "";
  });
}

void h03_continuous(Context& context) {
  const auto hand = context.create<HandModel>();
  constexpr double kStep = 1e-7;
  for_postures(context, *hand, 200, 1.0,
               [&](int finger, const std::vector<double>& near, Random& random) -> std::string {
                 auto q = near;
                 const auto joints = joints_of(*hand, finger);
                 const auto bent = random.below(std::max<std::size_t>(1, 2 * q.size()));
                 if (bent < q.size() && !joints[bent].prismatic) {  // where angles are often wrapped
                   q[bent] = std::numbers::pi * std::round(random.uniform(-2.5, 2.5));
                 }
                 auto before = q, after = q;
                 for (double& x : before) x -= kStep;
                 for (double& x : after) x += kStep;
                 const auto a = poses_at(*hand, finger, before), b = poses_at(*hand, finger, after);
                 // Each joint turns a frame along at most its reach, or slides it by its value; the axes may
                 // stand off the frames, hence the ten.
                 double most = 0.0;
                 for (const Joint& joint : joints)
                   most += 10.0 * 2.0 * kStep * (joint.prismatic ? std::max(1.0, 1.0 / reach(*hand, finger)) : 1.0);
                 for (std::size_t k = 0; k < a.size(); ++k) {
                   if (difference(a[k], b[k], reach(*hand, finger)) <= most) continue;
                   return fmt::format("pose {} jumps by {} m when each joint of {} moves by 2e-7", k,
                                      (a[k].p - b[k].p).norm(), finger_text(*hand, finger, q));
                 }
                 return "";
               });
}

void h05_product_of_exponentials(Context& context) {
  const auto hand = context.create<HandModel>();
  std::vector<std::vector<JointScrew>> screws;
  for (int finger = 0; finger < std::ssize(hand->fingers()); ++finger) {
    screws.push_back(measured_screws(*hand, finger));
    for (std::size_t i = 0; i < screws.back().size(); ++i) {
      context.require(screws.back()[i].flaw <= 100 * kRounding,
                      "joint '{}' does not {} an axis: it is {} off", joints_of(*hand, finger)[i].name,
                      screws.back()[i].prismatic ? "slide by its value along" : "turn by its value about",
                      screws.back()[i].flaw);
    }
  }
  for_postures(context, *hand, 200, 1.0, [&](int finger, const auto& q, Random&) -> std::string {
    const auto middle = middle_posture(*hand, finger);
    const auto rest = poses_at(*hand, finger, middle), poses = poses_at(*hand, finger, q);
    Pose product;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (k > 0 && k <= q.size())
        product = product * screws[static_cast<std::size_t>(finger)][k - 1].exp(q[k - 1] - middle[k - 1]);
      const double off = difference(poses[k], product * rest[k], reach(*hand, finger));
      if (!(off <= 1000 * kRounding))
        return fmt::format("pose {} is {} off the product of exponentials", k, off);
    }
    return "";
  });
}

void h06_jacobian(Context& context) {
  const auto hand = context.create<HandModel>();
  constexpr double kStep = 1e-5;  // truncation and rounding of the differences are about 1e-10 each
  for_postures(
      context, *hand, 100, 0.99, [&](int finger, const std::vector<double>& q, Random&) -> std::string {
        const auto jacobian = jacobian_at(*hand, finger, q);
        const Pose X = poses_at(*hand, finger, q).back();
        for (std::size_t i = 0; i < q.size(); ++i) {
          auto less = q, more = q;
          less[i] -= kStep, more[i] += kStep;
          const Pose a = poses_at(*hand, finger, less).back(), b = poses_at(*hand, finger, more).back();
          const Eigen::Vector3d linear = (b.p - a.p) / (2 * kStep);
          const Eigen::Matrix3d turning = (b.R - a.R) / (2 * kStep) * X.R.inverse();
          Eigen::Matrix<double, 6, 1> column;
          column << linear, turning(2, 1), turning(0, 2), turning(1, 0);
          const double off = (jacobian.col(static_cast<Eigen::Index>(i)) - column).cwiseAbs().maxCoeff();
          if (!(off <= 1e-7 * (1.0 + reach(*hand, finger)))) {
            return fmt::format(
                "column {} of the Jacobian is {} off the difference quotient of the tip's pose", i, off);
          }
        }
        return "";
      });
}

void h09_does_not_clamp(Context& context) {
  const auto hand = context.create<HandModel>();
  for (int finger = 0; finger < std::ssize(hand->fingers()); ++finger) {
    const auto joints = joints_of(*hand, finger);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      for (const bool upper : {false, true}) {
        Random random = context.random("postures");
        auto at = posture(*hand, finger, random), beyond = at;
        at[i] = upper ? joints[i].upper : joints[i].lower;
        beyond[i] = at[i] + (upper ? 0.3 : -0.3);
        const Pose a = poses_at(*hand, finger, at)[i + 1], b = poses_at(*hand, finger, beyond)[i + 1];
        const double moved = joints[i].prismatic
                                 ? (b.p - a.p).norm()
                                 : Eigen::AngleAxisd(Eigen::Matrix3d(a.R.transpose() * b.R)).angle();
        context.require(std::abs(moved - 0.3) < 1e-6,
                        "joint '{}' moves by {} when its value goes 0.3 beyond its limit {}", joints[i].name,
                        moved, at[i]);
      }
    }
  }
}

void h13_solids(Context& context) {
  const auto hand = context.create<HandModel>();
  const auto fingers = hand->fingers();
  const auto solids = hand->solids();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const LinkSolid& s = solids[i];
    context.require(s.finger >= -1 && s.finger < std::ssize(fingers), "solid {} is of finger {} of {}", i,
                    s.finger, fingers.size());
    const int links = s.finger < 0 ? 0 : fingers[static_cast<std::size_t>(s.finger)].joint_count;
    context.require(s.link >= 0 && s.link <= links, "solid {} is of link {} of {}", i, s.link, links);
    const bool box = s.solid.kind == Solid::Kind::kBox, capsule = s.solid.kind == Solid::Kind::kCapsule;
    const bool sized =
        box ? s.solid.half_extents.allFinite() && s.solid.half_extents.minCoeff() > 0.0
            : std::isfinite(s.solid.radius) && s.solid.radius > 0.0 &&
                  (!capsule || (std::isfinite(s.solid.half_length) && s.solid.half_length >= 0.0));
    context.require(sized, "solid {} has a size that is zero, negative or not finite", i);
    context.require(rigid(s.X_LS), "the pose of solid {} in its link is not rigid", i);
  }
  context.require(solids.data() == hand->solids().data(), "asked again it names its solids in another place");
}

/// The finger's poses seen from its base.
std::vector<Pose> from_base(const HandModel& hand, int finger, const std::vector<double>& q) {
  auto poses = poses_at(hand, finger, q);
  const Pose X_BH = poses.front().inverse();
  for (Pose& X : poses) X = X_BH * X;
  return poses;
}

void h16_identical_fingers(Context& context) {
  const auto hand = context.create<HandModel>();
  int first = -1;
  Random random = context.random("postures");
  for (int finger = 0; finger < std::ssize(hand->fingers()); ++finger) {
    if (hand->fingers()[static_cast<std::size_t>(finger)].role == FingerRole::kThumb) continue;
    if (first < 0) first = finger;
    const auto own = joints_of(*hand, finger), model = joints_of(*hand, first);
    context.require(own.size() == model.size(), "finger {} has {} joints, finger {} has {}", finger,
                    own.size(), first, model.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      context.require(own[i].prismatic == model[i].prismatic && own[i].lower == model[i].lower &&
                          own[i].upper == model[i].upper,
                      "joint '{}' is of another kind or has other limits than '{}'", own[i].name,
                      model[i].name);
    }
    for (int i = 0; i < 20; ++i) {
      const auto q = posture(*hand, first, random);
      const auto a = from_base(*hand, first, q), b = from_base(*hand, finger, q);
      for (std::size_t k = 0; k < a.size(); ++k) {
        const double off = difference(a[k], b[k], reach(*hand, first));
        context.require(off <= 1000 * kRounding,
                        "pose {} of finger {} is {} off that of finger {}, both from their bases", k, finger,
                        off, first);
      }
    }
  }
}

void h18_refuses_other_fingers(Context& context) {
  const auto hand = context.create<HandModel>();
  const int count = static_cast<int>(std::ssize(hand->fingers()));
  const auto joints = joints_of(*hand, 0).size();
  const auto refuses = [&](int finger, const char* what, const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError&) {
      return;
    }
    context.fail("{} of finger {} of {} is answered", what, finger, count);
  };
  for (const int finger : {-1, count, 1000000}) {
    const std::vector<double> q(joints, 0.0);
    refuses(finger, "the forward kinematics", [&] { poses_at(*hand, finger, q); });
    refuses(finger, "the Jacobian", [&] { jacobian_at(*hand, finger, q); });
  }
}

constexpr Check kChecks[] = {
    {"H01", "hand",
     "fingers and joints have names of their own, joints in order, limits and dimensions that are numbers",
     h01_fingers_and_joints},
    {"H02", "hand", "every pose of the forward kinematics is rigid", h02_rigid_poses},
    {"H03", "hand", "small changes of the joint values move every frame little, across half turns as well",
     h03_continuous},
    {"H05", "hand", "the poses are the product of the exponentials of the single joints' screws",
     h05_product_of_exponentials},
    {"H06", "hand", "the Jacobian is the difference quotient of the tip's pose, linear rows first",
     h06_jacobian},
    {"H09", "hand", "joint values beyond their limits are neither refused nor cut", h09_does_not_clamp},
    {"H13", "hand", "solids belong to a link that there is, with a size and a rigid pose", h13_solids},
    {"H16", "hand", "declared identical_fingers: all but the thumb have the same joints, limits and lengths",
     h16_identical_fingers, "identical_fingers"},
    {"H18", "hand", "a finger that there is not is refused", h18_refuses_other_fingers},
};

}  // namespace

std::span<const Check> hand_checks() {
  return kChecks;
}

}  // namespace preshape::conformance
