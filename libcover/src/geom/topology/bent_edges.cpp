#include "geom/topology/bent_edges.hpp"

#include <algorithm>

#include "geom/vector.hpp"

namespace cover {

std::map<std::pair<std::uint32_t, std::uint32_t>, Point> bent_edges(
    const TriangleSoup& soup, const std::vector<std::array<Point, 3>>& middles) {
  constexpr double kStraight = 1e-9;  // of an edge's length
  std::map<std::pair<std::uint32_t, std::uint32_t>, Point> bent;
  if (middles.size() != soup.triangles.size()) return bent;
  for (std::size_t t = 0; t < middles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = soup.triangles[t][i], b = soup.triangles[t][(i + 1) % 3];
      const Point p = soup.points[a], q = soup.points[b];
      if (length(middles[t][i] - midpoint(p, q)) > kStraight * length(q - p))
        bent[std::minmax(a, b)] = middles[t][i];
    }
  }
  return bent;
}

}  // namespace cover
