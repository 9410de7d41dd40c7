#pragma once

#include <optional>

#include "preshape/grasp/approach_volume.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// The approach volume of the open hand before a grasp of the run; nothing where the simulation shows no
/// motion, or does not tell two fingers that hold.
std::optional<ApproachVolume> approach_volume_of(const RunRecord& record, const VirtualGrasp& grasp,
                                                 const Simulation& simulation);

}  // namespace preshape
