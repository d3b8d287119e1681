// Local improvement of the triangles that miss the goal.
#pragma once

#include <cstdint>

#include "quality/mutable_mesh.hpp"

namespace cover {

/// What an improvement did, and whether it was cut short.
struct ImproveResult {
  std::size_t flips = 0;
  std::size_t moves = 0;
  std::size_t removals = 0;
  std::size_t insertions = 0;
  std::uint64_t evaluations = 0;  ///< stars looked at: the unit of the budget
  bool budget_used_up = false;
};

/// Works on every triangle with a positive excess until none is left that can be made better, by
/// flip, relocation, removal and re-starring of a grown cavity with a new vertex, in this order.
///
/// Every step lowers the largest excess of the triangles that it touches, or lowers their number
/// and keeps it: monotone. A triangle for which nothing helped is forgotten until a triangle
/// beside it changes. Cost: at most `budget` star evaluations, each O(1).
ImproveResult improve(MutableMesh& mesh, std::uint64_t budget);

}  // namespace cover
