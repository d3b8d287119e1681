// Judges the mesh of one region without the library's own measuring.
#pragma once

#include <string>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover::testing {

/// What is asked of a mesh.
struct RegionDemand {
  bool bound = true;  ///< promise 3 for report.nu_bound, up to rounding of the coordinates
};

/// Checks promises 1 to 3 on the mesh of one region: every triangle counter-clockwise (exactly),
/// every directed edge once, every side an edge, every other edge with a triangle on both sides,
/// every point of the boundary in use, area, and the bound. Together the first four prove that the
/// triangles cover the region once.
///
/// Returns an empty string, or a sentence about the first thing that is wrong.
std::string judge_region(const RegionBoundary& boundary, const RegionMesh& mesh,
                         const RegionDemand& demand = {});

/// pi minus the largest angle of the mesh, in radians, in extended precision.
long double smallest_nu(const RegionBoundary& boundary, const RegionMesh& mesh);

}  // namespace cover::testing
