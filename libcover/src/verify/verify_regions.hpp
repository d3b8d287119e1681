// Which region the triangles of a mesh belong to, by what they hang together with: for
// verify_cover().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/ids.hpp>
#include <cover/triangle_soup.hpp>

#include "base/none.hpp"
#include "geom/topology/soup_edges.hpp"
#include "verify/expected_domain.hpp"

namespace cover {

/// Triangles that hang together beside the sides of two regions.
struct TwoRegions {
  std::size_t edge = 0;  ///< on a side of `other`, index into SoupEdges::all()
  RegionId one, other;
};

/// The regions of triangles.
struct TriangleRegions {
  std::vector<RegionId> of;         ///< by triangle; kVoid: of none
  std::vector<TwoRegions> mixed;    ///< by edge
  std::vector<std::uint32_t> lost;  ///< triangles that hang together with no side, in edge order
  std::size_t count = 0;            ///< of regions that have triangles
};

/// Carries the regions of sides over all edges that are on none. By edge: `side_of` is an index
/// into domain.sides or kNone, `twins` as SoupEdges tells.
///
/// Cost: O(n log n)
TriangleRegions regions_of_triangles(const TriangleSoup& mesh, const SoupEdges& edges,
                                     std::span<const std::uint32_t> twins,
                                     std::span<const std::uint32_t> side_of,
                                     const ExpectedDomain& domain, const Team& team = {});

}  // namespace cover
