// A place is drawn in a triangle that is drawn first: where triangles are small there is much to be
// decided. Places keep their barycentric coordinates, so scaled by a power of two they are the
// same places.
// Tested by tests/unit/quality/starts/restart_test.cpp.
#include "quality/starts/restart.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "cdt/cdt.hpp"
#include "cdt/region_cdt.hpp"
#include "cdt/sides.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// A side and its number.
using NumberedSide = std::pair<IndexPair, std::uint32_t>;

std::vector<NumberedSide> sides_in_order(const MutableMesh& mesh) {
  std::vector<NumberedSide> sides;
  for (const MeshTriangle& t : mesh.triangles) {
    if (t.v[0] == kNone) continue;
    for (const Corner i : kCorners) {
      if (is_side(t.n[i]))
        sides.push_back({{t.v[i.next()], t.v[i.previous()]}, side_index(t.n[i])});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::optional<MutableMesh> restart(const MutableMesh& mesh, std::size_t count,
                                   std::uint32_t number) {
  const std::uint32_t fixed = mesh.fixed_vertices();
  std::vector<Point> points(mesh.points.begin(), mesh.points.begin() + fixed);
  std::vector<std::uint32_t> present;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!mesh.is_hole(t)) present.push_back(t);
  }
  Random random(number);
  for (std::size_t k = 0; k < count; ++k) {
    const auto drawn =
        static_cast<std::size_t>(random.unit() * static_cast<double>(present.size()));
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Point a = mesh.corner(present[drawn], 0);
    const Vector to_b = mesh.corner(present[drawn], 1) - a,
                 to_c = mesh.corner(present[drawn], 2) - a;
    points.push_back(a + u * to_b + v * to_c);
  }

  const std::vector<NumberedSide> sides = sides_in_order(mesh);
  std::vector<IndexPair> pairs;
  for (const auto& [pair, side] : sides) pairs.push_back(pair);
  const CdtResult cdt = triangulate_domain(points, pairs);
  if (find_flaw(cdt, points, pairs)) return std::nullopt;  // rounding put a place outside
  const std::vector<EdgeRef> found = locate_sides(cdt.triangulation, pairs);
  std::vector<EdgeRef> side_at(mesh.sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    side_at[sides[k].second] = found[k];
  }
  MutableMesh result(cdt.triangulation, fixed, side_at, mesh.sides);
  result.set_goal(mesh.goal());
  return result;
}

}  // namespace cover
