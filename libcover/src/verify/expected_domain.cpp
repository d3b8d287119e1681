// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/expected_domain.hpp"

#include <algorithm>
#include <atomic>
#include <numbers>

#include "base/containers/union_find.hpp"
#include "geom/topology/half_edges.hpp"
#include "geom/vector.hpp"
#include "verify/by_region.hpp"

namespace cover {
namespace {

class Finder {
 public:
  Finder(const Pslg& pslg, const RegionTable& table, bool hull, const Team& team)
      : pslg_(pslg), table_(table), hull_(hull), team_(team) {}

  ExpectedDomain find() {
    std::vector<IndexPair> segments;
    segments.reserve(pslg_.segments.size());
    for (const Segment& s : pslg_.segments) segments.push_back({s.a.value(), s.b.value()});
    CdtResult cdt = triangulate_hull(pslg_.points, segments, team_);
    domain_.conflicts = std::move(cdt.conflicts);
    if (!domain_.conflicts.empty()) return std::move(domain_);
    triangles_ = std::move(cdt.triangulation.triangles);
    add_segment_sides();
    flood_regions();
    if (hull_) add_hull_sides();
    find_used_points();
    find_bounds();
    domain_.cdt = {pslg_.points, std::move(triangles_)};
    domain_.cdt_region = std::move(region_);
    return std::move(domain_);
  }

 private:
  void add_segment_sides() {
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s) {
      const auto [a, b] = std::array{pslg_.segments[s].a.value(), pslg_.segments[s].b.value()};
      domain_.sides.push_back({a, b, table_.sides[s].left, false, a});
      domain_.sides.push_back({b, a, table_.sides[s].right, false, b});
    }
  }

  /// The region of each triangle: triangles that share an edge which is no segment are of one, and
  /// sides tell which.
  void flood_regions() {
    std::vector<IndexTriple> corners(triangles_.size());
    SharedUnionFind pieces(triangles_.size());
    each_triangle([&](std::uint32_t t) {
      corners[t] = triangles_[t].v;
      for (const Corner i : kCorners) {
        const std::uint32_t beyond = triangles_[t].n[i];
        if (beyond != kNone && beyond < t && !triangles_[t].is_locked(i)) pieces.unite(t, beyond);
      }
    });
    std::vector<RegionId> of_piece(triangles_.size(), kVoid);
    const auto reach = [&](std::uint32_t half_edge, RegionId region) {
      RegionId& known = of_piece[pieces.find(half_edge / 3)];
      if (known == kVoid) known = region;
    };
    const HalfEdges edges(pslg_.points.size(), corners, team_);
    const std::vector<std::uint32_t> beside = find_apices(edges);
    for (std::size_t s = 0; s < beside.size(); ++s) {
      if (beside[s] != kNone) reach(beside[s], domain_.sides[s].region);
    }
    if (hull_) {  // where there are no segments, nothing else tells
      for (const HullSide& side : table_.hull_sides) {
        const std::uint32_t h = edges.find(side.a.value(), side.b.value());
        if (h != kNone) reach(h, side.region);
      }
    }
    region_.resize(triangles_.size());
    each_triangle([&](std::uint32_t t) { region_[t] = of_piece[pieces.find(t)]; });
  }

  /// The half-edge of the triangle on each side, whose third corner is its apex.
  std::vector<std::uint32_t> find_apices(const HalfEdges& edges) {
    std::vector<std::uint32_t> beside(domain_.sides.size());
    team_.each_range(beside.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s) {
        ExpectedSide& side = domain_.sides[s];
        beside[s] = edges.find(side.a, side.b);
        if (beside[s] != kNone) side.apex = edges.source(HalfEdges::previous(beside[s]));
      }
    });
    return beside;
  }

  void add_hull_sides() {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (region_[t] == kVoid) continue;
      for (const Corner i : kCorners) {
        const Triangle& f = triangles_[t];
        if (f.is_locked(i) || f.n[i] != kNone) continue;
        domain_.sides.push_back({f.v[i.next()], f.v[i.previous()], region_[t], true, f.v[i]});
      }
    }
  }

  void find_used_points() {
    domain_.is_used.assign(pslg_.points.size(), 0);
    each_triangle([&](std::uint32_t t) {
      if (region_[t] == kVoid) return;
      for (const std::uint32_t v : triangles_[t].v)
        std::atomic_ref(domain_.is_used[v]).store(1, std::memory_order_relaxed);
    });
  }

  void find_bounds() {
    domain_.nu_opt.assign(table_.regions.size() + 1, std::numbers::pi);
    const auto keep_least = [](double& least, double nu) { least = std::min(least, nu); };
    fold_by_region(
        2 * pslg_.segments.size(), [&](std::size_t s) { return domain_.sides[s].region; },
        std::numbers::pi,
        [&](double& least, std::size_t s) {
          const ExpectedSide& side = domain_.sides[s];
          if (side.apex == side.a) return;  // nothing sees it
          keep_least(least,
                     nu_at(pslg_.points[side.a], pslg_.points[side.apex], pslg_.points[side.b]));
        },
        keep_least, domain_.nu_opt, team_);
  }

  template <class Use>
  void each_triangle(const Use& use) const {
    team_.each_range(triangles_.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) use(static_cast<std::uint32_t>(t));
    });
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  bool hull_;
  const Team& team_;
  std::vector<Triangle> triangles_;
  std::vector<RegionId> region_;  ///< by triangle
  ExpectedDomain domain_;
};

}  // namespace

ExpectedDomain expected_domain(const Pslg& pslg, const RegionTable& table, bool hull,
                               const Team& team) {
  return Finder(pslg, table, hull, team).find();
}

}  // namespace cover
