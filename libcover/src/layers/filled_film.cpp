// Tested by tests/unit/layers/filled_film_test.cpp.
#include "layers/filled_film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "geom/topology/corner.hpp"
#include "geom/vector.hpp"
#include "region/whole_mesh.hpp"

namespace cover {
namespace {

using layers::LayerFront;
using layers::SideLayers;

constexpr double kSame = 1e-3;  ///< of a layer's thickness: so much alike are cells of one row

/// Whether `p` is as far from the line of a side as all of its layers are thick.
bool is_at_the_end(const RegionBoundary& boundary, const LayerFront& front, std::uint32_t side,
                   int count, Point p) {
  const auto& [from, to] = boundary.sides[side];
  const Point a = boundary.points[from], b = boundary.points[to];
  const double away = cross(b - a, p - a) / length(b - a);
  const double all = front.thickness(side, count), last = all - front.thickness(side, count - 1);
  return std::abs(away - all) <= kSame * last;
}

}  // namespace

void complete_filled_films(const RegionBoundary& boundary, std::span<const LayerRule> rules,
                           const LayerFront& front, const RegionMesh& mesh,
                           std::vector<SideLayers>& sides) {
  const auto count_of = [&](std::uint32_t s) { return rules[boundary.layers[s] - 1].count; };
  const std::size_t own = boundary.points.size();
  const auto at = [&](std::uint32_t v) {
    return v < own ? boundary.points[v] : front.added()[v - own];
  };
  std::vector<std::size_t> open(sides.size(), 0);  // edges of the front to look at, by side
  std::map<std::pair<Point, Point>, std::uint32_t>
      side_of;  // by their ends: vertices may have gone
  for (const LayerFront::Top& top : front.tops()) {
    const SideLayers& side = sides[top.side];
    if (side.stop != LayerStop::room || top.row != side.rows || side.rows + 1 != count_of(top.side))
      continue;
    ++open[top.side];
    side_of.emplace(std::pair(at(top.a), at(top.b)), top.side);
  }
  if (side_of.empty()) return;
  const std::vector<Point> points = all_points(boundary, mesh);
  std::vector<bool> on_side(points.size(), false);
  for (const auto& [a, b] : boundary.sides) on_side[a] = on_side[b] = true;
  for (const IndexTriple& t : mesh.triangles) {
    for (const Corner i : kCorners) {
      const auto top = side_of.find({points[t[i.next()]], points[t[i.previous()]]});
      if (top == side_of.end() || !on_side[t[i]]) continue;
      const std::uint32_t s = top->second;
      if (is_at_the_end(boundary, front, s, count_of(s), points[t[i]]) && --open[s] == 0)
        sides[s] = {count_of(s), LayerStop::none};
    }
  }
}

}  // namespace cover
