// What a run works on, and what keeps it in step.
#pragma once

#include <memory>
#include <vector>

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "quality/fault/missed_targets.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// The value that travels from step to step of a run. Whoever cuts a segment keeps all parts in
/// step: points, regions, boundaries and meshes are of the same plane at any time.
struct Work : Prepared {
  std::vector<RegionBoundary> boundaries{};  ///< by region
  std::vector<RegionMesh> meshes{};          ///< by region; empty until they are meshed

  // Of the input, for the mesh when it is done.
  std::vector<PeriodicRule> rules{};          ///< of the options, then of the input
  std::shared_ptr<const PlaneField> field{};  ///< Input::field
};

/// Takes over the boundaries of the regions after segments were cut, and meshes the regions again
/// whose vertices are others now.
///
/// REQUIRES: `boundaries` are of work.pslg and work.table, which are cut already
/// Returns:  the regions that were meshed, by index
/// Errors:   those of mesh_regions(); `work` keeps its boundaries and meshes then
Result<std::vector<std::size_t>> mesh_changed(Work& work, std::vector<RegionBoundary> boundaries,
                                              const Options& options, const Callbacks& callbacks);

/// Reports and measures the meshes of all regions, after they were changed together.
void measure_again(Work& work, const Options& options, Unreached why = Unreached::unknown);

/// Whether no segments meet but at their ends, and the mesh of every region is one of its region,
/// see find_flaw().
bool is_sound(const Work& work);

}  // namespace cover
