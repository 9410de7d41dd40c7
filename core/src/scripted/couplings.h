#pragma once

#include <string>
#include <vector>

#include "preshape/base/value.h"
#include "preshape/hand/hand_model.h"

namespace preshape::scripted {

/// Joints of a hand that follow others, noted as they are read and made once all joints are known: a joint may follow
/// one of any finger.
class Couplings {
 public:
  /// @param follows { joint =, ratio =, offset = } of the joint with index `follower`
  /// @param owner of the joint, in messages
  /// @throws ScriptError when a key is missing, misspelt or no number
  void note(const Value& follows, const SourcePlace& joint, const std::string& owner, int follower);

  /// Gives each follower its leader, ratio and offset.
  /// @throws ScriptError when a leader is none, follows itself or has no room left
  void make(std::vector<Joint>& joints) const;

 private:
  struct Coupling {
    int follower = -1;
    std::string leader;
    double ratio = 0.0, offset = 0.0;
    SourcePlace place;
    std::string owner;
  };

  static void couple(const Coupling& coupling, std::vector<Joint>& joints);
  static void demand_room(const Coupling& coupling, const std::vector<Joint>& joints);

  std::vector<Coupling> couplings_;
};

}  // namespace preshape::scripted
