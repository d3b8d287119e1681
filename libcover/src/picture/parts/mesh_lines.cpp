// Tested by tests/unit/picture/picture_test.cpp.
#include "picture/parts/mesh_lines.hpp"

#include <algorithm>

namespace cover {

MeshLines lines_of(const TriangleSoup& soup) {
  struct Side {
    std::array<std::uint32_t, 2> edge;
    std::int64_t region;
  };
  std::vector<Side> sides;
  sides.reserve(3 * soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::int64_t region = soup.region.empty() ? 0 : soup.region[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = soup.triangles[t][i], b = soup.triangles[t][(i + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, region});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.edge < b.edge; });
  MeshLines lines;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    bool same = true;
    for (; j < sides.size() && sides[j].edge == sides[i].edge; ++j) {
      same = same && sides[j].region == sides[i].region;
    }
    (j - i == 2 && same ? lines.inner : lines.borders).push_back(sides[i].edge);
    i = j;
  }
  return lines;
}

}  // namespace cover
