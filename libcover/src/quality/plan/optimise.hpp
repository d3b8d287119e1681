// From the constrained Delaunay triangulation to one that meets the goal, or comes close.
#pragma once

#include <optional>

#include "limits/angles/angle_range.hpp"
#include "quality/effort/budget.hpp"
#include "quality/fault/merit.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"
#include "sizes/size_field.hpp"

namespace cover {

/// What is searched after improvement, and so how much each stage may spend.
enum class SearchAfter {
  nothing,  ///< improvement alone, and that is short
  few,      ///< where few triangles are left, and not for long
  hope,     ///< wherever there is hope: all that is left may be spent, within the budget
  all,      ///< the same, with more of a budget where few are left
};

/// How a triangulation is optimised.
struct HowToOptimise {
  const SizeField* sizes = nullptr;  ///< that are wished; none
  Order order{};
  SearchAfter search = SearchAfter::all;
  Sharing sharing{};
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
Optimised optimise(MutableMesh& mesh, const Goal& goal, Budget& budget,
                   const HowToOptimise& how = {});

/// Improves any triangulation, with the largest angle before all else.
///
/// ENSURES: returns what was reached, by `goal`; the largest angle is no larger than before
Merit improve_largest(MutableMesh& mesh, const Goal& goal, Budget& budget,
                      const Sharing& sharing = {});

}  // namespace cover
