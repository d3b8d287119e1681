// Tested by tests/unit/cuts/cut_segments_test.cpp.
#include "cuts/cut_segments.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "cdt/sides.hpp"
#include "geom/curves/arc.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The pieces of every old segment, as a range of new ids.
using Pieces = std::vector<std::pair<std::size_t, std::size_t>>;

/// Replaces segments by their pieces. `against[k]`: list entry k runs from b to a.
void replace(std::vector<SegmentId>& list, const Pieces& pieces, const std::vector<bool>& against) {
  std::vector<SegmentId> out;
  for (const SegmentId s : list) {
    const auto [first, last] = pieces[s.index()];
    for (std::size_t k = first; k < last; ++k) {
      out.emplace_back(against[s.index()] ? last - 1 - (k - first) : k);
    }
  }
  list = std::move(out);
}

/// Pairs of pieces. A pair whose segments are not cut alike is dropped.
std::vector<SegmentPair> pairs_of_pieces(const std::vector<SegmentPair>& pairs,
                                         const Pieces& pieces) {
  std::vector<SegmentPair> out;
  for (SegmentPair pair : pairs) {
    const auto [from, from_end] = pieces[pair.from.index()];
    const auto [to, to_end] = pieces[pair.to.index()];
    const std::size_t count = from_end - from;
    if (to_end - to != count) continue;
    for (std::size_t k = 0; k < count; ++k) {
      pair.from = SegmentId{from + k};
      pair.to = SegmentId{pair.turned ? to_end - 1 - k : to + k};
      out.push_back(pair);
    }
  }
  return out;
}

/// What a region on the left of a chord loses where points beside it come in its place, and how
/// much longer the way is.
struct Bend {
  double area = 0;
  double length = 0;
};

Bend bend_of(Point a, Point b, const std::vector<Point>& points) {
  Bend bend{0, -length(b - a)};
  Point before = a;
  for (const Point p : points) {
    bend.area -= doubled_area(a, before, p) / 2;
    bend.length += length(p - before);
    before = p;
  }
  bend.area -= doubled_area(a, before, b) / 2;
  bend.length += length(b - before);
  return bend;
}

void apply_bend(const Bend& bend, const SegmentSides& sides, RegionTable& table) {
  if (sides.left != kVoid) table.region(sides.left).area -= bend.area;
  if (sides.right != kVoid) table.region(sides.right).area += bend.area;
  if (sides.interface != kNoInterface) table.interface(sides.interface).length += bend.length;
}

IndexPair ends_of(const Segment& s) { return {s.a.value(), s.b.value()}; }

/// By triangle: whether it belongs to a region, as the sides of segments tell.
std::vector<bool> triangles_of_regions(const Pslg& pslg, const RegionTable& table,
                                       const Triangulation& whole) {
  std::vector<IndexPair> sides;
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const auto [a, b] = ends_of(pslg.segments[s]);
    if (table.sides[s].left != kVoid) sides.push_back({a, b});
    if (table.sides[s].right != kVoid) sides.push_back({b, a});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<bool> is_reached(whole.triangles.size(), false);
  std::vector<std::uint32_t> reached;
  const auto reach = [&](std::uint32_t t) {
    if (t == kNone || is_reached[t]) return;
    is_reached[t] = true;
    reached.push_back(t);
  };
  for (const EdgeRef& at : locate_sides(whole, sides)) reach(at.triangle);
  while (!reached.empty()) {
    const Triangle& f = whole.triangles[reached.back()];
    reached.pop_back();
    for (const Corner i : kCorners) {
      if (!f.is_locked(i)) reach(f.n[i]);
    }
  }
  return is_reached;
}

/// Puts `points` on `segment`, in their order, and the pieces before the last one behind `pieces`.
/// Returns the last piece.
Segment put_points(Pslg& pslg, const Segment& segment, std::span<const Point> points,
                   std::vector<Segment>& pieces) {
  Segment piece = segment;
  for (const Point p : points) {
    piece.b = VertexId{pslg.points.size()};
    pslg.points.push_back(p);
    pslg.point_ids.push_back(-1);
    pslg.point_markers.push_back(piece.marker);
    pieces.push_back(piece);
    piece.a = piece.b;
  }
  piece.b = segment.b;
  return piece;
}

/// Replaces segments by their pieces in all lines between regions, and in the void.
///
/// REQUIRES: `table.sides` are those of the old segments
void replace_in_lines(RegionTable& table, const Pieces& pieces) {
  std::vector<bool> against(pieces.size(), false);
  for (const Interface& line : table.interfaces) {
    for (const SegmentId s : line.segments)
      against[s.index()] = table.sides[s.index()].left != line.left;
  }
  for (Interface& line : table.interfaces) replace(line.segments, pieces, against);
  replace(table.void_segments, pieces, against);
}

}  // namespace

