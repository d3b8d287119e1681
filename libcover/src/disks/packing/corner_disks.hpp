// Stage A: disks into the corners.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cdt/triangulation.hpp"
#include "disks/filler.hpp"
#include "disks/packing/packing.hpp"

namespace cover::disks {

/// Puts disks into every corner of the domain and around every isolated point, makes the right
/// triangles between a corner and its disks, and the cycles of sides.
///
/// Element k is the line of chord k; the disks follow.
/// REQUIRES: `packing.draft.points` are the points of `cdt`, up to translation and scale;
///           no chord is there in both directions (a slit); 0 < fraction < 1/2.
/// ENSURES:  no two lines are adjacent in a cycle; no two disks overlap. The packing has its index.
/// Returns pairs of disks of different cycles, one for every edge of `cdt` between these: they
/// connect all cycles of a connected domain.
/// Ref:     bmr_1995; number of disks by our own rule
std::vector<std::array<Index, 2>> place_corner_disks(Packing& packing, const Triangulation& cdt,
                                                     std::span<const Chord> chords,
                                                     double fraction);

}  // namespace cover::disks
