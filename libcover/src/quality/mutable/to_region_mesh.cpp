// See to_region_mesh.hpp. Tested by tests/unit/quality/quality_region_test.cpp.
#include "quality/mutable/to_region_mesh.hpp"

#include <atomic>
#include <vector>

#include "geom/predicates.hpp"

namespace cover {

RegionMesh to_region_mesh(const MutableMesh& mesh, const LocalFrame& frame,
                          std::span<const Point> points, const Team& team) {
  RegionMesh out;
  const auto fixed = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  out.steiner.reserve(mesh.points.size() - fixed);
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (v < fixed) {
      number[v] = v;
    } else if (mesh.home[v] != kNone) {
      number[v] = fixed + static_cast<std::uint32_t>(out.steiner.size());
      out.steiner.push_back(frame.restore(mesh.points[v]));
    }
  }
  out.triangles.reserve(mesh.triangle_count());
  for (const MeshTriangle& t : mesh.triangles) {
    if (t.v[0] != kNone) out.triangles.push_back({number[t.v[0]], number[t.v[1]], number[t.v[2]]});
  }
  const auto at = [&](std::uint32_t v) { return v < fixed ? points[v] : out.steiner[v - fixed]; };
  constexpr std::size_t kRange = 1 << 15;
  std::atomic<bool> is_valid = true;
  team.each_range(out.triangles.size(), kRange, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last && is_valid; ++k) {
      const auto& [a, b, c] = out.triangles[k];
      if (orientation(at(a), at(b), at(c)) != Sign::positive) is_valid = false;
    }
  });
  if (!is_valid) out.triangles.clear();
  return out;
}

}  // namespace cover
