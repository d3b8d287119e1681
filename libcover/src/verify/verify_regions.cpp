// See verify_regions.hpp.
// Tested by tests/unit/verify/verify_test.cpp.
#include "verify/verify_regions.hpp"

#include <algorithm>

#include "base/containers/union_find.hpp"

namespace cover {

TriangleRegions regions_of_triangles(const TriangleSoup& mesh, const SoupEdges& edges,
                                     std::span<const std::uint32_t> side_of,
                                     const ExpectedDomain& domain) {
  const auto all = edges.all();
  UnionFind pieces(mesh.triangles.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (side_of[k] != kNoSide) continue;
    const auto twin = edges.find(all[k].to, all[k].from);
    if (twin && side_of[*twin] == kNoSide) pieces.unite(all[k].triangle, all[*twin].triangle);
  }

  TriangleRegions regions;
  std::vector<RegionId> of_piece(mesh.triangles.size(), kVoid);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (side_of[k] == kNoSide) continue;
    const RegionId region = domain.sides[side_of[k]].region;
    RegionId& known = of_piece[pieces.find(all[k].triangle)];
    if (known != kVoid && known != region) regions.mixed.push_back({k, known, region});
    known = region;
  }

  regions.of.assign(mesh.triangles.size(), kVoid);
  std::vector<bool> met(domain.nu_opt.size(), false);
  for (const SoupEdges::Edge& e : all) {
    if (e.from != mesh.triangles[e.triangle][0]) continue;  // once per triangle
    const RegionId region = of_piece[pieces.find(e.triangle)];
    regions.of[e.triangle] = region;
    if (region == kVoid)
      regions.lost.push_back(e.triangle);
    else
      met[region.index()] = true;
  }
  regions.count = static_cast<std::size_t>(std::count(met.begin(), met.end(), true));
  return regions;
}

}  // namespace cover
