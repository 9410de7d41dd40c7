#include "couplings.h"

#include <algorithm>

#include <fmt/format.h>

#include "keys.h"
#include "preshape/base/suggest.h"
#include "preshape/hand/posture.h"

namespace preshape::scripted {

namespace {

constexpr double kMost = 1000.0;  // of ratio and offset, either way

}  // namespace

void Couplings::note(const Value& follows, const SourcePlace& joint, const std::string& owner, int follower) {
  const SourcePlace& place = place_of(follows, joint);
  const std::string what = owner + ", follows";
  const Keys keys{what,
                  {required_text("joint", "name of the joint that leads"),
                   required_number("ratio", -kMost, kMost, "-", "of the leader's value"),
                   ParameterDeclaration::number("offset", 0.0, -kMost, kMost, "rad or m",
                                                "joint value where the leader's is 0")},
                  {},
                  {},
                  {}};
  const Parameters p = keys.check(follows, place);
  if (p.number("ratio") == 0.0) refuse(place, what, "'ratio' must not be 0: such a joint would not move");
  couplings_.push_back({follower, p.text("joint"), p.number("ratio"), p.number("offset"), place, what});
}

void Couplings::make(std::vector<Joint>& joints) const {
  for (const Coupling& coupling : couplings_) couple(coupling, joints);
  for (const Coupling& coupling : couplings_) {
    const Joint& leader =
        joints[static_cast<std::size_t>(joints[static_cast<std::size_t>(coupling.follower)].leader)];
    if (leader.leader >= 0) {
      refuse(coupling.place, coupling.owner,
             fmt::format("'{}' itself follows '{}'; follow that one", leader.name,
                         joints[static_cast<std::size_t>(leader.leader)].name));
    }
    demand_room(coupling, joints);
  }
}

void Couplings::couple(const Coupling& coupling, std::vector<Joint>& joints) {
  Joint& follower = joints[static_cast<std::size_t>(coupling.follower)];
  if (coupling.leader == follower.name)
    refuse(coupling.place, coupling.owner, "'joint' is the joint itself; name another one");
  std::vector<std::string> others;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == coupling.leader) follower.leader = static_cast<int>(i);
    if (joints[i].name != follower.name) others.push_back(joints[i].name);
  }
  if (follower.leader < 0) {
    refuse(coupling.place, coupling.owner,
           fmt::format("'joint' names no joint of the hand, got '{}'{}", coupling.leader,
                       did_you_mean(coupling.leader, others)));
  }
  follower.ratio = coupling.ratio;
  follower.offset = coupling.offset;
}

/// What is left of the leader's range when its followers keep to theirs.
void Couplings::demand_room(const Coupling& coupling, const std::vector<Joint>& joints) {
  const int leader = joints[static_cast<std::size_t>(coupling.follower)].leader;
  const Joint& drive = joints[static_cast<std::size_t>(leader)];
  const DriveRange range = drive_range(joints, leader);
  if (range.lower < range.upper) return;
  refuse(coupling.place, coupling.owner,
         fmt::format("'{}' has no room left: its limits and those of the joints that follow it exclude each "
                     "other; mend limits, ratio or offset",
                     drive.name));
}

}  // namespace preshape::scripted
