// Which construction a gap gets, and the check of what it made. Every triangle is right-angled by
// construction; what can go wrong is that a foot falls outside its segment, and then the areas no
// longer add up.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include "disks/gaps/gap.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "geom/triangle.hpp"

namespace cover::disks {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k & 3); }

double doubled_area_of(const TriangleDraft& draft, const std::array<Index, 3>& t) {
  return doubled_area(draft.points[t[0]], draft.points[t[1]], draft.points[t[2]]);
}

/// Opposite sides k and k + 2 that touch within this very gap, at which point; else nothing.
std::optional<Point> touching_point(const TriangleDraft& draft, const Gap& gap, int k,
                                    double tolerance) {
  const Element& e = gap.e[at(k)];
  const Element& f = gap.e[at(k + 2)];
  if (e.is_line() && f.is_line()) return std::nullopt;
  const Element& disk = e.is_disk() ? e : f;
  const Element& other = e.is_disk() ? f : e;
  const double radius = other.is_disk() ? std::min(disk.r, other.r) : disk.r;
  if (std::abs(signed_distance(other, disk.c) - disk.r) > tolerance * radius) return std::nullopt;
  const Point p = contact(other, disk.c);
  for (const int side : {k, k + 2}) {
    const Element& s = gap.e[at(side)];
    const Point begin = draft.points[gap.t[at(side + 3)]], end = draft.points[gap.t[at(side)]];
    if (s.is_line()) {
      const double t = dot(s.d, p - begin);
      if (t <= 0 || t >= dot(s.d, end - begin)) return std::nullopt;
    } else if (ccw_angle(p - s.c, begin - s.c) >= ccw_angle(end - s.c, begin - s.c)) {
      return std::nullopt;
    }
  }
  return p;
}

/// Splits the gap where sides k and k + 2 touch.
GapKind fill_touching(TriangleDraft& draft, const Gap& gap, int k, Point p) {
  const Gap g = gap.from_side(k);
  const Index t = draft.add_on(g.e[0].is_line() ? g.e[0] : g.e[2], p);
  fill_three(draft, {3, {g.e[0], g.e[1], g.e[2], {}}, {g.t[0], g.t[1], t, 0}});
  fill_three(draft, {3, {g.e[2], g.e[3], g.e[0], {}}, {g.t[2], g.t[3], t, 0}});
  return GapKind::touching;
}

}  // namespace

Gap Gap::from_side(int k) const {
  Gap result;
  result.size = size;
  for (int i = 0; i < size; ++i) {
    const auto to = static_cast<std::size_t>(i), from = static_cast<std::size_t>((i + k) % size);
    result.e[to] = e[from];
    result.t[to] = t[from];
  }
  return result;
}

GapAngles measure(const TriangleDraft& draft, const Gap& gap) {
  std::array<Point, 4> t;
  for (std::size_t k = 0; k < 4; ++k) t[k] = draft.points[gap.t[k]];
  // The circle through the three points that span the largest triangle.
  std::size_t omit = 0;
  double largest = -1;
  for (std::size_t k = 0; k < 4; ++k) {
    const double area = std::abs(doubled_area(t[(k + 1) & 3], t[(k + 2) & 3], t[(k + 3) & 3]));
    if (area > largest) largest = area, omit = k;
  }
  GapAngles result;
  result.centre = circumcentre(t[(omit + 1) & 3], t[(omit + 2) & 3], t[(omit + 3) & 3]);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point p = t[(k + 3) & 3], q = t[k];
    result.beta[k] = 0.5 * ccw_angle(p - result.centre, q - result.centre);
    if (gap.e[k].is_disk()) result.gamma[k] = 0.5 * ccw_angle(q - gap.e[k].c, p - gap.e[k].c);
  }
  return result;
}

