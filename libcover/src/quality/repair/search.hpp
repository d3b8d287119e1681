// Out of local optima: what improvement has left, tried again and again in excerpts.
#pragma once

#include "quality/effort/budget.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"

namespace cover {

/// Whether excerpts are triangulated anew at random.
enum class Restarts {
  none,
  at_last,  ///< once nothing else has helped: worth their time where few triangles are left
};

/// Tries, for every triangle that misses `goal`, several ways to make an excerpt around it better
/// as a whole, and goes on from there.
///
/// ENSURES: the goal of `mesh` is `goal`; neither the largest angle nor the number of triangles
///          above the goal has grown; the smallest angle is smaller only if one of these is, or
///          an excess over the goal, or the number of negative couplings.
///          The result does not depend on the team.
/// Cost:    an attempt looks at some dozens of triangles around, however many there are
void search_excerpts(MutableMesh& mesh, const Goal& goal, Budget& budget,
                     Restarts restarts = Restarts::none, const Sharing& sharing = {});

}  // namespace cover
