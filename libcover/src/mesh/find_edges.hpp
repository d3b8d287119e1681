// Edges of a mesh by their ends.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// The last half-edge (numbered as in HalfEdges) between the vertices of each pair, in either
/// direction; kNone where there is none, or its lower vertex is not below `vertices`.
///
/// Cost: O(triangles + pairs log pairs), memory for pairs and vertices
std::vector<std::uint32_t> find_edges(std::size_t vertices, std::span<const IndexTriple> triangles,
                                      std::span<const std::array<std::uint32_t, 2>> pairs,
                                      const Team& team = {});

}  // namespace cover
