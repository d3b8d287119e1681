// Sizes spread along the edges of the triangulation, smallest first, as shortest paths do.
// Tested by tests/unit/quality/sizes_test.cpp.
#include "quality/size_field.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kNoSize = std::numeric_limits<double>::infinity();

/// The mean length of the sides at each vertex; infinite where there are none.
std::vector<double> spacing_of(const RegionBoundary& boundary) {
  std::vector<double> sum(boundary.points.size(), 0);
  std::vector<int> count(boundary.points.size(), 0);
  for (const auto& [a, b] : boundary.sides) {
    const double l = length(boundary.points[b] - boundary.points[a]);
    sum[a] += l;
    sum[b] += l;
    ++count[a];
    ++count[b];
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = count[v] > 0 ? sum[v] / count[v] : kNoSize;
  return sum;
}

}  // namespace

SizeField::SizeField(const RegionBoundary& boundary, const Triangulation& cdt, double growth)
    : slope_(growth - 1), largest_(boundary.size > 0 ? boundary.size : kNoSize) {
  if (boundary.size == 0 && boundary.size_at.empty()) return;
  at_ = spacing_of(boundary);
  for (std::size_t v = 0; v < at_.size(); ++v) {
    if (at_[v] * kNear >= largest_) at_[v] = largest_;
    const double given = boundary.size_at.empty() ? 0 : boundary.size_at[v];
    if (given > 0) at_[v] = std::min(given, largest_);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // both ways
  for (const Triangle& t : cdt.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back({t.v[i], t.v[(i + 1) % 3]});
      edges.push_back({t.v[(i + 1) % 3], t.v[i]});
    }
  }
  std::sort(edges.begin(), edges.end());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < at_.size(); ++v) queue.push({at_[v], v});
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > at_[v]) continue;
    for (auto e = std::lower_bound(edges.begin(), edges.end(), std::pair(v, 0U));
         e != edges.end() && e->first == v; ++e) {
      const double here = near(v, length(cdt.points[e->second] - cdt.points[v]));
      if (here >= at_[e->second]) continue;
      at_[e->second] = here;
      queue.push({here, e->second});
    }
  }
}

double SizeField::near(std::uint32_t v, double distance) const {
  return std::min(largest_, at_[v] + slope_ * distance);
}

void SizeField::set(std::uint32_t v, double size) {
  if (at_.size() <= v) at_.resize(v + 1, largest_);
  at_[v] = size;
}

}  // namespace cover
