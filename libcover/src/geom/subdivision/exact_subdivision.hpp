// Where segments cut each other, exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <cover/point.hpp>

#include "geom/subdivision/sweep_point.hpp"

namespace cover {

/// The common points of segments, and the way of each segment through them.
struct Subdivision {
  std::vector<Point> nodes;         ///< in lexicographic order before they were rounded
  std::vector<std::uint32_t> path;  ///< nodes, segment by segment, each from its smaller end on
  std::vector<std::size_t> first;   ///< of segment s: path[first[s], first[s + 1])
  /// Only by subdivide_and_snap(): at a place in the midst of so many lines within rounding of each
  /// other that it gave up. Nothing else counts then.
  std::optional<Point> crowd;

  [[nodiscard]] std::span<const std::uint32_t> path_of(std::size_t segment) const {
    return {path.data() + first[segment], first[segment + 1] - first[segment]};
  }
};

/// Cuts segments at all their common points: where they cross, touch, begin or end on each other,
/// and at the ends of what they share. A segment of length zero is a point that cuts what it lies
/// on; its path is its node, twice.
///
/// A node is rounded to the nearest doubles; but if one of the segments through it ends within two
/// units in the last place of that, it is taken for the nearest of their ends, unless some segment
/// ends at the rounded place itself. (Between two points so near to each other hardly any double is
/// left, so that a face there could not even be pointed at.)
/// EXACT:   what meets where, and in which order
/// ENSURES: where a node lies at an end after rounding, that end is a node with the very same
///          coordinates; consecutive nodes of a path are nearer to each other than the ends of the
///          segment, unless there are but two different ones.
/// Cost:    O((n + k) log n) for k common points, whatever the shape of the segments
/// Ref:     J. L. Bentley, T. A. Ottmann, IEEE Trans. Computers C-28 (1979); degenerate cases as in
///          M. de Berg et al., Computational Geometry (2008), sec. 2.1
Subdivision subdivide(std::span<const PlainSegment> segments);

/// The same, and each segment is led through the nodes that it passes at most two units in the last
/// place away from, unless they are nearly as near to one of its ends. So segments that lie next to
/// each other become one, where cutting them at their exact common points would go on for long.
///
/// Only crossings lead lines through them, with `to_ends` also ends of segments. Nodes are in no
/// order; some may be on no path.
/// ENSURES: as above; a path leads from one end of its segment to the other, also where a node on
///          it was rounded to a place beyond an end
/// Cost:    twice that of subdivide, and the number of segments at each node, of which a million
///          and a thousand more for each segment are looked at: n lines within rounding of each
///          other have up to n^2/2 nodes, each beside all of them. See Subdivision::crowd
Subdivision subdivide_and_snap(std::span<const PlainSegment> segments, bool to_ends);

}  // namespace cover
