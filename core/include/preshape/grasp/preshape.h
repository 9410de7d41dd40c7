#pragma once

#include <array>
#include <string>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/grasp/virtual_fingers.h"

namespace preshape {

/// The hand before contact, as the classifier names it: a value type.
struct Preshape {
  int plane = 0;             ///< 1.. as the tables number them; 0 = none
  int symbol = 0;            ///< approach symbol, 1.. (RwdH .. FwdH); 0 = none
  int virtual_fingers = 0;   ///< 1..3; 0 = none
  bool operator==(const Preshape&) const = default;
};

/// The preshape in the taxonomies of thesis chapter 2.
struct PreshapeTaxonomy {
  std::string opposition;  ///< Iberall, Bingham and Arbib: "pad opposition"
  std::string grasp;       ///< Napier: "precision"
  std::string type;        ///< Cutkosky: "thumb-two-finger"
};
PRESHAPE_API PreshapeTaxonomy taxonomy(const Preshape& preshape);

/// The binary code of a preshape (thesis fig. 3.22): bits of plane, then symbol, then finger count, the most
/// significant first; nine bits for 12 planes and 7 symbols. Codes outside the ranges name no preshape.
class PRESHAPE_API PreshapeCode {
 public:
  PreshapeCode(int planes, int symbols);

  int bits() const { return plane_bits_ + symbol_bits_ + kFingerBits; }
  Eigen::VectorXd encode(const Preshape& preshape) const;

  struct Decoding {
    Preshape preshape;
    double confidence = 0.0;  ///< likelihood of the code, given that it is a valid one
  };
  /// The likeliest valid code.
  /// @param bits probability of each bit being 1, bits() of them
  Decoding decode(const Eigen::Ref<const Eigen::VectorXd>& bits) const;

 private:
  static constexpr int kFingerBits = 2;
  int planes_, symbols_, plane_bits_, symbol_bits_;
};

}  // namespace preshape
