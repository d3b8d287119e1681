// Whether triangles keep a bound on the largest angle.
#pragma once

#include <cstddef>
#include <span>

#include <cover/angle.hpp>
#include <cover/point.hpp>

#include "geom/topology/half_edges.hpp"

namespace cover {

/// True if every triangle keeps pi - angle >= nu_bound, up to angle_rounding() of that triangle.
bool holds_bound(std::span<const Point> points, std::span<const IndexTriple> triangles,
                 Angle nu_bound);

/// Triangles with an angle above `wanted`.
std::size_t count_above(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        Angle wanted);

}  // namespace cover
