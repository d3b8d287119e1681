// Sides whose coupling no mesh within the bound can keep.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/report.hpp>

#include "cdt/cdt.hpp"

namespace cover {

/// The sides among `negative` (indices into `sides`, free ones with a negative coupling) that a
/// proof says something of: the mesh holds a bound on angles, none of its inner edges is negative,
/// and any such mesh has a negative coupling on one of the sides of a certain set, which is another
/// one for each of those returned. So no mesh within the bound has fewer than these.
///
/// `beyond` are the triangles of the constrained Delaunay triangulation of the boundary that are
/// beyond the bound, by more than rounding: a mesh within the bound has a vertex in the circle of
/// each.
/// REQUIRES: no vertex of the boundary encroaches a free side
/// EXACT:    yes
/// Ref:      docs/box_method.md, "The same in small"
std::vector<std::uint32_t> forced_sides(std::span<const Point> points,
                                        std::span<const IndexPair> sides,
                                        const std::vector<bool>& is_free,
                                        std::span<const std::array<Point, 3>> beyond,
                                        std::span<const std::uint32_t> negative);

/// Tells of the couplings `given_up` of one region which of them the bound forces: these become
/// NegativeCoupling::Kind::forced. The rest is as for forced_sides().
void tell_forced(std::span<const Point> points, std::span<const IndexPair> sides,
                 const std::vector<bool>& is_free, std::span<const std::array<Point, 3>> beyond,
                 std::span<NegativeCoupling* const> given_up);

}  // namespace cover
