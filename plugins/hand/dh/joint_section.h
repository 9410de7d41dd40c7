#pragma once

#include <memory>
#include <string>
#include <vector>

#include "preshape/hand/chain.h"
#include "preshape/hand/hand_model.h"
#include "section.h"

namespace preshape::dh {

/// The keys of a joint's table.
std::vector<ParameterDeclaration> joint_keys();

/// A joint as its table tells it, without its coupling. It is given by Denavit-Hartenberg parameters or by
/// its own frame and axis.
/// @param metres one length unit of the file [m]
/// @throws InputError on a mistake, and when a joint is given in both ways
Joint read_joint(const Section& section, double metres);
ChainJoint read_chain_joint(const Section& section, double metres);

/// The joints that follow others. A leader may come later in the file, so that couplings are made when all
/// joints are known.
class Couplings {
 public:
  /// Notes the coupling of joints[follower], if its table has one.
  void note(const Section& joint, int follower);

  /// Sets leader, ratio and offset of each follower.
  /// @throws InputError on a leader that is unknown, the joint itself, or a follower, and on one left without
  /// room
  void make(std::vector<Joint>& joints, double metres) const;

 private:
  struct Coupling {
    std::shared_ptr<const Value> table;  ///< what the section reads, kept: the finger that it came with is gone
    Section section;
    int follower = 0;
  };
  static void couple(const Coupling& coupling, std::vector<Joint>& joints, double metres);

  std::vector<Coupling> couplings_;
};

}  // namespace preshape::dh
