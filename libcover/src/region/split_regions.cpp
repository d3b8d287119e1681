// Sides are dealt out to their regions; then each region sorts its own. Vertices are sorted by
// their rank among all points, so that points are compared in one sort only, and then laid along a
// curve.
// Tested by tests/unit/region/split_regions_test.cpp.
#include <algorithm>
#include <atomic>
#include <functional>

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
    if (region != kVoid) out[place_of(region)].sides.push_back({from, to, segment});
  };
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const Segment& segment = pslg.segments[s];
    add(table.sides[s].left, segment.a, segment.b, SegmentId{s});
    add(table.sides[s].right, segment.b, segment.a, SegmentId{s});
  }
  for (const HullSide& side : table.hull_sides) add(side.region, side.a, side.b, kHullSide);
  for (const IsolatedPoint& p : table.isolated_points) {
    out[place_of(p.region)].isolated.push_back(p.vertex);
  }
  return out;
}

/// Calls `use` with the numbers below `count`, ranges at a time.
template <class Use>
void for_each(std::size_t count, const Team& team, const Use& use) {
  team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) use(k);
  });
}

/// The place of every point in lexicographic order.
std::vector<std::uint32_t> ranks(const std::vector<Point>& points, const Team& team) {
  std::vector<std::uint32_t> order(points.size()), rank(points.size());
  for_each(points.size(), team, [&](std::size_t k) { order[k] = static_cast<std::uint32_t>(k); });
  // No two points are equal.
  sort_by_team(
      order, [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; }, team);
  for_each(order.size(), team,
           [&](std::size_t k) { rank[order[k]] = static_cast<std::uint32_t>(k); });
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
    std::vector<std::pair<IndexPair, SegmentId>> sides(pieces.sides.size());
    for_each(sides.size(), team_, [&](std::size_t k) {
      const GlobalSide& s = pieces.sides[k];
      sides[k] = {{local_[s.from.index()], local_[s.to.index()]}, s.segment};
    });
    sort_by_team(sides, std::less(), team_);
    out.sides.resize(sides.size());
    out.segments.resize(sides.size());
    for_each(sides.size(), team_, [&](std::size_t k) {
      out.sides[k] = sides[k].first;
      out.segments[k] = sides[k].second;
    });
    return out;
  }

 private:
  void add_vertices(const Pieces& pieces, RegionBoundary& out) {
    std::vector<VertexId> ascending = pieces.isolated;
    const std::size_t isolated = ascending.size();
    ascending.resize(isolated + 2 * pieces.sides.size());
    for_each(pieces.sides.size(), team_, [&](std::size_t k) {
      ascending[isolated + 2 * k] = pieces.sides[k].from;
      ascending[isolated + 2 * k + 1] = pieces.sides[k].to;
    });
    sort_by_team(
        ascending, [this](VertexId u, VertexId v) { return rank_[u.index()] < rank_[v.index()]; },
        team_);
    ascending.erase(std::unique(ascending.begin(), ascending.end()), ascending.end());
    std::vector<Point> points(ascending.size());
    for_each(points.size(), team_,
             [&](std::size_t k) { points[k] = pslg_.points[ascending[k].index()]; });
    out.vertices.resize(points.size());
    out.points.resize(points.size());
    const auto order = spatial_order(points, team_);
    for_each(order.size(), team_, [&](std::size_t place) {
      const std::uint32_t k = order[place];
      local_[ascending[k].index()] = static_cast<std::uint32_t>(place);
      out.vertices[place] = ascending[k];
      out.points[place] = points[k];
    });
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

void add_known_triangles(std::span<TriangulatedRegion> regions, std::size_t points,
                         std::span<RegionBoundary> boundaries, const Team& team) {
  std::vector<std::uint32_t> local(points, 0);
  for (TriangulatedRegion& region : regions) {
    if (region.triangles.empty()) continue;
    RegionBoundary& boundary = boundaries[place_of(region.id)];
    const std::vector<VertexId>& vertices = boundary.vertices;
    for (std::uint32_t v = 0; v < vertices.size(); ++v) local[vertices[v].index()] = v;
    const auto is_vertex = [&](std::uint32_t v) {  // what was another region's is not set back
      return v < points && local[v] < vertices.size() && vertices[local[v]].index() == v;
    };
    const auto in_region = [&](const IndexTriple& t) {
      return std::all_of(t.begin(), t.end(), is_vertex);
    };
    std::vector<IndexTriple> known = std::move(region.triangles);
    std::atomic<bool> are_inside = true;
    team.each_range(known.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
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
    boundary.known_cdt = std::make_shared<const std::vector<IndexTriple>>(std::move(known));
  }
}

}  // namespace cover
