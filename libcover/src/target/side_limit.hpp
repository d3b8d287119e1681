// What the input forces on the triangles at a side.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "base/team.hpp"
#include "cdt/sides.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// The corner between a side and the next, in cotangents. Either one triangle cuts it off, the ear,
/// or edges divide it: then one of the parts has at most half of the angle.
struct CornerLimit {
  double half_cot = 0;   ///< of half the angle; 0 from 90 degrees on
  double ear_large = 0;  ///< -cot of the largest angle of the ear
  double ear_cot = 0;    ///< cot of the smaller one of its two other angles
};

/// What the constrained Delaunay triangulation says about a side, in cotangents.
struct SideLimit {
  double apex_cot = 0;      ///< of gamma_opt: no triangle on the side has a smaller largest angle
  double smallest_cot = 0;  ///< of the smallest angle of the Delaunay triangle, which reaches that
  double slim_cot = 0;      ///< no triangle on the side has a larger smallest angle; at least 1
  std::array<CornerLimit, 2> corners{};  ///< at its ends
  /// A smaller cotangent opposite to the side is a negative coupling that counts; -inf: none does.
  double least_cot = -kInfinity;
  bool is_inner = false;  ///< it stands for an inner edge of a larger mesh
};

/// A limit that allows nothing.
inline constexpr SideLimit kNoLimit{kInfinity, 0, 0};

/// Lets the couplings of the sides count that no vertex encroaches: least_cot.
///
/// REQUIRES: as side_limits()
/// EXACT:    which sides these are
/// Ref:      docs/box_method.md, Theorem 1
void mind_free_sides(const Triangulation& cdt, std::span<const EdgeRef> side_at,
                     std::span<SideLimit> limits, const Team& team = {});

/// The limits of the sides, in the order of `side_at`.
///
/// REQUIRES: `cdt` is constrained Delaunay, its sides locked
/// Cost:     O(1) for most sides
/// Ref:      mitchell_1993_covering, Lemma 1, for the largest angle
std::vector<SideLimit> side_limits(const Triangulation& cdt, std::span<const EdgeRef> side_at,
                                   const Team& team = {});

}  // namespace cover
