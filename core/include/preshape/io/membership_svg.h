#pragma once

#include <string>

#include "preshape/fuzzy/partition_findings.h"

namespace preshape {

/// A drawing of fuzzy sets over their universe: a line and a label a set, the bound of completeness dashed, gaps shaded.
PRESHAPE_API std::string membership_svg(const FuzzyPartition& partition, const PartitionFindings& findings,
                                        const std::string& title);

}  // namespace preshape
