// What a method made of a region, measured, and whether it may be used.
#pragma once

#include <optional>
#include <stop_token>

#include "base/team.hpp"
#include "quality/quality_region.hpp"
#include "region/region_boundary.hpp"
#include "region/whole_mesh.hpp"

namespace cover {

/// A mesh, and why it does not fill its region, if it does not: then it has no triangles.
struct Attempt : ProvenMesh {
  std::optional<Flaw> flaw{};
};

/// What a method made of the region, measured, and its flaw. Neither if the run is to stop.
Attempt judged(ProvenMesh made, const RegionBoundary& boundary, const std::stop_token& stop,
               const Team& team);

}  // namespace cover
