#pragma once

#include <string>
#include <vector>

#include "preshape/contact/wrench_union.h"

namespace preshape {

/// What closing the fingers at a station would give (thesis sec. 3.5 to 3.7): an outcome, also when there is none.
struct VirtualGrasp {
  enum class Status { kGrasp, kNoSection, kMissed, kNoOpposition };

  Status status = Status::kNoSection;
  std::string detail;              ///< unless a grasp: one sentence
  int plane = 0;                   ///< index from 0
  double approach_m = 0.0;         ///< x: of the fingertips along a, from O
  double approach_fraction = 0.0;  ///< x over the half extent along a
  int virtual_fingers = 0;
  double transverse_fraction = 0.0;  ///< of the thumb from the middle of the section, over the section's half width
  double depth_m = 0.0;            ///< dynamic depth
  double opening_m = 0.0;          ///< between thumb and forefingers along the opposition axis
  std::vector<ContactFrame> contacts;     ///< thumb first
  std::vector<std::string> fingers;       ///< their names: thumb, index, middle, ring
  std::vector<Wrench> F_C_O;              ///< pattern wrenches about their contacts
  WrenchUnion wrench_union;               ///< about O, lengths normalised
  Wrench resultant;                       ///< W_n about O, normalised
  double stability = 0.0, manipulability = 0.0;
  std::vector<double> quality;            ///< all numbers of the quality measures, in their order

  bool is_grasp() const { return status == Status::kGrasp; }
};

}  // namespace preshape
