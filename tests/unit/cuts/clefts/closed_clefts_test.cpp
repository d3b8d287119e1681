#include "cuts/clefts/closed_clefts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "comb.hpp"
#include "cuts/after_meshing/join_regions.hpp"
#include "cuts/unite_pieces.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"
#include "tasks/mesh_regions.hpp"

namespace cover {
namespace {

double area_of(const JoinedMesh& mesh, std::uint32_t region) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double area = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]) / 2;
    EXPECT_GT(area, 0);
    if (mesh.region[t] == region) sum += area;
  }
  return sum;
}

TEST(ClosedClefts, OpenedAgainTheyFillTheirRegions) {
  const Result<Prepared> prepared = prepare(comb(3, 1e-6));
  ASSERT_TRUE(prepared.has_value());
  const std::vector<Cleft> clefts =
      find_clefts(prepared->pslg, prepared->table, split_regions(prepared->pslg, prepared->table));
  ASSERT_EQ(clefts.size(), 3u);
  std::optional<ClosedClefts> closed = close_clefts(*prepared, clefts);
  ASSERT_TRUE(closed.has_value());
  ASSERT_EQ(closed->clefts.size(), 3u);
  // Both corners of an end have become one, and a slit begins at each.
  EXPECT_EQ(closed->point_before.size(), prepared->pslg.points.size() - 6 + 6);
  Work& work = closed->work;
  work.boundaries = split_regions(work.pslg, work.table);
  Result<std::vector<RegionMesh>> meshes = mesh_regions(work.boundaries, {}, {});
  ASSERT_TRUE(meshes.has_value());
  work.meshes = *std::move(meshes);
  Pslg uncut = work.pslg;
  RegionTable table = work.table;
  const auto whole = unite_pieces(uncut, table, closed->point_before.size());
  const std::optional<OpenedClefts> opened =
      open_clefts(join_regions(work, uncut, whole), *closed, *prepared);
  ASSERT_TRUE(opened.has_value());
  EXPECT_GT(opened->pairs.size(), 0u);
  for (std::size_t v = 0; v < prepared->pslg.points.size(); ++v)
    EXPECT_EQ(opened->mesh.points[v], prepared->pslg.points[v]);
  for (std::uint32_t r = 0; r < prepared->table.regions.size(); ++r)
    EXPECT_NEAR(area_of(opened->mesh, r), prepared->table.regions[r].area, 1e-12);
}

}  // namespace
}  // namespace cover
