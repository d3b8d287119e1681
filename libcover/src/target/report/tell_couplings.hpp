// Which couplings of a region's mesh are negative, and why.
#pragma once

#include <span>
#include <vector>

#include <cover/point.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"
#include "target/report/measure_boxes.hpp"

namespace cover {

/// The edges of a region's mesh with a negative coupling; counted in `box`.
///
/// REQUIRES: `points` are all_points() of the mesh, `opposites` those of its triangles;
///           mesh.report.nu_bound is set
/// EXACT:    yes
/// Cost:     O(n), O(n log n) where a side has one
std::vector<NegativeCoupling> tell_couplings(const RegionBoundary& boundary, const RegionMesh& mesh,
                                             std::span<const Point> points,
                                             const Opposites& opposites, const Team& team,
                                             BoxMethod& box);

}  // namespace cover
