// A region's triangles of the constrained Delaunay triangulation of the whole are its own
// triangulation: what is beyond its sides is out of sight. Tested by
// tests/unit/verify/verify_limits_test.cpp.
#include "verify/verify_limits.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <cover/judged_angle.hpp>

#include "geom/angle_rounding.hpp"
#include "geom/vector.hpp"
#include "limits/region_limits.hpp"

namespace cover {
namespace {

/// The triangle with its corner `first` in front.
Triangle turned(const Triangle& f, int first) {
  Triangle out;
  for (int i = 0; i < 3; ++i) {
    const int from = (first + i) % 3;
    out.v[static_cast<std::size_t>(i)] = f.v[static_cast<std::size_t>(from)];
    out.n[static_cast<std::size_t>(i)] = f.n[static_cast<std::size_t>(from)];
    out.set_locked(i, f.is_locked(from));
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
    int first = 0;  ///< the lowest corner
  };

  [[nodiscard]] Placed place_of(std::uint32_t t) const {
    Placed placed;
    placed.triangle = t;
    for (std::size_t i = 0; i < 3; ++i) placed.corners[i] = whole_.points[whole_.triangles[t].v[i]];
    const auto lowest = std::min_element(placed.corners.begin(), placed.corners.end());
    placed.first = static_cast<int>(lowest - placed.corners.begin());
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

}  // namespace

std::vector<RegionLimits> verify_limits(const TriangleSoup& mesh, std::span<const RegionId> region,
                                        const ExpectedDomain& domain, const ReachedAngles& wanted) {
  const std::size_t regions = domain.nu_opt.size();  // with the void
  std::vector<ReachedAngles> reached(regions, {Angle::degrees(180), Angle::degrees(180)});
  std::vector<bool> is_obtuse(regions, false);
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (region[t] == kVoid) continue;
    const auto& v = mesh.triangles[t];
    ReachedAngles& worst = reached[region[t].index()];
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = mesh.points[v[i]], b = mesh.points[v[(i + 1) % 3]];
      const Point c = mesh.points[v[(i + 2) % 3]];
      worst.largest_nu = std::min(worst.largest_nu, Angle::radians(nu_at(b, a, c)));
      worst.smallest = std::min(worst.smallest, Angle::radians(angle_at(b, a, c)));
      if (bluntness(b, a, c) == Blunt::yes) is_obtuse[region[t].index()] = true;
    }
  }
  for (std::size_t r = 1; r < regions; ++r)
    reached[r].largest_nu = judged_nu(reached[r].largest_nu, is_obtuse[r]);
  std::vector<std::vector<std::uint32_t>> triangles(regions);
  for (std::uint32_t t = 0; t < domain.cdt_region.size(); ++t) {
    const std::size_t r = domain.cdt_region[t].index();
    if (domain.cdt_region[t] != kVoid && !meets(reached[r], wanted)) triangles[r].push_back(t);
  }
  Cutter cutter(domain);
  std::vector<RegionLimits> limits;
  for (std::size_t r = 1; r < regions; ++r)
    limits.push_back(region_limits(cutter.cut(triangles[r]), reached[r], wanted));
  return limits;
}

}  // namespace cover
