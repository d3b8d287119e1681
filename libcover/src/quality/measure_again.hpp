// What is told of a region whose mesh was changed after it had been meshed.
#pragma once

#include <cover/options.hpp>

#include "quality/fault/missed_targets.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// Limits and notes on missed targets of a region whose boundary and mesh were changed after they
/// were reported; `why` nothing better was found. Its other notes stay.
void report_again(const RegionBoundary& boundary, const Options& options, Unreached why,
                  RegionMesh& mesh);

/// Reports so and measures a mesh that was changed after that was done.
void measure_again(const RegionBoundary& boundary, const Options& options, Unreached why,
                   RegionMesh& mesh);

}  // namespace cover
