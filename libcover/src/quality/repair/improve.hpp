// Local improvement of the triangles that miss the goal.
#pragma once

#include <cstdint>
#include <span>

#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"

namespace cover {

/// What an improvement took, and whether it was cut short.
struct ImproveResult {
  std::uint64_t evaluations = 0;  ///< stars looked at: the unit of the budget
  bool budget_used_up = false;
};

/// Works on every triangle with a positive excess until none is left that can be made better, by
/// the moves flip, relocate, remove and restar, in this order.
///
/// Every step lowers the largest excess of the triangles that it replaces, or lowers their number
/// and keeps it. Without couplings of inner edges nothing else changes, so that the largest excess
/// never grows, and the work ends by itself. With them a step may raise the excess of triangles
/// beside those that it replaces: then Workplace::flips_left and the budget end what would go in
/// circles. A triangle for which nothing helped is forgotten until a triangle beside it changes.
/// Triangles whose excess is the same in `known` begin as forgotten: nothing helped them before.
///
/// Cost: at most `budget` star evaluations, each O(1)
ImproveResult improve(MutableMesh& mesh, std::uint64_t budget, std::span<const double> known = {});

/// What comes before improvement.
enum class Before { nothing, flips_to_delaunay };

/// The same, a large mesh in parts and then along their borders.
///
/// ENSURES: the same result for any team
ImproveResult improve(MutableMesh& mesh, std::uint64_t budget, std::span<const double> known,
                      const Sharing& sharing, Before before = Before::nothing);

}  // namespace cover
