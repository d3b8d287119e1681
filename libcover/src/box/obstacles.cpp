// From the triangle on the side over all edges that meet its diametral disk. A vertex whose
// perpendicular is blocked is left out: what blocks it mostly has an end that is nearer.
// Tested by tests/unit/box/least_cuts_test.cpp.
#include "box/obstacles.hpp"

#include <algorithm>

#include "base/containers/order.hpp"
#include "cdt/search/sight.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::uint64_t kLooksPerTriangle = 64;
constexpr std::uint64_t kLooksAtLeast = 100'000;

bool is_before(const Obstacle& x, const Obstacle& y) {
  return x.along != y.along ? x.along < y.along : x.height < y.height;
}

/// Whether the straight line from p to q has a point in the open disk.
bool meets_disk(Point p, Point q, Point centre, double squared_radius) {
  return squared_length(nearest_on_segment(p, q, centre) - centre) < squared_radius;
}

}  // namespace

ObstacleFinder::ObstacleFinder(const Triangulation& cdt)
    : cdt_(cdt),
      seen_(cdt.triangles.size()),
      budget_(kLooksAtLeast + kLooksPerTriangle * cdt.triangles.size()) {}

bool ObstacleFinder::sees_foot(std::uint32_t start, Point foot, Point p) {
  const Walk walk = walk_straight(cdt_, start, foot, p);
  if (!walk.arrived) return false;
  const auto& v = cdt_.triangles[walk.at.triangle].v;
  return std::any_of(v.begin(), v.end(), [&](std::uint32_t w) { return cdt_.points[w] == p; });
}

std::vector<Obstacle> ObstacleFinder::obstacles(EdgeRef side) {
  seen_.clear();
  const auto corner = [&](std::uint32_t t, Corner i) {
    return cdt_.points[cdt_.triangles[t].v[i]];
  };
  const Point a = corner(side.triangle, side.edge.next()),
              b = corner(side.triangle, side.edge.previous());
  const Vector along = b - a;
  const Point centre = midpoint(a, b);
  const double squared = squared_length(along);
  std::vector<Obstacle> found;
  std::vector<std::uint32_t> met;
  stack_.assign(1, side.triangle);
  seen_.insert(side.triangle);
  while (!stack_.empty() && budget_ > 0) {
    const std::uint32_t t = stack_.back();
    stack_.pop_back();
    --budget_;
    for (const Corner i : kCorners) {
      const std::uint32_t w = cdt_.triangles[t].v[i];
      const Point p = cdt_.points[w];
      if (compare_with_90_degrees(a, p, b) == Sign::positive &&
          orientation(a, b, p) == Sign::positive)
        met.push_back(w);
      const std::uint32_t n = cdt_.triangles[t].n[i];
      if (n == kNone || cdt_.triangles[t].is_locked(i) || seen_.contains(n)) continue;
      if (!meets_disk(corner(t, i.next()), corner(t, i.previous()), centre, squared / 4)) continue;
      seen_.insert(n);
      stack_.push_back(n);
    }
  }
  sort_unique(met);
  for (const std::uint32_t w : met) {
    const Point p = cdt_.points[w];
    const Obstacle obstacle{part_on_line(along, p - a), cross(along, p - a) / squared, p};
    if (!(obstacle.along > 0 && obstacle.along < 1 && obstacle.height > 0) || budget_ == 0)
      continue;
    --budget_;
    if (sees_foot(side.triangle, a + obstacle.along * along, p)) found.push_back(obstacle);
  }
  std::sort(found.begin(), found.end(), is_before);
  return found;
}

std::vector<Obstacle> turned_round(std::vector<Obstacle> obstacles) {
  for (Obstacle& o : obstacles) o.along = 1 - o.along;
  std::reverse(obstacles.begin(), obstacles.end());
  return obstacles;
}

std::vector<Obstacle> merged(std::vector<Obstacle> one, std::span<const Obstacle> other) {
  one.insert(one.end(), other.begin(), other.end());
  std::sort(one.begin(), one.end(), is_before);
  return one;
}

}  // namespace cover
