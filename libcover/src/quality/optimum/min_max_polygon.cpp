// best[i][j] is the least possible largest excess of the part of the polygon that the chord from
// i to j cuts off; it is the minimum over the third corner between them.
// Tested by tests/unit/quality/optimum/min_max_polygon_test.cpp.
#include "quality/optimum/min_max_polygon.hpp"

#include "geom/vector.hpp"
#include "quality/optimum/delaunay_polygon.hpp"

namespace cover {
namespace {

struct Table {
  double best[kPolygonLimit][kPolygonLimit];
  int corner[kPolygonLimit][kPolygonLimit];
};

void collect(const Table& table, int i, int j, Patch& patch) {
  if (j - i < 2) return;
  const int k = table.corner[i][j];
  patch.add(i, k, j);
  collect(table, i, k, patch);
  collect(table, k, j, patch);
}

/// Whether two corners of the loop can be cut off by a triangle each: every triangulation does.
bool has_ears(const MutableMesh& mesh, const Cavity& cavity, double most) {
  const double largest = mesh.goal().large + most;
  int ears = 0;
  for (int k = 0; k < cavity.size(); ++k) {
    const Point p = mesh.points[cavity.vertex(cavity.next(k))];
    const Vector u = mesh.points[cavity.vertex(k)] - p;
    const Vector v = mesh.points[cavity.vertex(cavity.next(cavity.next(k)))] - p;
    const double area = cross(v, u);
    if (area > 0 && -dot(u, v) <= largest * area) ++ears;
  }
  return ears >= 2;
}

}  // namespace

double min_max_polygon(const MutableMesh& mesh, const Cavity& cavity, double most, Patch& patch) {
  const int size = cavity.size();
  if (size > kPolygonLimit || (size > 3 && !has_ears(mesh, cavity, most))) return kInverted;
  if (mesh.goal().coupling.inside) {
    const double worst = delaunay_polygon(mesh, cavity, patch);
    return worst <= most ? worst : kInverted;
  }
  Table table{};
  for (int i = 0; i + 1 < size; ++i) table.best[i][i + 1] = -kInverted;
  for (int length = 2; length < size; ++length) {
    for (int i = 0; i + length < size; ++i) {
      const int j = i + length;
      double best = kInverted;
      table.corner[i][j] = i + 1;
      for (int k = i + 1; k < j; ++k) {
        const double parts = std::max(table.best[i][k], table.best[k][j]);
        if (!(parts < best) || parts > most) continue;
        // Across the edges opposite to i, k, j: the loop's own neighbours, or "some triangle".
        const double value =
            std::max(parts, mesh.excess_of({cavity.vertex(i), cavity.vertex(k), cavity.vertex(j)},
                                           {k + 1 == j ? cavity.outer(k) : kSomeTriangle,
                                            length + 1 == size ? cavity.outer(j) : kSomeTriangle,
                                            i + 1 == k ? cavity.outer(i) : kSomeTriangle}));
        if (value < best) {
          best = value;
          table.corner[i][j] = k;
        }
      }
      table.best[i][j] = best;
    }
  }
  const double result = table.best[0][size - 1];
  patch.clear();
  if (result < kInverted) collect(table, 0, size - 1, patch);
  return result;
}

}  // namespace cover
