// Interfaces, outlines, slits and contacts: the segments of a PSLG by what they separate.
#pragma once

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

namespace cover {

/// Fills `table.interfaces` and the interface of each of `table.sides`.
///
/// Interfaces are ordered by left region, right region and name; the segments of each run along its
/// chains, from the end with the smallest coordinates.
/// REQUIRES: table.regions and the regions of table.sides are set
/// Cost:     O(n log n).
void build_interfaces(const Pslg& pslg, RegionTable& table);

}  // namespace cover
