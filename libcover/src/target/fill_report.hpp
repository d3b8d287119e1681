// What a triangulation has reached, for reports: angles, and what a box method will meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/report.hpp>

#include "base/team.hpp"
#include "geom/topology/half_edges.hpp"
#include "region/region_boundary.hpp"
#include "target/angle_limit.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// Angle statistics of `triangles`. The count of those above 120 degrees is exact; one is obtuse if
/// it is above 90 degrees by more than what rounding the coordinates of its corners can make
/// (geom/angle_rounding.hpp). Those that are above by less are counted beside, exactly.
Quality measure_angles(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       const Team& team = {});

/// Box-method figures of `triangles`, but for negative couplings; `sides` are the directed sides of
/// their region.
///
/// A side is obtuse where the triangle on it is, opposite to it (geom/angle_rounding.hpp).
///
/// EXACT: the edges that are not Delaunay, but for sums of angles within 1e-9 radians of 180
///        degrees, which are left out; the area is rounded.
BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        std::span<const IndexPair> sides);

/// Adds the statistics of other triangles.
void merge(Quality& sum, const Quality& part);

/// True if every triangle keeps pi - angle >= nu_bound, up to angle_rounding() of that triangle.
bool holds_bound(std::span<const Point> points, std::span<const IndexTriple> triangles,
                 Angle nu_bound);

/// Triangles with an angle above `wanted`.
std::size_t count_above(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        Angle wanted);

/// Fills in what the sides of a region allow at best: nu_opt, nu_bound, forced counts.
void set_limits(const AngleLimit& limit, RegionReport& report);

/// Fills `mesh.report` from the triangles: quality, box, numbers of vertices, and bound_held from
/// nu_bound. Where the bound is missed a note names the worst triangle.
///
/// REQUIRES: report.id and report.nu_bound are set; `across` is nothing, or what across_edges()
///           makes of the triangles
void fill_report(const RegionBoundary& boundary, RegionMesh& mesh, const Team& team = {},
                 std::vector<std::uint32_t> across = {});

}  // namespace cover