PointsAlong along_segments(const Pslg& pslg, std::span<const PointOnSegment> points) {
  const auto along = [&](const PointOnSegment& on) {
    const Segment& segment = pslg.segments[on.segment.index()];
    const Point a = pslg.points[segment.a.index()], b = pslg.points[segment.b.index()];
    return dot(on.point - a, b - a);
  };
  PointsAlong result;
  result.order = sorted_numbers(points.size(), [&](std::uint32_t i, std::uint32_t k) {
    const PointOnSegment &x = points[i], &y = points[k];
    return x.segment != y.segment ? x.segment < y.segment : along(x) < along(y);
  });
  for (const std::uint32_t k : result.order) {
    const auto& [segment, point] = points[k];
    if (result.cuts.empty() || result.cuts.back().segment != segment)
      result.cuts.push_back({segment, {}});
    result.cuts.back().points.push_back(point);
  }
  return result;
}

void cut_segments(Pslg& pslg, RegionTable& table, std::span<const SegmentCut> cuts) {
  std::vector<Segment> segments;
  std::vector<SegmentSides> sides;
  std::vector<std::array<std::uint32_t, 2>> seeds;
  Pieces pieces;
  auto cut = cuts.begin();
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const std::size_t first = segments.size();
    Segment last_piece = pslg.segments[s];
    if (cut != cuts.end() && cut->segment.index() == s) {
      if (circle_of(pslg, last_piece) != nullptr)
        apply_bend(bend_of(pslg.points[last_piece.a.index()], pslg.points[last_piece.b.index()],
                           cut->points),
                   table.sides[s], table);
      last_piece = put_points(pslg, last_piece, cut->points, segments);
      ++cut;
    }
    segments.push_back(last_piece);
    sides.resize(segments.size(), table.sides[s]);
    if (!pslg.side_seeds.empty()) seeds.resize(segments.size(), pslg.side_seeds[s]);
    pieces.emplace_back(first, segments.size());
    const std::size_t added = segments.size() - first - 1;
    for (const RegionId r : {table.sides[s].left, table.sides[s].right}) {
      if (r != kVoid) table.region(r).sides += added;
    }
  }
  replace_in_lines(table, pieces);
  pslg.segments = std::move(segments);
  pslg.side_seeds = std::move(seeds);
  pslg.periodic = pairs_of_pieces(pslg.periodic, pieces);
  table.sides = std::move(sides);
}

CdtResult triangulate_whole(const Pslg& pslg) {
  std::vector<IndexPair> segments;
  segments.reserve(pslg.segments.size());
  for (const Segment& s : pslg.segments) segments.push_back(ends_of(s));
  return triangulate_hull(pslg.points, segments);
}

std::vector<VertexId> void_in_regions(const Pslg& pslg, const RegionTable& table,
                                      const Triangulation& whole) {
  if (table.void_points.empty() && table.void_segments.empty()) return {};
  const std::vector<bool> is_in_region = triangles_of_regions(pslg, table, whole);
  std::vector<bool> is_touched(pslg.points.size(), false);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    if (!is_in_region[t]) continue;
    for (const std::uint32_t v : whole.triangles[t].v) is_touched[v] = true;
  }
  std::vector<VertexId> found;
  for (const VertexId v : table.void_points) {
    if (is_touched[v.index()]) found.push_back(v);
  }
  std::vector<IndexPair> sides;
  for (const SegmentId s : table.void_segments) {
    const auto [a, b] = ends_of(pslg.segments[s.index()]);
    sides.insert(sides.end(), {{a, b}, {b, a}});
  }
  std::sort(sides.begin(), sides.end());
  const std::vector<EdgeRef> at = locate_sides(whole, sides);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (at[s].triangle == kNone || !is_in_region[at[s].triangle]) continue;
    for (const std::uint32_t v : sides[s]) found.emplace_back(v);
  }
  sort_unique(found);
  return found;
}

Status check_cuts(const Pslg& pslg, const RegionTable& table, std::size_t uncut_points) {
  if (pslg.points.size() == uncut_points) return ok();
  const CdtResult whole = triangulate_whole(pslg);
  const std::vector<CdtConflict>& conflicts = whole.conflicts;
  if (conflicts.empty()) {
    const std::vector<VertexId> passed = void_in_regions(pslg, table, whole.triangulation);
    if (passed.empty()) return ok();
    const Point at = pslg.points[passed[0].index()];
    return Error{ErrorCode::meshing_incomplete,
                 fmt::format("a cut segment would pass the point {}, which lies in the void as "
                             "near to it as rounding; --weld closes such gaps",
                             describe(at)),
                 {at},
                 {}};
  }
  const CdtConflict& first = conflicts.front();
  const bool is_point = first.kind != CdtConflict::Kind::crossing;
  const VertexId v = is_point ? VertexId{first.first} : pslg.segments[first.first].a;
  const Point at = pslg.points[v.index()];
  return Error{ErrorCode::meshing_incomplete,
               fmt::format("cut segments would meet near {}, where the void between them is as "
                           "narrow as rounding; --weld closes such gaps",
                           describe(at)),
               {at},
               {}};
}

}  // namespace cover
