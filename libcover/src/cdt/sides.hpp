// Where the sides of a region lie in its triangulation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "cdt/cdt.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// A directed edge of a triangulation: edge `edge` of triangle `triangle`, which lies on its left.
struct EdgeRef {
  std::uint32_t triangle = kNone;  ///< kNone: the pair is no edge with a triangle on its left
  Corner edge;
};

/// The triangle on the left of each directed side.
///
/// A side of points that the triangulation has not is nowhere.
/// REQUIRES: `sides` in lexicographic order
/// Cost:     O(triangles + sides), for the few sides that usually leave a vertex
std::vector<EdgeRef> locate_sides(const Triangulation& cdt, std::span<const IndexPair> sides,
                                  const Team& team = {});

}  // namespace cover
