// Sides on which the input itself forces a negative coupling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cdt/sides.hpp"

namespace cover {

/// A side and a vertex in its open diametral disk that is visible from it.
struct EncroachedSide {
  std::size_t side = 0;
  std::uint32_t vertex = 0;  ///< the one that sees the side under the largest angle
};

/// The sides that a vertex encroaches, in order. No mesh of the region that keeps them whole is
/// without a negative coupling on each of them; one that cuts just them may be.
///
/// REQUIRES: `cdt` is the constrained Delaunay triangulation of the domain left of `sides`, which
///           are in lexicographic order; `at` is locate_sides() of both
/// EXACT:    yes
/// Cost:     O(sides)
/// Ref:      docs/box_method.md, Theorem 1
std::vector<EncroachedSide> encroached_sides(const Triangulation& cdt, std::span<const EdgeRef> at);

/// By side: whether no vertex encroaches it.
std::vector<bool> free_sides(const Triangulation& cdt, std::span<const EdgeRef> at);

}  // namespace cover
