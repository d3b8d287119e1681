// The room that a layer asks for: convex cells that must not overlap anything else.
#pragma once

#include <array>
#include <span>

#include <cover/point.hpp>

#include "geom/search/box_tree.hpp"

namespace cover::layers {

/// A convex polygon of one to four corners: a point, a piece of a side, or a cell of a layer.
struct Guard {
  std::array<Point, 4> corners{};
  int count = 0;

  Guard() = default;
  Guard(std::initializer_list<Point> points) {
    for (const Point& p : points) corners[static_cast<std::size_t>(count++)] = p;
  }
  [[nodiscard]] std::span<const Point> points() const {
    return {corners.data(), static_cast<std::size_t>(count)};
  }
  [[nodiscard]] Box box() const;
};

/// Whether two guards overlap by more than a millionth of `cell`'s extent in every direction that
/// could part them: cells that only touch do not. By rounded arithmetic, since cells are larger
/// than the layers by far more; what comes of it is checked exactly.
///
/// REQUIRES: `cell` has three corners or more
bool overlap(const Guard& cell, const Guard& other);

}  // namespace cover::layers
