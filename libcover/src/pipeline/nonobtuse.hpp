// The nonobtuse method: disk packing, with boundaries and interfaces split.
#pragma once

#include <vector>

#include <cover/options.hpp>
#include <cover/progress.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// Meshes every region without an angle above 90 degrees (up to snapping, see fill_disks.hpp) and
/// cuts the segments of `pslg` at the points that this puts on them; `table` and `boundaries`
/// follow.
///
/// Where no segment has regions on both sides, the packing has O(n) disks. Where regions share
/// segments, disks are centred on all segments first, so that both sides have the same points;
/// their number grows with the length of segments over the distance between them. Errors:
/// bad_option (with options.hull, or where segments of several regions come so close
///          that too many disks would be needed); cancelled; internal.
/// Threads: as mesh_regions().
/// Ref:     bmr_1995
Result<std::vector<RegionMesh>> mesh_nonobtuse(Pslg& pslg, RegionTable& table,
                                               std::vector<RegionBoundary>& boundaries,
                                               const Options& options, const Callbacks& callbacks);

}  // namespace cover
