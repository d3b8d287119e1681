// Cutting segments where that helps triangles on both sides, with the mesh at hand.
#pragma once

#include <stop_token>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>

#include "quality/effort/budget.hpp"
#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// What cut_and_improve left.
struct CutResult {
  std::size_t above = 0;        ///< triangles above the target
  bool budget_used_up = false;  ///< before all of them had been tried
};

/// Works on the triangles that are left above Options::max_angle by changing the mesh around them,
/// over segments too, and by cutting segments there: what `split_interfaces`, which sees no mesh,
/// cannot foresee.
///
/// REQUIRES: no hull sides
/// ENSURES:  `pslg`, `table`, `boundaries` and `meshes` stay in step, but for the reports of the
///           meshes; neither the largest angle nor the number of triangles above the target grows;
///           at most as many points are added as there were
/// Cost:     O(n log n), and some milliseconds for each triangle that is left, until `budget` is
///           used up
CutResult cut_and_improve(Pslg& pslg, RegionTable& table, std::vector<RegionBoundary>& boundaries,
                          std::vector<RegionMesh>& meshes, const Options& options, Budget& budget);

}  // namespace cover
