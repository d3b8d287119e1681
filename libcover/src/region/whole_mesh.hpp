// Whether triangles fill a region.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cover/ids.hpp>
#include <cover/point.hpp>

#include "base/team.hpp"
#include "cdt/region_cdt.hpp"
#include "geom/topology/half_edges.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Triangles, and the boundary that they should have.
struct MeshOfRegion {
  std::span<const Point> points;  ///< those of the boundary first
  std::span<const IndexTriple> triangles;
  std::span<const IndexPair> sides;     ///< in lexicographic order
  std::span<const SegmentId> segments;  ///< by side
  std::size_t boundary_points = 0;
};

/// Why the triangles do not fill the region once, if they do not: one is not counter-clockwise, a
/// side is no edge, an edge on the outside is no side, an edge occurs twice, a point of the
/// boundary has no triangle. Sides of the hull may be split, by points near them.
///
/// ENSURES: if there is no flaw, `across`, unless null, is what across_edges() would make
/// EXACT:   yes, up to where the points on split sides of the hull lie
/// Cost:    O(triangles), for the few edges that a vertex usually has
std::optional<Flaw> find_flaw(const MeshOfRegion& mesh, const Team& team = {},
                              std::vector<std::uint32_t>* across = nullptr);
std::optional<Flaw> find_flaw(const RegionBoundary& boundary, const RegionMesh& mesh);

}  // namespace cover
