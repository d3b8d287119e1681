// The last resort of a gap: its polygon of centres and tangency points, at most eight corners, is
// triangulated by its own corners or by a star from a point inside, whichever has the smaller
// largest angle. Conformity is untouched, since the polygon's edges stay whole.
// Tested by tests/unit/disks/gaps/gap_test.cpp.
#include <algorithm>
#include <cmath>

#include "disks/gaps/gap.hpp"
#include "disks/gaps/small_polygon.hpp"
#include "geom/triangle.hpp"

namespace cover::disks {
namespace {

double largest_of_star(const std::vector<Point>& p, Point centre) {
  double largest = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    largest = std::max(largest, largest_or_impossible(p[k], p[(k + 1) % p.size()], centre));
  }
  return largest;
}

}  // namespace

void fill_cell(TriangleDraft& draft, const Gap& gap) {
  const std::vector<Index> cell = cell_of(gap);
  std::vector<Point> p;
  for (const Index v : cell) p.push_back(draft.points[v]);

  Vector sum;
  for (const Point q : p) sum = sum + (q - p[0]);
  Point centre;
  double best = kImpossible;
  for (const Point c :
       {p[0] + (1.0 / static_cast<double>(p.size())) * sum,
        circumcentre(draft.points[gap.t[0]], draft.points[gap.t[1]], draft.points[gap.t[2]])}) {
    // Tangency points on a line have none.
    if (!std::isfinite(c.x) || !std::isfinite(c.y)) continue;
    const double largest = largest_of_star(p, c);
    if (largest < best) best = largest, centre = c;
  }
  const SmallPolygon whole(p);
  if (whole.largest_angle() < best) {
    for (const auto& [i, j, k] : whole.triangles()) draft.triangle(cell[i], cell[j], cell[k]);
  } else if (best < kImpossible) {
    const Index c = draft.add(centre);
    for (std::size_t k = 0; k < cell.size(); ++k) {
      draft.triangle(cell[k], cell[(k + 1) % cell.size()], c);
    }
  }
}

}  // namespace cover::disks
