// Cuts taken back: pieces become the segments that they were.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

namespace cover {

/// What became of segments and points.
struct United {
  std::vector<std::uint32_t> whole;   ///< by old segment: the one that it is a piece of
  std::vector<std::uint32_t> number;  ///< by old point: its number; kNone: it cut a segment
};

/// Takes points from `first` on out of `pslg` that cut straight segments, whose pieces become one
/// again. Those on chords of arcs stay, in their order, also where these were made straight since:
/// pieces of a chord are no straight line.
///
/// REQUIRES: points from `first` on came from cut_segments(), and no segment is periodic
/// ENSURES:  cut_segments() with the same points gives the same segments, points and table, but for
///           the numbers of points on arcs
/// Cost:     O(n)
United unite_pieces(Pslg& pslg, RegionTable& table, std::size_t first);

}  // namespace cover
