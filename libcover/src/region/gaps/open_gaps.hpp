// Gaps between polygons that are parts of a wider void, as those that open to the outside.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/point.hpp>

#include "faces/faces.hpp"

namespace cover {

/// A part of a void where different polygons face each other.
struct OpenGap {
  double area = 0;
  double length = 0;       ///< of its walls together
  Point where;             ///< inside, where it is straight for longest
  std::uint32_t face = 0;  ///< the void there

  /// As wide as a strip of its area and length.
  [[nodiscard]] double width() const { return 2 * area / length; }
};

/// What open_gaps() asks of faces. By face.
struct FacesBeside {
  std::vector<double> width;         ///< as wide as a strip of its area and perimeter
  std::vector<std::uint32_t> owner;  ///< the polygon it belongs to; 0: it is void
  std::vector<bool> is_looked_at;    ///< voids that may have such gaps
};

/// The gaps that are narrow against the polygons beside them and go on for as long as these are
/// wide: so are borders that were drawn twice, but not streets and slots, nor round things that
/// nearly touch, nor notches where a border meets a coast.
///
/// Cost: O(n log n)
std::vector<OpenGap> open_gaps(const Faces& faces, const FacesBeside& beside);

}  // namespace cover
