// The faces of a PSLG: what its segments cut the plane into.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/team.hpp"
#include "cdt/cdt.hpp"

namespace cover {

/// The unbounded face.
inline constexpr std::uint32_t kOutside = 0;

/// The faces, numbered from 1, over a triangulation of the convex hull. Face 0 is the outside.
struct Faces {
  Triangulation triangulation;
  std::vector<std::uint32_t> of_triangle;                ///< the face of each triangle
  std::vector<std::array<std::uint32_t, 2>> of_segment;  ///< on its left and right, from a to b
  std::vector<bool> open;  ///< by face: reaches the convex hull where no segment is
  std::size_t count = 1;   ///< faces and the outside
};

/// Finds the faces. Without `hull` open faces belong to the outside; with it the outside begins
/// beyond the convex hull.
///
/// REQUIRES: points and segments are a PSLG
/// EXACT:    yes
/// Cost:     O(n log n) expected.
Faces find_faces(std::span<const Point> points, std::span<const IndexPair> segments, bool hull);

/// The same over a triangulation that is there already, with the segments as its locked edges.
///
/// Cost: O(n log n).
Faces faces_of(Triangulation triangulation, std::span<const IndexPair> segments, bool hull,
               const Team& team = {});

}  // namespace cover
