// Where a point lies in a triangulation of a convex hull.
#pragma once

#include <cstdint>

#include "cdt/triangulation.hpp"

namespace cover {

/// Where a point lies.
struct Location {
  enum class Kind { inside, on_edge, on_vertex, outside };
  Kind kind = Kind::outside;
  std::uint32_t triangle = kNone;  ///< one that contains the point; none if outside
  Corner index;                    ///< edge or corner of the triangle
};

/// Finds points by walking; a walk starts where the last one ended.
class Locator {
 public:
  /// REQUIRES: `triangulation` outlives the locator and fills a convex polygon
  explicit Locator(const Triangulation& triangulation) : triangulation_(triangulation) {}

  /// EXACT: yes
  /// Cost:  the number of triangles on the way.
  Location locate(Point p);

 private:
  const Triangulation& triangulation_;
  std::uint32_t last_ = 0;
  std::uint64_t state_ = 1;  ///< of the generator that keeps walks from going round in circles
};

}  // namespace cover
