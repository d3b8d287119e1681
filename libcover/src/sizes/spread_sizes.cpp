// Smallest first, as shortest paths are found.
// Tested by tests/unit/sizes/fields/size_function_test.cpp.
#include "sizes/spread_sizes.hpp"

#include <algorithm>
#include <queue>

#include "geom/vector.hpp"

namespace cover {

void spread_sizes(std::span<const Point> points,
                  std::span<const std::pair<std::uint32_t, std::uint32_t>> edges, double slope,
                  std::vector<double>& sizes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> both_ways;
  both_ways.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    both_ways.emplace_back(a, b);
    both_ways.emplace_back(b, a);
  }
  std::sort(both_ways.begin(), both_ways.end());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < sizes.size(); ++v) queue.push({sizes[v], v});
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > sizes[v]) continue;
    for (auto e = std::lower_bound(both_ways.begin(), both_ways.end(), std::pair(v, 0U));
         e != both_ways.end() && e->first == v; ++e) {
      const double here = size + slope * length(points[e->second] - points[v]);
      if (here >= sizes[e->second]) continue;
      sizes[e->second] = here;
      queue.push({here, e->second});
    }
  }
}

}  // namespace cover
