// See verify_regions.hpp.
// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/verify_regions.hpp"

#include <algorithm>

#include "base/containers/union_find.hpp"
#include "base/numbers_where.hpp"

namespace cover {

TriangleRegions regions_of_triangles(const TriangleSoup& mesh, const SoupEdges& edges,
                                     std::span<const std::uint32_t> twins,
                                     std::span<const std::uint32_t> side_of,
                                     const ExpectedDomain& domain, const Team& team) {
  const auto all = edges.all();
  SharedUnionFind pieces(mesh.triangles.size());
  team.each_range(all.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const std::uint32_t twin = twins[k];
      if (side_of[k] != kNone || twin == kNone || side_of[twin] != kNone) continue;
      if (twin > k || twins[twin] != k)  // else the twin has done so
        pieces.unite(all[k].triangle, all[twin].triangle);
    }
  });

  TriangleRegions regions;
  std::vector<RegionId> of_piece(mesh.triangles.size(), kVoid);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (side_of[k] == kNone) continue;
    const RegionId region = domain.sides[side_of[k]].region;
    RegionId& known = of_piece[pieces.find(all[k].triangle)];
    if (known != kVoid && known != region) regions.mixed.push_back({k, known, region});
    known = region;
  }

  regions.of.assign(mesh.triangles.size(), kVoid);
  team.each_range(mesh.triangles.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      regions.of[t] = of_piece[pieces.find(static_cast<std::uint32_t>(t))];
  });
  for (const std::uint32_t k : numbers_where(
           all.size(),
           [&](std::uint32_t k) {
             return all[k].from == mesh.triangles[all[k].triangle][0] &&  // once per triangle
                    regions.of[all[k].triangle] == kVoid;
           },
           team))
    regions.lost.push_back(all[k].triangle);
  std::vector<bool> met(domain.nu_opt.size(), false);
  for (const RegionId region : regions.of) met[region.index()] = true;
  regions.count = static_cast<std::size_t>(std::count(met.begin() + 1, met.end(), true));
  return regions;
}

}  // namespace cover
