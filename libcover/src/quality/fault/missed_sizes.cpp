// Tested by tests/unit/quality/fault/missed_sizes_test.cpp.
#include "quality/fault/missed_sizes.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "geom/vector.hpp"
#include "sizes/size_field.hpp"

namespace cover {
namespace {

/// Edges of refined meshes are up to twice as long as asked, and one on average.
constexpr double kMuchLonger = 3;

Note warning(const RegionBoundary& boundary, const std::string& what, std::vector<Point> where) {
  return {Note::Kind::warning, boundary.id, fmt::format("region {}: {}", boundary.id.value(), what),
          std::move(where)};
}

/// By vertex of the boundary: whether it has a size and no side that is longer.
std::vector<bool> vertices_to_ask(const RegionBoundary& boundary) {
  std::vector<bool> is_asked(boundary.points.size(), false);
  for (std::size_t v = 0; v < boundary.size_at.size(); ++v) is_asked[v] = boundary.size_at[v] > 0;
  for (const auto& side : boundary.sides) {
    const double l = length(boundary.points[side[1]] - boundary.points[side[0]]);
    for (const std::uint32_t v : side) {
      if (is_asked[v] && l > SizeField::kNear * boundary.size_at[v]) is_asked[v] = false;
    }
  }
  return is_asked;
}

/// By vertex that is asked: how long its edges are on average, but for sides; 0: it has none.
std::vector<double> mean_edges(const RegionBoundary& boundary, const RegionMesh& mesh,
                               const std::vector<bool>& is_asked) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& [a, b] : boundary.sides) sides.emplace_back(std::minmax(a, b));
  std::sort(sides.begin(), sides.end());
  const std::vector<Point> points = all_points(boundary, mesh);
  std::vector<double> sum(is_asked.size(), 0);
  std::vector<std::size_t> count(is_asked.size(), 0);
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t v : corners) {
      if (v >= is_asked.size() || !is_asked[v]) continue;
      for (const std::uint32_t u : corners) {
        const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(u, v);
        if (u == v || std::binary_search(sides.begin(), sides.end(), edge)) continue;
        sum[v] += length(points[u] - points[v]);
        ++count[v];
      }
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (count[v] > 0) sum[v] /= static_cast<double>(count[v]);
  return sum;
}

}  // namespace

std::optional<Note> missed_sizes(const RegionBoundary& boundary, const RegionMesh& mesh) {
  if (mesh.report.method.starts_with("almond"))
    return warning(boundary,
                   "the sizes asked for do not count here: of the meshes refined to them that were "
                   "tried none holds the proven bound, and the almond method, which does, knows no "
                   "sizes",
                   {});
  if (boundary.size_at.empty()) return std::nullopt;
  const std::vector<double> mean = mean_edges(boundary, mesh, vertices_to_ask(boundary));
  const auto times = [&](std::size_t v) { return mean[v] / boundary.size_at[v]; };
  std::vector<Point> where;
  std::size_t worst = 0;
  for (std::size_t v = 0; v < mean.size(); ++v) {
    if (mean[v] == 0 || times(v) <= kMuchLonger) continue;
    if (where.empty() || times(v) > times(worst)) worst = v;
    where.push_back(boundary.points[v]);
  }
  if (where.empty()) return std::nullopt;
  const std::string what = fmt::format(
      "edges at {} with a size of {} own are longer than asked, on average up to {:.4g} in place "
      "of {:.4g} at {}: beside long segments, which stay whole unless --split-interfaces cuts "
      "them, angles come before sizes",
      counted(where.size(), "point"), where.size() == 1 ? "its" : "their", mean[worst],
      boundary.size_at[worst], describe(boundary.points[worst]));
  return warning(boundary, what, std::move(where));
}

}  // namespace cover
