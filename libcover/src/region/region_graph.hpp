// The regions of a PSLG and the way back: faces, nesting, void, materials, interfaces.
#pragma once

#include <optional>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// Finds regions, materials, names and interfaces. Warnings are appended to `notes`.
///
/// `whole` is the triangulation of the convex hull of `pslg`, if it is known: triangulate_hull().
///
/// Errors: nothing_enclosed, seed_in_void, seed_on_segment, conflicting_seeds.
/// Cost:   O(n log n).
Result<RegionTable> build_region_table(const Pslg& pslg, const Options& options,
                                       std::vector<Note>& notes,
                                       std::optional<Triangulation> whole = std::nullopt);

/// One closed piece of work per region, by RegionId - 1.
///
/// Cost: O(n log n).
std::vector<RegionBoundary> split_regions(const Pslg& pslg, const RegionTable& table);

}  // namespace cover
