// From the constrained Delaunay triangulation to one that meets the goal, or comes close.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "limits/angles/angle_range.hpp"
#include "quality/effort/budget.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/blocks.hpp"
#include "sizes/size_field.hpp"

namespace cover {

/// How much each stage may spend, and what is searched between them. (Not the Effort of a run:
/// steps of one plan differ in this.)
enum class OptimiseEffort {
  little,  ///< improvement alone, and that is short
  normal,  ///< a search where few triangles are left, and not for long
  again,   ///< all that is left may be spent; a search wherever there is hope, within the budget
  all,     ///< the same, with more of a budget where few are left
};

/// What a triangulation has reached.
struct Optimised {
  Merit merit;
  std::optional<AngleRange>
      before_couplings;  ///< angles before couplings had their say, if they did
};

/// Refines and improves a constrained Delaunay triangulation. With wished sizes nothing is thinned
/// out.
///
/// REQUIRES: `mesh` is constrained Delaunay
/// ENSURES:  returns what was reached, by `goal`; nothing promises that it is better than before
Optimised optimise(MutableMesh& mesh, const Goal& goal, Budget& budget, const SizeField& sizes = {},
                   const Order& order = {}, OptimiseEffort how_hard = OptimiseEffort::all,
                   const Sharing& sharing = {});

/// The extreme angles of all triangles.
AngleRange angles_of(const MutableMesh& mesh, const Team& team = {});

/// Makes a triangulation constrained Delaunay, at the price of angles, and improves it again with
/// couplings before angles.
///
/// REQUIRES: `mesh` is improved
/// ENSURES:  returns what was reached, by `goal`; no coupling that counts is negative but for those
///           that the bound needs
/// Cost:     improvement takes `each` evaluations for each triangle, once or twice
Merit mind_couplings(MutableMesh& mesh, const Goal& goal, Budget& budget, OptimiseEffort how_hard,
                     const Sharing& sharing = {},
                     std::uint64_t each = std::numeric_limits<std::uint32_t>::max());

/// Improves any triangulation, with the largest angle before all else.
///
/// ENSURES: returns what was reached, by `goal`; the largest angle is no larger than before
Merit improve_largest(MutableMesh& mesh, const Goal& goal, Budget& budget,
                      const Sharing& sharing = {});

}  // namespace cover
