// Sides are dealt out to their regions; then each region sorts its own. Vertices are sorted by
// their rank among all points, so that points are compared in one sort only, and then laid along a
// curve.
// Tested by tests/unit/region/split_regions_test.cpp.
#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>

#include "base/sort_by_team.hpp"
#include "cdt/region_cdt.hpp"
#include "geom/spatial_order.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

/// A side before it has local indices.
struct GlobalSide {
  VertexId from, to;
  SegmentId segment;
};

/// What one region is made of, in the order of the PSLG.
struct Pieces {
  std::vector<GlobalSide> sides;
  std::vector<VertexId> isolated;
};

std::vector<Pieces> deal_out(const Pslg& pslg, const RegionTable& table) {
  std::vector<Pieces> out(table.regions.size());
  const auto add = [&](RegionId region, VertexId from, VertexId to, SegmentId segment) {
    if (region != kVoid) out[region.index() - 1].sides.push_back({from, to, segment});
  };
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    add(table.sides[s].left, segment.a, segment.b, SegmentId{s});
    add(table.sides[s].right, segment.b, segment.a, SegmentId{s});
  }
  for (const HullSide& side : table.hull_sides) add(side.region, side.a, side.b, kHullSide);
  for (const IsolatedPoint& p : table.isolated_points) {
    out[p.region.index() - 1].isolated.push_back(p.vertex);
  }
  return out;
}

/// The place of every point in lexicographic order.
std::vector<std::uint32_t> ranks(const std::vector<Point>& points, const Team& team) {
  std::vector<std::uint32_t> order(points.size()), rank(points.size());
  std::iota(order.begin(), order.end(), 0U);
  // No two points are equal.
  sort_by_team(
      order, [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; }, team);
  for (std::uint32_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  return rank;
}

class BoundaryMaker {
 public:
  BoundaryMaker(const Pslg& pslg, const Team& team)
      : pslg_(pslg), team_(team), rank_(ranks(pslg.points, team)), local_(pslg.points.size()) {}

  RegionBoundary make(RegionId id, const Pieces& pieces) {
    RegionBoundary out;
    out.id = id;
    add_vertices(pieces, out);
    std::vector<std::pair<IndexPair, SegmentId>> sides;
    sides.reserve(pieces.sides.size());
    for (const GlobalSide& s : pieces.sides) {
      sides.push_back({{local_[s.from.index()], local_[s.to.index()]}, s.segment});
    }
    sort_by_team(sides, std::less(), team_);
    out.sides.reserve(sides.size());
    out.segments.reserve(sides.size());
    for (const auto& [side, segment] : sides) {
      out.sides.push_back(side);
      out.segments.push_back(segment);
    }
    return out;
  }

 private:
  void add_vertices(const Pieces& pieces, RegionBoundary& out) {
    std::vector<VertexId> ascending = pieces.isolated;
    for (const GlobalSide& s : pieces.sides) {
      ascending.push_back(s.from);
      ascending.push_back(s.to);
    }
    sort_by_team(
        ascending, [this](VertexId u, VertexId v) { return rank_[u.index()] < rank_[v.index()]; },
        team_);
    ascending.erase(std::unique(ascending.begin(), ascending.end()), ascending.end());
    std::vector<Point> points(ascending.size());
    std::transform(ascending.begin(), ascending.end(), points.begin(),
                   [this](VertexId v) { return pslg_.points[v.index()]; });
    out.vertices.reserve(points.size());
    out.points.reserve(points.size());
    for (const std::uint32_t k : spatial_order(points, team_)) {
      local_[ascending[k].index()] = static_cast<std::uint32_t>(out.points.size());
      out.vertices.push_back(ascending[k]);
      out.points.push_back(points[k]);
    }
  }

  const Pslg& pslg_;
  const Team& team_;
  std::vector<std::uint32_t> rank_;
  std::vector<std::uint32_t> local_;  ///< of the region at hand, by VertexId
};

}  // namespace

std::vector<RegionBoundary> split_regions(const Pslg& pslg, const RegionTable& table,
                                          const Team& team) {
  const std::vector<Pieces> pieces = deal_out(pslg, table);
  BoundaryMaker maker(pslg, team);
  std::vector<RegionBoundary> out;
  out.reserve(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    out.push_back(maker.make(RegionId{k + 1}, pieces[k]));
  }
  return out;
}

void add_known_triangles(std::span<TriangulatedRegion> large, std::size_t points,
                         std::span<RegionBoundary> boundaries, const Team& team) {
  constexpr std::size_t kRange = 1 << 15;
  std::vector<std::uint32_t> local;
  for (TriangulatedRegion& region : large) {
    RegionBoundary& boundary = boundaries[region.id.index() - 1];
    if (boundary.points.size() < kLargeRegion) continue;
    local.assign(points, kNone);
    for (std::uint32_t v = 0; v < boundary.vertices.size(); ++v)
      local[boundary.vertices[v].index()] = v;
    const auto in_region = [&](const IndexTriple& t) {
      return std::all_of(t.begin(), t.end(),
                         [&](std::uint32_t v) { return v < points && local[v] != kNone; });
    };
    std::vector<IndexTriple> known = std::move(region.triangles);
    std::atomic<bool> are_inside = true;
    team.each_range(known.size(), kRange, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        if (!in_region(known[k])) {
          are_inside = false;
          return;
        }
        for (std::uint32_t& v : known[k]) v = local[v];
      }
    });
    if (!are_inside) continue;
    put_in_order(boundary.points.size(), known, team);
    boundary.known_cdt = std::make_shared<std::vector<IndexTriple>>(std::move(known));
  }
}

}  // namespace cover
