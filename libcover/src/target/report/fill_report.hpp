// What the mesh of a region has reached, for its report.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/report.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// Fills in what the sides of a region allow at best: nu_opt, nu_bound, forced counts.
void set_bound(const AngleLimit& limit, RegionReport& report);

/// Fills `mesh.report` from the triangles: quality, box, numbers of vertices, and bound_held from
/// nu_bound. Where the bound is missed a note names the worst triangle.
///
/// REQUIRES: report.id and report.nu_bound are set; `across` is nothing, or what across_edges()
///           makes of the triangles
void fill_report(const RegionBoundary& boundary, RegionMesh& mesh, const Team& team = {},
                 std::vector<std::uint32_t> across = {});

}  // namespace cover
