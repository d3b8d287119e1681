// Tested by tests/unit/limits/angles/region_view_test.cpp.
#include "limits/angles/region_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

std::uint32_t at(const Triangle& f, Corner i) { return f.v[i]; }

}  // namespace

AngleRange apex_range(const RegionSide& side, const AngleRange& range, Meshes meshes) {
  if (meshes == Meshes::all) return range;
  AngleRange apex = range;
  if (side.is_free) apex.most = std::min(range.most, std::numbers::pi / 2 + kAngleSlack);
  apex.least = std::clamp(std::numbers::pi - side.nu_opt - kAngleSlack, range.least, apex.most);
  return apex;
}

RegionView::RegionView(const Triangulation& cdt) : cdt_(cdt) {
  find_sides();
  find_corners();
  find_bend();
}

void RegionView::find_corners() {
  corners_.resize(sides_.size());
  corner_of_.assign(cdt_.points.size(), kNone);
  sighted_.reserve(2 * cdt_.triangles.size() + 2 * sides_.size());
  std::vector<bool> has_several(cdt_.points.size());
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    walk_corner(s);
    std::uint32_t& corner = corner_of_[sides_[s].a];
    if (corner != kNone) has_several[sides_[s].a] = true;
    corner = s;
  }
  for (std::uint32_t v = 0; v < corner_of_.size(); ++v) {
    if (has_several[v]) corner_of_[v] = kNone;
  }
}

void RegionView::exempt(std::span<const IndexPair> sides) {
  std::vector<IndexPair> sorted(sides.begin(), sides.end());
  std::sort(sorted.begin(), sorted.end());
  for (RegionSide& side : sides_) {
    if (std::binary_search(sorted.begin(), sorted.end(), IndexPair{side.a, side.b}))
      side.is_free = false;
  }
}

void RegionView::find_bend() {
  if (sides_.empty() || sides_.size() != cdt_.points.size()) return;
  constexpr double kRoundingOfSum = 1e-12;  // far more than the sum of a corner's angles has
  double bend = 0;
  std::size_t walked = 0;
  std::uint32_t s = 0;
  do {
    const RegionSide &side = sides_[s], &next = sides_[side.end];
    if (orientation(point(side.a), point(side.b), point(next.b)) == Sign::negative)
      bend += corners_[side.end].angle - std::numbers::pi + kRoundingOfSum;
    s = side.end;
    ++walked;
  } while (s != 0 && walked < sides_.size());
  if (s == 0 && walked == sides_.size()) bend_ = bend;
}

void RegionView::find_sides() {
  double left = kInfinity, right = -kInfinity, bottom = kInfinity, top = -kInfinity;
  side_of_.assign(3 * cdt_.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < cdt_.triangles.size(); ++t) {
    const Triangle& f = cdt_.triangles[t];
    for (const Corner i : kCorners) {
      if (f.n[i] != kNone && !f.is_locked(i)) continue;
      side_of_[3 * t + i] = static_cast<std::uint32_t>(sides_.size());
      RegionSide side{at(f, i.next()), at(f, i.previous()), t, i};
      side.nu_opt = nu_at(point(side.a), point(at(f, i)), point(side.b));
      side.is_free =
          compare_with_90_degrees(point(side.a), point(at(f, i)), point(side.b)) != Sign::positive;
      sides_.push_back(side);
      const Point p = point(side.a);
      left = std::min(left, p.x), right = std::max(right, p.x);
      bottom = std::min(bottom, p.y), top = std::max(top, p.y);
    }
  }
  diameter_ = std::hypot(right - left, top - bottom) * (1 + 1e-12);
}

void RegionView::walk_corner(std::uint32_t s) {
  const RegionSide& side = sides_[s];
  RegionCorner& corner = corners_[s];
  corner.vertex = side.a;
  corner.first = static_cast<std::uint32_t>(sighted_.size());
  sighted_.push_back({side.b, 0});
  const Point a = point(side.a);
  Point previous = point(side.b);
  std::uint32_t t = side.triangle;
  Corner entry = side.edge;
  for (;;) {
    const Triangle& f = cdt_.triangles[t];
    const std::uint32_t w = at(f, entry);
    const Point p = point(w);
    corner.angle += std::atan2(cross(previous - a, p - a), dot(previous - a, p - a));
    sighted_.push_back({w, corner.angle});
    previous = p;
    const Corner exit = entry.previous();
    const std::uint32_t reached = side_at(t, exit);
    if (reached != kNone) {
      sides_[s].start = s;
      sides_[reached].end = s;
      corner.before = reached;
      break;
    }
    const std::uint32_t beyond = f.n[exit];
    entry = cdt_.triangles[beyond].edge_to(t);
    t = beyond;
  }
  corner.last = static_cast<std::uint32_t>(sighted_.size());
}

}  // namespace cover
