// Triangles that are obtuse by little are made right by little.
#pragma once

#include <cstdint>
#include <span>

#include "geom/vector.hpp"
#include "mend/joined_mesh.hpp"

namespace cover {

/// A vertex on a line and another one on another line, which is always straight across: their edge
/// is at a right angle to the line of one of them.
struct FollowedVertex {
  std::uint32_t first, other;
  bool right_at_first;
};

/// The point of the line through `a` and `b` that is seen from `p` at a right angle to `along`.
Point straight_across(Point p, Vector along, Point a, Point b);

/// Moves vertices, each no further than it must, until no triangle is obtuse by more than rounding
/// or until that does not help; edges stay what they are. `pairs` go together.
///
/// ENSURES: the same mesh for the same input, whatever the machine
/// Returns: false, and nothing has changed, if a triangle would turn over
/// Cost:    at most 1,000 moves for each triangle
bool ease(std::span<const FollowedVertex> pairs, JoinedMesh& mesh);

}  // namespace cover
