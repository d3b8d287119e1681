// The last resort of a gap: its polygon of centres and tangency points, at most eight corners, is
// triangulated by dynamic programming over its diagonals, and by stars from a few points inside;
// the smallest largest angle wins. Conformity is untouched, since the polygon's edges stay whole.
#include <algorithm>
#include <cmath>

#include "covering/disks/gap.hpp"
#include "geom/predicates.hpp"

namespace cover::disks {
namespace {

constexpr double kImpossible = 4;  // worse than any angle in radians
constexpr std::size_t kMostCorners = 8;

/// Largest angle of a triangle; kImpossible if it is not counter-clockwise.
double largest_angle(Point a, Point b, Point c) {
  if (orientation(a, b, c) != Sign::positive) return kImpossible;
  return std::max({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

/// Min-max-angle triangulation of a polygon by its own corners.
class PolygonTriangulation {
 public:
  explicit PolygonTriangulation(const std::vector<Point>& p) : p_(p) {
    const std::size_t n = p.size();
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        cost_[i][j] = kImpossible;
        for (std::size_t k = i + 1; k < j; ++k) {
          const double cost = std::max({cost_[i][k], cost_[k][j], largest_angle(p[i], p[k], p[j])});
          if (cost < cost_[i][j]) cost_[i][j] = cost, apex_[i][j] = k;
        }
      }
    }
  }
  [[nodiscard]] double largest() const { return cost_[0][p_.size() - 1]; }
  void emit(TriangleDraft& draft, const std::vector<Index>& cell, std::size_t i,
            std::size_t j) const {
    if (j < i + 2) return;
    const std::size_t k = apex_[i][j];
    draft.triangle(cell[i], cell[k], cell[j]);
    emit(draft, cell, i, k);
    emit(draft, cell, k, j);
  }

 private:
  const std::vector<Point>& p_;
  std::array<std::array<double, kMostCorners>, kMostCorners> cost_{};
  std::array<std::array<std::size_t, kMostCorners>, kMostCorners> apex_{};
};

double largest_of_star(const std::vector<Point>& p, Point centre) {
  double largest = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    largest = std::max(largest, largest_angle(p[k], p[(k + 1) % p.size()], centre));
  }
  return largest;
}

}  // namespace

void fill_cell(TriangleDraft& draft, const Gap& gap) {
  const std::vector<Index> cell = cell_of(gap);
  std::vector<Point> p;
  for (const Index v : cell) p.push_back(draft.points[v]);

  std::vector<Point> centres{
      circumcentre(draft.points[gap.t[0]], draft.points[gap.t[1]], draft.points[gap.t[2]])};
  Vector sum;
  for (const Point q : p) sum = sum + (q - p[0]);
  centres.push_back(p[0] + (1.0 / static_cast<double>(p.size())) * sum);
  double best = kImpossible;
  Point centre;
  for (const Point c : centres) {
    const double largest = largest_of_star(p, c);
    if (largest < best) best = largest, centre = c;
  }
  const PolygonTriangulation whole(p);
  if (whole.largest() <= best) {
    if (whole.largest() < kImpossible) whole.emit(draft, cell, 0, cell.size() - 1);
    return;
  }
  const Index c = draft.add(centre);
  for (std::size_t k = 0; k < cell.size(); ++k) {
    draft.triangle(cell[k], cell[(k + 1) % cell.size()], c);
  }
}

}  // namespace cover::disks
