// The nonobtuse method: disk packing, with boundaries and interfaces split.
#pragma once

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "cuts/work.hpp"

namespace cover {

/// Meshes every region without an angle above 90 degrees (up to snapping, see fill_disks.hpp) and
/// cuts the segments at the points that this puts on them.
///
/// REQUIRES: `work` has boundaries and no meshes
/// Errors:   bad_option with options.hull; meshing_incomplete where segments of several regions
///           come so close that too many disks would be needed, or coordinates cannot tell points
///           on segments apart; cancelled; internal
/// Cost:     O(n) disks where no segment has regions on both sides. Where regions share segments,
///           disks are centred on all segments first, so that both sides have the same points;
///           their number grows with the length of segments over the distance between them
/// Threads:  as mesh_regions()
/// Ref:      bmr_1995
Status mesh_nonobtuse(Work& work, const Options& options, const Callbacks& callbacks);

}  // namespace cover