void fan(TriangleDraft& draft, const Element& e, Index p, Index q, Index centre) {
  const Point a = draft.points[p], b = draft.points[q];
  const Point middle = midpoint(a, b);
  const double small = kFlatGap * norm(b - a);
  if (e.is_disk() && norm(e.c - middle) < small) {  // the arc is half the disk
    draft.triangle(p, e.id, centre);
    draft.triangle(e.id, q, centre);
    return;
  }
  if (norm(draft.points[centre] - middle) < small) {  // the chord is a diameter
    if (e.is_disk()) {
      draft.triangle(p, e.id, centre);
      draft.triangle(e.id, q, centre);
    } else {
      draft.points[centre] = middle;
      draft.on_chord.push_back({e.id, centre});
    }
    return;
  }
  const Index m = draft.add_on(e, middle);
  if (e.is_disk()) {
    draft.triangle(p, e.id, m);
    draft.triangle(e.id, q, m);
  }
  draft.triangle(p, m, centre);
  draft.triangle(m, q, centre);
}

namespace {

/// Four sides: chooses among the ways there are.
GapKind fill_four(TriangleDraft& draft, const Gap& gap, double tolerance) {
  for (const int k : {0, 1}) {
    if (const auto p = touching_point(draft, gap, k, tolerance))
      return fill_touching(draft, gap, k, *p);
  }
  for (const int k : {0, 1}) {
    if (gap.e[at(k)].is_line() && gap.e[at(k + 2)].is_line()) {
      return fill_two_lines(draft, gap.from_side(k ^ 1));
    }
  }
  const GapAngles angles = measure(draft, gap);
  const auto widest_arc = std::max_element(angles.gamma.begin(), angles.gamma.end());
  if (*widest_arc > std::numbers::pi / 2 + kFlatGap) {
    return fill_reflex(draft, gap.from_side(static_cast<int>(widest_arc - angles.gamma.begin())));
  }
  const auto widest = std::max_element(angles.beta.begin(), angles.beta.end());
  if (*widest <= std::numbers::pi / 2 + kFlatGap) return fill_good(draft, gap, angles);
  return fill_by_cut(draft, gap, angles, static_cast<int>(widest - angles.beta.begin()));
}

}  // namespace

GapKind fill_good(TriangleDraft& draft, const Gap& gap, const GapAngles& angles) {
  const Index centre = draft.add(angles.centre);
  for (int k = 0; k < 4; ++k) fan(draft, gap.e[at(k)], gap.begin_of(k), gap.end_of(k), centre);
  return GapKind::good;
}

std::vector<Index> cell_of(const Gap& gap) {
  std::vector<Index> cell;
  for (int k = 0; k < gap.size; ++k) {
    if (gap.e[at(k)].is_disk()) cell.push_back(gap.e[at(k)].id);
    cell.push_back(gap.end_of(k));
  }
  return cell;
}

GapKind fill_gap(TriangleDraft& draft, const Gap& gap, double tolerance) {
  const std::size_t points = draft.points.size(), triangles = draft.triangles.size(),
                    on_chord = draft.on_chord.size();
  const GapKind kind = gap.size == 3 ? fill_three(draft, gap) : fill_four(draft, gap, tolerance);

  const std::vector<Index> cell = cell_of(gap);
  double wanted = 0, found = 0, smallest = kInfinity;
  for (std::size_t k = 1; k + 1 < cell.size(); ++k) {
    wanted += doubled_area_of(draft, {cell[0], cell[k], cell[k + 1]});
  }
  for (std::size_t k = triangles; k < draft.triangles.size(); ++k) {
    const double area = doubled_area_of(draft, draft.triangles[k]);
    found += area;
    smallest = std::min(smallest, area);
  }
  constexpr double kAreaError = 1e-9;  // of the cell: far above rounding, far below a flipped foot
  if (smallest > 0 && std::abs(found - wanted) <= kAreaError * wanted) return kind;

  draft.points.resize(points);
  draft.triangles.resize(triangles);
  draft.on_chord.resize(on_chord);
  fill_cell(draft, gap);
  return GapKind::cell;
}

}  // namespace cover::disks
