// Stage C: disks that split cycles until none has more than four sides.
#pragma once

#include <span>
#include <vector>

#include "disks/packing/packing.hpp"

namespace cover::disks {

/// The sides of a cycle (all sides: kNone) that `disk` touches up to `tolerance` times the
/// smaller radius; those in `known` are taken as they are.
std::vector<Contact> touched_sides(const Packing& packing, Circle disk,
                                   std::span<const Contact> known, Index cycle, double tolerance);

/// Splits all cycles by disks that touch at least three sides, not just three consecutive ones.
///
/// REQUIRES: connect_holes() went through.
/// Returns false where rounding leaves a cycle of five or more sides without such a disk.
/// Cost:     at most m - 4 disks for a cycle of m sides; near O(m log m).
/// Ref:      bmr_1995; shrinking search and choice of disk are ours
bool reduce_cycles(Packing& packing, double tolerance);

}  // namespace cover::disks
