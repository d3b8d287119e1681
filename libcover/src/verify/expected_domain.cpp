// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/expected_domain.hpp"

#include <algorithm>
#include <numbers>
#include <unordered_map>

#include "geom/vector.hpp"

namespace cover {
namespace {

/// A directed edge as one number.
constexpr std::uint64_t key(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint64_t>(a) << 32 | b;
}

class Finder {
 public:
  Finder(const Pslg& pslg, const RegionTable& table, bool hull)
      : pslg_(pslg), table_(table), hull_(hull) {}

  ExpectedDomain find() {
    std::vector<IndexPair> segments;
    segments.reserve(pslg_.segments.size());
    for (const Segment& s : pslg_.segments) segments.push_back({s.a.value(), s.b.value()});
    CdtResult cdt = triangulate_hull(pslg_.points, segments);
    domain_.conflicts = std::move(cdt.conflicts);
    if (!domain_.conflicts.empty()) return std::move(domain_);
    triangles_ = std::move(cdt.triangulation.triangles);
    add_segment_sides();
    flood_regions();
    domain_.point_region.assign(pslg_.points.size(), kVoid);
    domain_.nu_opt.assign(table_.regions.size() + 1, std::numbers::pi);
    for (std::size_t t = 0; t < triangles_.size(); ++t) visit(triangles_[t], region_[t]);
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

  /// The region of each triangle, carried from the sides over edges that are no segments.
  void flood_regions() {
    std::unordered_map<std::uint64_t, std::size_t> side_at;
    side_at.reserve(domain_.sides.size());
    for (std::size_t s = 0; s < domain_.sides.size(); ++s)
      side_at[key(domain_.sides[s].a, domain_.sides[s].b)] = s;
    std::unordered_map<std::uint64_t, RegionId> hull_side;
    if (hull_) {  // where there are no segments, nothing else tells
      for (const HullSide& side : table_.hull_sides)
        hull_side[key(side.a.value(), side.b.value())] = side.region;
    }
    region_.assign(triangles_.size(), kVoid);
    std::vector<std::uint32_t> stack;
    const auto reach = [&](std::uint32_t t, RegionId region) {
      if (region == kVoid || region_[t] != kVoid) return;
      region_[t] = region;
      stack.push_back(t);
    };
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const bool is_outer = triangles_[t].n[static_cast<std::size_t>(i)] == kNone;
        if (!triangles_[t].is_locked(i) && !is_outer) continue;
        const auto [a, b] = edge(triangles_[t], i);
        if (const auto side = side_at.find(key(a, b)); side != side_at.end()) {
          domain_.sides[side->second].apex = triangles_[t].v[static_cast<std::size_t>(i)];
          reach(t, domain_.sides[side->second].region);
        } else if (const auto outer = hull_side.find(key(a, b)); outer != hull_side.end()) {
          reach(t, outer->second);
        }
      }
      while (!stack.empty()) {
        const std::uint32_t from = stack.back();
        stack.pop_back();
        for (int i = 0; i < 3; ++i) {
          const std::uint32_t to = triangles_[from].n[static_cast<std::size_t>(i)];
          if (to != kNone && !triangles_[from].is_locked(i)) reach(to, region_[from]);
        }
      }
    }
  }

  void visit(const Triangle& t, RegionId region) {
    if (region == kVoid) return;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = edge(t, i);
      const std::uint32_t apex = t.v[static_cast<std::size_t>(i)];
      domain_.point_region[apex] = region;
      if (t.is_locked(i)) {
        double& nu = domain_.nu_opt[region.index()];
        nu = std::min(nu, nu_at(pslg_.points[a], pslg_.points[apex], pslg_.points[b]));
      } else if (hull_ && t.n[static_cast<std::size_t>(i)] == kNone) {
        domain_.sides.push_back({a, b, region, true, apex});
      }
    }
  }

  static IndexPair edge(const Triangle& t, int i) {
    return {t.v[static_cast<std::size_t>(next3(i))], t.v[static_cast<std::size_t>(prev3(i))]};
  }

  const Pslg& pslg_;
  const RegionTable& table_;
  bool hull_;
  std::vector<Triangle> triangles_;
  std::vector<RegionId> region_;  ///< by triangle
  ExpectedDomain domain_;
};

}  // namespace

ExpectedDomain expected_domain(const Pslg& pslg, const RegionTable& table, bool hull) {
  return Finder(pslg, table, hull).find();
}

}  // namespace cover
