// What a run works on.
#pragma once

#include <memory>
#include <vector>

#include <cover/output.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

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

}  // namespace cover
