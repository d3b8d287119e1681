// Sides are sorted, so those that leave a vertex form a run; every locked edge of every triangle
// looks itself up in the run of its first vertex.
#include "cdt/sides.hpp"

#include <algorithm>

namespace cover {

std::vector<EdgeRef> locate_sides(const Triangulation& cdt, std::span<const IndexPair> sides) {
  std::vector<std::uint32_t> first(cdt.points.size() + 1, 0);
  for (const IndexPair& side : sides) {
    if (side[0] < cdt.points.size()) ++first[side[0] + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];

  std::vector<EdgeRef> at(sides.size());
  for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
    const Triangle& f = cdt.triangles[t];
    if (f.locked == 0) continue;
    for (int i = 0; i < 3; ++i) {
      if (!f.is_locked(i)) continue;
      const IndexPair pair{f.v[static_cast<std::size_t>(next3(i))],
                           f.v[static_cast<std::size_t>(prev3(i))]};
      const auto begin = sides.begin() + first[pair[0]], end = sides.begin() + first[pair[0] + 1];
      const auto side = std::lower_bound(begin, end, pair);
      if (side == end || *side != pair) continue;
      at[static_cast<std::size_t>(side - sides.begin())] = {t, static_cast<std::uint8_t>(i)};
    }
  }
  return at;
}

}  // namespace cover
