// A region's triangles of the constrained Delaunay triangulation of the whole are its own
// triangulation: what is beyond its sides is out of sight.
// Tested by tests/unit/verify/promises/verify_limits_test.cpp.
#include "verify/promises/verify_limits.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <cover/judged_angle.hpp>

#include "geom/angle_rounding.hpp"
#include "geom/vector.hpp"
#include "limits/region_limits.hpp"
#include "verify/by_region.hpp"

namespace cover {
namespace {

/// The triangle with its corner `first` in front.
Triangle turned(const Triangle& f, Corner first) {
  Triangle out;
  Corner from = first;
  for (const Corner i : kCorners) {
    out.v[i] = f.v[from];
    out.n[i] = f.n[from];
    out.set_locked(i, f.is_locked(from));
    from = from.next();
  }
  return out;
}

/// Cuts regions out of the whole, one after the other, in an order that depends on coordinates
/// alone: which sides a proof asks before its budget ends must not depend on what else there is.
class Cutter {
 public:
  explicit Cutter(const ExpectedDomain& domain)
      : whole_(domain.cdt),
        local_triangle_(domain.cdt.triangles.size(), kNone),
        local_point_(domain.cdt.points.size(), kNone) {}

  const Triangulation& cut(std::span<const std::uint32_t> triangles) {
    part_.points.clear();
    part_.triangles.clear();
    points_.clear();
    std::vector<Placed> placed;
    placed.reserve(triangles.size());
    for (const std::uint32_t t : triangles) placed.push_back(place_of(t));
    std::sort(placed.begin(), placed.end(),
              [](const Placed& a, const Placed& b) { return a.corners < b.corners; });
    for (std::uint32_t k = 0; k < placed.size(); ++k) local_triangle_[placed[k].triangle] = k;
    for (const Placed& p : placed) {
      Triangle f = turned(whole_.triangles[p.triangle], p.first);
      for (std::uint32_t& v : f.v) v = local(v);
      for (std::uint32_t& n : f.n) n = n == kNone ? kNone : local_triangle_[n];
      part_.triangles.push_back(f);
    }
    for (const std::uint32_t t : triangles) local_triangle_[t] = kNone;
    for (const std::uint32_t v : points_) local_point_[v] = kNone;
    return part_;
  }

 private:
  /// A triangle by its corners, from the lowest one on.
  struct Placed {
    std::array<Point, 3> corners;
    std::uint32_t triangle = 0;
    Corner first;  ///< the lowest corner
  };

  [[nodiscard]] Placed place_of(std::uint32_t t) const {
    Placed placed;
    placed.triangle = t;
    for (const Corner i : kCorners) placed.corners[i] = whole_.points[whole_.triangles[t].v[i]];
    const auto lowest = std::min_element(placed.corners.begin(), placed.corners.end());
    placed.first = static_cast<std::uint32_t>(lowest - placed.corners.begin());
    std::rotate(placed.corners.begin(), lowest, placed.corners.end());
    return placed;
  }

  std::uint32_t local(std::uint32_t v) {
    if (local_point_[v] == kNone) {
      local_point_[v] = static_cast<std::uint32_t>(part_.points.size());
      part_.points.push_back(whole_.points[v]);
      points_.push_back(v);
    }
    return local_point_[v];
  }

  const Triangulation& whole_;
  Triangulation part_;
  std::vector<std::uint32_t> local_triangle_, local_point_, points_;
};

/// What the triangles of a region have reached.
struct Reached {
  ReachedAngles angles{Angle::degrees(180), Angle::degrees(180)};
  bool is_obtuse = false;
};

std::vector<ReachedAngles> angles_by_region(const TriangleSoup& mesh,
                                            std::span<const RegionId> region, std::size_t regions,
                                            const Team& team) {
  const auto add = [&](Reached& worst, std::size_t t) {
    const auto& v = mesh.triangles[t];
    for (const Corner i : kCorners) {
      const Point a = mesh.points[v[i]], b = mesh.points[v[i.next()]];
      const Point c = mesh.points[v[i.previous()]];
      worst.angles.largest_nu = std::min(worst.angles.largest_nu, Angle::radians(nu_at(b, a, c)));
      worst.angles.smallest = std::min(worst.angles.smallest, Angle::radians(angle_at(b, a, c)));
      if (bluntness(b, a, c) == Blunt::yes) worst.is_obtuse = true;
    }
  };
  const auto merge = [](Reached& worst, const Reached& other) {
    worst.angles.largest_nu = std::min(worst.angles.largest_nu, other.angles.largest_nu);
    worst.angles.smallest = std::min(worst.angles.smallest, other.angles.smallest);
    worst.is_obtuse |= other.is_obtuse;
  };
  std::vector<Reached> reached(regions);
  fold_by_region(
      region.size(), [&](std::size_t t) { return region[t]; }, Reached{}, add, merge, reached,
      team);
  std::vector<ReachedAngles> angles;
  for (const Reached& r : reached)
    angles.push_back({judged_nu(r.angles.largest_nu, r.is_obtuse), r.angles.smallest});
  return angles;
}

}  // namespace

std::vector<RegionLimits> verify_limits(const TriangleSoup& mesh, std::span<const RegionId> region,
                                        const ExpectedDomain& domain, const ReachedAngles& wanted,
                                        const Team& team) {
  constexpr std::size_t kGroups = 32;  // of regions, each with tables as long as the whole
  const std::size_t regions = domain.nu_opt.size();  // with the void
  const std::vector<ReachedAngles> reached = angles_by_region(mesh, region, regions, team);
  std::vector<std::vector<std::uint32_t>> triangles(regions);
  for (std::uint32_t t = 0; t < domain.cdt_region.size(); ++t) {
    const std::size_t r = domain.cdt_region[t].index();
    if (domain.cdt_region[t] != kVoid && !meets(reached[r], wanted)) triangles[r].push_back(t);
  }
  std::vector<RegionLimits> limits(regions - 1);
  team.each_range(limits.size(), Team::ranges(limits.size(), kGroups),
                  [&](std::size_t first, std::size_t last) {
                    Cutter cutter(domain);
                    for (std::size_t k = first; k < last; ++k)
                      limits[k] =
                          region_limits(cutter.cut(triangles[k + 1]), reached[k + 1], wanted, team);
                  });
  return limits;
}

}  // namespace cover
