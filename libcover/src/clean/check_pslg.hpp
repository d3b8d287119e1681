// Whether points and segments are a PSLG, and if not, where.
#pragma once

#include <optional>

#include <cover/error.hpp>
#include <cover/input.hpp>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// What makes the points and segments of `input` unusable: an index out of range, or a coordinate
/// that is not finite or so large, or all so small, that lengths could not be multiplied.
///
/// Cost: O(n).
std::optional<Error> find_unusable(const Input& input);

/// The constrained Delaunay triangulation of the convex hull of `input`, if its points and segments
/// are a PSLG: triangulate_hull().
///
/// REQUIRES: find_unusable finds nothing
/// EXACT:    yes
/// Cost:     O(n log n) expected.
std::optional<Triangulation> triangulation_if_pslg(const Input& input, const Team& team = {});

/// What keeps the points and segments of `input` from being a PSLG: the first kind found of
/// duplicate points, segments of length zero, duplicate segments, and crossings, overlaps and
/// points on segments; with all its places.
///
/// REQUIRES: find_unusable finds nothing
/// EXACT:    yes
/// Cost:     O((n + k) log n) for k places.
std::optional<Error> find_unclean(const Input& input);

}  // namespace cover
