// Stage B: disks that join holes and isolated points to the outer boundary.
#pragma once

#include <array>
#include <span>

#include "disks/packing/packing.hpp"

namespace cover::disks {

/// Adds disks until all cycles that `pairs` connect are one.
///
/// `pairs`: elements of different cycles; as a graph on the cycles they connect each component of
/// the domain.
/// Returns false where rounding prevents it.
/// Cost: one query of the index per disk and per pair given up; near O(h log n) for h holes.
bool connect_holes(Packing& packing, std::span<const std::array<Index, 2>> pairs, double tolerance);

}  // namespace cover::disks
