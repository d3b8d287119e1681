// Tested by tests/unit/cuts/unite_pieces_test.cpp.
#include "cuts/unite_pieces.hpp"

#include <algorithm>
#include <utility>

#include "base/none.hpp"
#include "geom/curves/arc.hpp"

namespace cover {
namespace {

void unite(std::vector<SegmentId>& list, const std::vector<std::uint32_t>& whole) {
  for (SegmentId& s : list) s = SegmentId{whole[s.index()]};
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Takes out the points from `first` on that no chord of an arc has, nor one that was made straight
/// since: both of its halves may be, around a point on the arc. Returns the numbers of all.
std::vector<std::uint32_t> take_points_out(Pslg& pslg, std::size_t first) {
  std::vector<bool> stays(pslg.points.size(), false);
  std::fill_n(stays.begin(), first, true);
  for (const Segment& s : pslg.segments) {
    if (s.circle == 0) continue;
    stays[s.a.index()] = true;
    stays[s.b.index()] = true;
  }
  std::vector<std::uint32_t> number(pslg.points.size(), kNone);
  std::uint32_t next = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!stays[v]) continue;
    number[v] = next++;
    pslg.points[number[v]] = pslg.points[v];
    pslg.point_ids[number[v]] = pslg.point_ids[v];
    pslg.point_markers[number[v]] = pslg.point_markers[v];
  }
  pslg.points.resize(next);
  pslg.point_ids.resize(next);
  pslg.point_markers.resize(next);
  return number;
}

}  // namespace

United unite_pieces(Pslg& pslg, RegionTable& table, std::size_t first) {
  std::vector<std::uint32_t> number = take_points_out(pslg, first);
  std::vector<std::uint32_t> whole;
  std::vector<Segment> segments;
  std::vector<SegmentSides> sides;
  std::vector<std::array<std::uint32_t, 2>> seeds;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& piece = pslg.segments[s];
    if (number[piece.a.index()] == kNone) {  // pieces of a segment are consecutive
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
  for (NamedPoint& point : pslg.named_points)  // those of the input stay
    point.vertex = VertexId{number[point.vertex.index()]};
  pslg.segments = std::move(segments);
  pslg.side_seeds = std::move(seeds);
  table.sides = std::move(sides);
  for (Segment& s : pslg.segments) {
    s.a = VertexId{number[s.a.index()]};
    s.b = VertexId{number[s.b.index()]};
  }
  return {std::move(whole), std::move(number)};
}

}  // namespace cover
