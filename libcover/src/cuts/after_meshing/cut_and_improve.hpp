// Cutting segments where that helps triangles on both sides, with the mesh at hand.
#pragma once

#include <cstddef>

#include <cover/options.hpp>
#include <cover/result.hpp>

#include "cuts/after_meshing/mutable_joined_mesh.hpp"
#include "cuts/work.hpp"
#include "quality/effort/budget.hpp"

namespace cover {

/// What cut_and_improve left.
struct CutResult {
  std::size_t above = 0;        ///< triangles above the target
  bool budget_used_up = false;  ///< before all of them had been tried
  bool was_in_vain = false;     ///< it was given up, as most of what was tried mended nothing
};

/// Works on the triangles that are left above Options::max_angle by changing the mesh around them,
/// over segments too, and by cutting segments there: what `split_interfaces`, which sees no mesh,
/// cannot foresee.
///
/// REQUIRES: no hull sides; `joined` is made of `work`, for the angles of `options`
/// ENSURES:  `work` stays in step, but for the reports of its meshes; its boundaries keep what is
///           wished of them; no more triangles are above the target, and the largest angle grows at
///           most among those that count as alike (merit.hpp); at most as many points are added as
///           there were. `joined` is of `work` still unless it has_changed()
/// Errors:   those of boundaries_with_wishes(); `work` is as it was then
/// Cost:     O(n log n), and some milliseconds for each triangle that is left, until `budget` is
///           used up or, after the first 15 million evaluations, 150,000 mend none on average (one
///           takes 40,000 on maps and Voronoi cells, 400,000 where layers are too thin for any
///           mesh)
Result<CutResult> cut_and_improve(Work& work, MutableJoinedMesh& joined, const Options& options,
                                  Budget& budget);

}  // namespace cover
