// Cuts taken back: pieces become the segments that they were.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/pslg.hpp>
#include <cover/regions.hpp>

namespace cover {

/// Takes all points from `first` on out of `pslg`: they cut segments, whose pieces become one
/// again. Returns, by old segment, the one that it is a piece of.
///
/// REQUIRES: points from `first` on came from cut_segments(), and no segment is periodic
/// ENSURES:  cut_segments() with the same points gives the same segments, points and table
/// Cost:     O(n)
std::vector<std::uint32_t> unite_pieces(Pslg& pslg, RegionTable& table, std::size_t first);

}  // namespace cover
