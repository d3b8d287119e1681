// The regions of a PSLG and the way back: faces, nesting, void, materials, interfaces.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>
#include <cover/result.hpp>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// A region as part of the triangulation of everything, by VertexId.
struct TriangulatedRegion {
  RegionId id;
  std::vector<IndexTriple> triangles;
};

/// The regions, and the triangles that were found of them on the way.
struct TriangulatedTable {
  RegionTable table;
  std::vector<TriangulatedRegion> triangulated;
};

/// Finds regions, materials, names and interfaces. Warnings are appended to `notes`.
///
/// `whole` is the triangulation of the convex hull of `pslg`, if it is known: triangulate_hull().
///
/// Errors: nothing_enclosed, seed_in_void, seed_on_segment, conflicting_seeds.
/// Cost:   O(n log n).
Result<TriangulatedTable> build_triangulated_table(const Pslg& pslg, const Options& options,
                                                   std::vector<Note>& notes,
                                                   std::optional<Triangulation> whole,
                                                   const Team& team = {});

/// The regions alone.
Result<RegionTable> build_region_table(const Pslg& pslg, const Options& options,
                                       std::vector<Note>& notes);

/// One closed piece of work per region, by RegionId - 1.
///
/// Cost: O(n log n).
std::vector<RegionBoundary> split_regions(const Pslg& pslg, const RegionTable& table,
                                          const Team& team = {});

/// Hands their triangles over to the boundaries of regions (RegionBoundary::known_cdt), if the
/// points are still what they were.
void add_known_triangles(std::span<TriangulatedRegion> regions, std::size_t points,
                         std::span<RegionBoundary> boundaries, const Team& team = {});

}  // namespace cover
