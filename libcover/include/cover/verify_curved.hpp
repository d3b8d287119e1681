// Checks the middle nodes of a mesh of second order, from plain arrays.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/verify.hpp>

namespace cover {

/// What was found.
struct CurvedVerification {
  std::vector<Violation> violations;  ///< empty: all is well; else the first ten
  std::size_t violation_count = 0;    ///< may exceed what is listed
  std::size_t on_arcs = 0;            ///< edges whose middle lies on the arc of their chord
  std::size_t straight = 0;           ///< edges that are chords of arcs and straight
};

/// Checks that the Jacobian of every triangle is positive everywhere, by the coefficients of
/// Bernstein's form; that triangles have one middle node on the edge between them; and that those
/// of edges that are segments of `pslg` lie on the arc, where the segment is a chord of one, or in
/// the middle of the segment.
///
/// REQUIRES: `middles` by triangle: of the edge from its first corner on, and so on; indices of
///           `mesh` in range
/// Cost:     O(n log n)
CurvedVerification verify_curved(const Pslg& pslg, const TriangleSoup& mesh,
                                 std::span<const std::array<Point, 3>> middles);

}  // namespace cover
