// Cutting segments where that helps triangles on both sides, with the mesh at hand.
#pragma once

#include <stop_token>
#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/report.hpp>

#include "covering/region_mesh.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// Works on the triangles that are left above Options::max_angle by changing the mesh around them,
/// over segments too, and by cutting segments there: what `split_interfaces`, which sees no mesh,
/// cannot foresee. Does nothing unless Options::split_interfaces is set. Returns whether it changed
/// anything: then the reports of the regions are to be made again.
///
/// ENSURES: `pslg`, `table`, `boundaries` and `meshes` stay in step; neither the largest angle nor
/// the number of triangles above the target grows; at most
///          as many points are added as there were; a note tells how many
/// Cost:    O(n), and some milliseconds for each triangle that is left
bool cut_and_improve(Pslg& pslg, RegionTable& table, std::vector<RegionBoundary>& boundaries,
                     std::vector<RegionMesh>& meshes, const Options& options, std::stop_token stop,
                     std::vector<Note>& notes);

}  // namespace cover
