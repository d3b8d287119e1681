// Who wins where polygons overlap.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>

#include "region/network.hpp"
#include "region/node_edges.hpp"

namespace cover {

/// What lies beside an edge, seen from its smaller to its larger index: a polygon, or kNoIndex for
/// the void.
using EdgeOwners = std::array<std::uint32_t, 2>;

/// By polygon: the first polygon that makes one region with it where they touch. With `merge` those
/// of equal material do, else those of equal material and equal given name.
std::vector<std::uint32_t> group_polygons(const std::vector<InputPolygon>& polygons, bool merge);

/// Decides for each edge which polygon owns the face on either side. A face is covered by the
/// polygons whose rings go round it an odd number of times; of these the one of the highest
/// priority wins, among equals the last or the first.
///
/// Errors: overlapping_polygons with Overlap::error where the winner is not told by priority.
/// EXACT:  on the edges given: parities are counted, nothing is measured
/// Cost:   O(n log n).
Result<std::vector<EdgeOwners>> paint(const Input& input, Overlap overlap, const Network& network,
                                      const EdgeGraph& graph);

}  // namespace cover
