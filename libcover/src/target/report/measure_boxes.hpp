// What a box method will meet on triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/point.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "cdt/cdt.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// What is known of half-edges, of which several measures need all.
struct Opposites {
  std::vector<double> cots;           ///< of the angle opposite
  std::vector<std::uint32_t> across;  ///< across_edges()
};

/// `across` is what across_edges() makes, if it is known.
Opposites opposites_of(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       std::span<const IndexPair> sides, const Team& team,
                       std::vector<std::uint32_t> across = {});

/// Box-method figures of `triangles`, but for negative couplings; `sides` are the directed sides of
/// their region.
///
/// A side is obtuse where the triangle on it is, opposite to it (geom/angle_rounding.hpp).
///
/// EXACT: the edges that are not Delaunay, but for sums of angles within 1e-9 radians of 180
///        degrees, which are left out; the area is rounded.
BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        std::span<const IndexPair> sides);
/// The same, from what is known.
BoxMethod measure_boxes(std::span<const Point> points, std::span<const IndexTriple> triangles,
                        const Opposites& opposites, const Team& team);

}  // namespace cover
