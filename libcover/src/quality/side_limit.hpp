// What the input forces on the triangles at a side.
#pragma once

#include <span>
#include <vector>

#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// What the constrained Delaunay triangulation says about a side, in cotangents.
struct SideLimit {
  double apex_cot = 0;      ///< of gamma_opt: no triangle on the side has a smaller largest angle
  double smallest_cot = 0;  ///< of the smallest angle of the Delaunay triangle, which reaches that
  double slim_cot = 0;      ///< no triangle on the side has a larger smallest angle; at least 1
};

/// The limits of the sides, in the order of `side_at`.
///
/// REQUIRES: `cdt` is constrained Delaunay, its sides locked
/// Cost:     O(1) for most sides
/// Ref:      mitchell_1993_covering, Lemma 1, for the largest angle
std::vector<SideLimit> side_limits(const Triangulation& cdt, std::span<const EdgeRef> side_at);

}  // namespace cover
