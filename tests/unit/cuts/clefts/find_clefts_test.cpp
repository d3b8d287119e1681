#include "cuts/clefts/find_clefts.hpp"

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>

#include "comb.hpp"
#include "geom/vector.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

std::vector<Cleft> clefts_of(const Prepared& prepared) {
  return find_clefts(prepared.pslg, prepared.table, split_regions(prepared.pslg, prepared.table));
}

TEST(FindClefts, FindsTheSlitsOfAComb) {
  const Result<Prepared> prepared = prepare(comb(4, 1e-6));
  ASSERT_TRUE(prepared.has_value());
  const std::vector<Cleft> clefts = clefts_of(*prepared);
  ASSERT_EQ(clefts.size(), 4u);
  for (const Cleft& cleft : clefts) {
    const auto at = [&](std::size_t end, std::size_t wall) {
      return prepared->pslg.points[cleft.end[end].corner[wall].index()];
    };
    for (const std::size_t end : {0, 1}) {
      EXPECT_LT(length(at(end, 1) - at(end, 0)), 2e-6);
      EXPECT_GT(cleft.end[end].room, 0.01);
      // Going along the first wall, the other one is on the right.
      EXPECT_LT(cross(at(1, 0) - at(0, 0), at(end, 1) - at(end, 0)), 0);
    }
    EXPECT_EQ(cleft.behind[0], cleft.behind[1]);
    EXPECT_NE(cleft.behind[0], cleft.region);
    // Below there is a segment, above none.
    const std::size_t low = at(0, 0).y < at(1, 0).y ? 0 : 1;
    EXPECT_TRUE(cleft.end[low].segment.has_value());
    EXPECT_EQ(cleft.end[low].beyond, cleft.behind[0]);
    EXPECT_FALSE(cleft.end[1 - low].segment.has_value());
    EXPECT_EQ(cleft.end[1 - low].beyond, cleft.region);
  }
}

TEST(FindClefts, WideSlitsAreNone) {
  const Result<Prepared> prepared = prepare(comb(4, 0.012));
  ASSERT_TRUE(prepared.has_value());
  EXPECT_TRUE(clefts_of(*prepared).empty());
}

}  // namespace
}  // namespace cover
