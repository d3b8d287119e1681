// Sides are sorted, so those that leave a vertex form a run; every locked edge of every triangle
// looks itself up in the run of its first vertex.
#include "cdt/sides.hpp"

#include <algorithm>

namespace cover {

std::vector<EdgeRef> locate_sides(const Triangulation& cdt, std::span<const IndexPair> sides,
                                  const Team& team) {
  std::vector<std::uint32_t> first(cdt.points.size() + 1, 0);
  for (const IndexPair& side : sides) {
    if (side[0] < cdt.points.size()) ++first[side[0] + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];

  std::vector<EdgeRef> at(sides.size());
  const auto look_at = [&](std::uint32_t t) {
    const Triangle& f = cdt.triangles[t];
    if (f.locked == 0) return;
    for (const Corner i : kCorners) {
      if (!f.is_locked(i)) continue;
      const std::uint32_t from = f.v[i.next()], to = f.v[i.previous()];
      const auto begin = sides.begin() + first[from], end = sides.begin() + first[from + 1];
      const auto side = std::lower_bound(
          begin, end, to, [](const IndexPair& s, std::uint32_t v) { return s[1] < v; });
      if (side == end || (*side)[1] != to) continue;
      at[static_cast<std::size_t>(side - sides.begin())] = {t, static_cast<std::uint8_t>(i)};
    }
  };
  // A side is an edge of one triangle, so that no two threads find the same.
  team.each_range(cdt.triangles.size(), kItemsAtATime, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) look_at(static_cast<std::uint32_t>(t));
  });
  return at;
}

}  // namespace cover
