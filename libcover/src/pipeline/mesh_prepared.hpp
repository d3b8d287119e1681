// What follows once the regions are known.
#pragma once

#include <memory>
#include <vector>

#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/plane_field.hpp>
#include <cover/progress.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"
#include "tasks/stage_clock.hpp"

namespace cover {

/// The regions as pieces of work, with the sizes and layers that the options ask for.
///
/// Errors: those of sizes and layers; out_of_memory where `memory_counts` and the mesh would take
///         more than there is
Result<std::vector<RegionBoundary>> split_prepared(Prepared& prepared, const Options& options,
                                                   bool memory_counts, StageClock& clock);

/// Meshes, cuts again where that is asked for, stitches, and carries the values of `field`, if there
/// is one, to the vertices.
Result<Output> mesh_prepared(Prepared prepared, std::vector<RegionBoundary> boundaries,
                             const std::vector<PeriodicRule>& rules,
                             const std::shared_ptr<const PlaneField>& field, const Options& options,
                             const Callbacks& callbacks, StageClock& clock);

}  // namespace cover
