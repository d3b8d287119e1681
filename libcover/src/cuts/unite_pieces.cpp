// Tested by tests/unit/cuts/unite_pieces_test.cpp.
#include "cuts/unite_pieces.hpp"

#include <algorithm>

namespace cover {
namespace {

void unite(std::vector<SegmentId>& list, const std::vector<std::uint32_t>& whole) {
  for (SegmentId& s : list) s = SegmentId{whole[s.index()]};
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

std::vector<std::uint32_t> unite_pieces(Pslg& pslg, RegionTable& table, std::size_t first) {
  std::vector<std::uint32_t> whole;
  std::vector<Segment> segments;
  std::vector<SegmentSides> sides;
  std::vector<std::array<std::uint32_t, 2>> seeds;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& piece = pslg.segments[s];
    if (piece.a.index() >= first) {  // pieces of a segment are consecutive
      segments.back().b = piece.b;
      for (const RegionId r : {table.sides[s].left, table.sides[s].right}) {
        if (r != kVoid) --table.region(r).sides;
      }
    } else {
      segments.push_back(piece);
      sides.push_back(table.sides[s]);
      if (!pslg.side_seeds.empty()) seeds.push_back(pslg.side_seeds[s]);
    }
    whole.push_back(static_cast<std::uint32_t>(segments.size() - 1));
  }
  for (Interface& line : table.interfaces) unite(line.segments, whole);
  unite(table.void_segments, whole);
  pslg.segments = std::move(segments);
  pslg.side_seeds = std::move(seeds);
  table.sides = std::move(sides);
  pslg.points.resize(first);
  pslg.point_ids.resize(first);
  pslg.point_markers.resize(first);
  return whole;
}

}  // namespace cover
