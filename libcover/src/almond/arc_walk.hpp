// Which triangles of the region's triangulation each almond reaches, and which vertices its arc
// meets.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "almond/almond.hpp"
#include "cdt/triangulation.hpp"

namespace cover {

/// A vertex of a circle, by identity.
struct KnownVertex {
  std::uint32_t vertex = 0;
  double ratio = 0;  ///< on the arc; 0 at u, infinity at v
};

/// What the almonds reach.
struct Reach {
  std::vector<std::uint32_t> first_known;    ///< by almond, into `known`; one more at the end
  std::vector<KnownVertex> known;            ///< u, the vertices inside the arc, v
  std::vector<std::uint32_t> first_visitor;  ///< by triangle, into `visitors`; one more at the end
  std::vector<std::uint32_t> visitors;       ///< almonds whose inside meets the triangle, ascending
  std::vector<std::array<std::uint32_t, 2>> cuts;  ///< (almond, side that passes through it)

  [[nodiscard]] std::span<const KnownVertex> known_of(std::uint32_t almond) const {
    return std::span(known).subspan(first_known[almond],
                                    first_known[almond + 1] - first_known[almond]);
  }
  [[nodiscard]] std::span<const std::uint32_t> visitors_of(std::uint32_t triangle) const {
    return std::span(visitors).subspan(first_visitor[triangle],
                                       first_visitor[triangle + 1] - first_visitor[triangle]);
  }
};

/// Walks from every side through the edges that cross the inside of its almond; locked edges stop
/// it.
///
/// A vertex whose distance from an arc is within the rounding error of its coordinates is taken to
/// lie on it: polygonised circles are full of them.
/// Cost: O(triangles visited), about two to six per almond
/// Ref:  mitchell_1993_covering, section 3
Reach walk_almonds(const Triangulation& cdt, std::span<const Almond> almonds);

}  // namespace cover
