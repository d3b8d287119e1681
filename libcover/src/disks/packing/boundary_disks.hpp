// Stage A where the boundary may not be split any more: disks centred on it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cdt/triangulation.hpp"
#include "disks/filler.hpp"
#include "disks/packing/packing.hpp"

namespace cover::disks {

/// Makes cycles of arcs of disks centred on the boundary. The domains on both sides of a chord see
/// the same disks and share their vertices, so no further point is needed on a chord.
///
/// `radii`, by vertex: the radius of the disk around it, or 0 where two disks touch. Along every
/// walk both take turns, and a disk's radius is the length of the chords that end in its centre.
/// REQUIRES: no two disks overlap. No chord is locked against it: none is split.
/// ENSURES, returns: as place_corner_disks(); there are no lines.
std::vector<std::array<Index, 2>> place_boundary_disks(Packing& packing, const Triangulation& cdt,
                                                       std::span<const Chord> chords,
                                                       std::span<const double> radii);

}  // namespace cover::disks
