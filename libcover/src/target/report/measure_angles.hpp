// Angle statistics of triangles.
#pragma once

#include <span>

#include <cover/point.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// Angle statistics of `triangles`. The count of those above 120 degrees is exact; one is obtuse if
/// it is above 90 degrees by more than what rounding the coordinates of its corners can make
/// (geom/angle_rounding.hpp). Those that are above by less are counted beside, exactly.
Quality measure_angles(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       const Team& team = {});

/// Adds the statistics of other triangles.
void merge(Quality& sum, const Quality& part);

}  // namespace cover
