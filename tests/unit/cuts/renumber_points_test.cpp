#include "cuts/renumber_points.hpp"

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>

#include "region/region_graph.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

TEST(RenumberPoints, ChangesNothingButTheOrder) {
  Input input = testing::checker(2, 2, 4);
  input.points.push_back({5, 5});      // in the void
  input.points.push_back({0.3, 0.2});  // isolated
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    input.point_ids.push_back(100 + static_cast<long>(v));
    input.point_markers.push_back(static_cast<int>(v % 3));
  }
  input.point_names = {{static_cast<std::uint32_t>(input.points.size() - 1), "well"},
                       {2, "corner"}};
  const Result<Prepared> before = prepare(input);
  ASSERT_TRUE(before) << before.error().message;
  Pslg pslg = before->pslg;
  RegionTable table = before->table;
  const std::size_t n = pslg.points.size();
  std::vector<VertexId> new_ids;
  for (std::size_t v = 0; v < n; ++v) new_ids.emplace_back((v + 3) % n);
  renumber_points(pslg, table, new_ids);
  for (std::size_t v = 0; v < n; ++v) {
    const std::size_t to = new_ids[v].index();
    EXPECT_EQ(pslg.points[to], before->pslg.points[v]);
    EXPECT_EQ(pslg.point_ids[to], before->pslg.point_ids[v]);
    EXPECT_EQ(pslg.point_markers[to], before->pslg.point_markers[v]);
  }
  ASSERT_EQ(table.void_points.size(), 1U);
  EXPECT_EQ(pslg.points[table.void_points[0].index()], (Point{5, 5}));
  ASSERT_EQ(table.isolated_points.size(), 1U);
  EXPECT_EQ(pslg.points[table.isolated_points[0].vertex.index()], (Point{0.3, 0.2}));
  ASSERT_EQ(pslg.named_points.size(), 2U);
  EXPECT_EQ(pslg.points[pslg.named_points[0].vertex.index()], (Point{0.3, 0.2}));
  EXPECT_EQ(pslg.points[pslg.named_points[1].vertex.index()], input.points[2]);
  // Regions in canonical order do not notice.
  const auto old = split_regions(before->pslg, before->table), now = split_regions(pslg, table);
  for (std::size_t r = 0; r < old.size(); ++r) {
    EXPECT_EQ(now[r].points, old[r].points);
    EXPECT_EQ(now[r].sides, old[r].sides);
  }
}

}  // namespace
}  // namespace cover
