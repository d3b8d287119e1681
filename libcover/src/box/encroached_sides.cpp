// The apex of a side in the constrained Delaunay triangulation sees it under the largest angle of
// all visible vertices, so it lies in the diametral disk if any of them does.
// Tested by tests/unit/box/encroached_sides_test.cpp.
#include "box/encroached_sides.hpp"

#include "geom/predicates.hpp"

namespace cover {

std::vector<EncroachedSide> encroached_sides(const Triangulation& cdt,
                                             std::span<const EdgeRef> at) {
  std::vector<EncroachedSide> found;
  for (std::size_t s = 0; s < at.size(); ++s) {
    if (at[s].triangle == kNone) continue;
    const auto& v = cdt.triangles[at[s].triangle].v;
    const Corner i = at[s].edge;
    const std::uint32_t a = v[i.next()], b = v[i.previous()];
    if (compare_with_90_degrees(cdt.points[a], cdt.points[v[i]], cdt.points[b]) == Sign::positive)
      found.push_back({s, v[i]});
  }
  return found;
}

std::vector<bool> free_sides(const Triangulation& cdt, std::span<const EdgeRef> at) {
  std::vector<bool> is_free(at.size(), true);
  for (const EncroachedSide& e : encroached_sides(cdt, at)) is_free[e.side] = false;
  return is_free;
}

}  // namespace cover
