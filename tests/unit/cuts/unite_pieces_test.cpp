#include "cuts/unite_pieces.hpp"

#include <gtest/gtest.h>

#include <random>

#include <cover/cover_mesh.hpp>

#include "cuts/cut_segments.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

TEST(UnitePieces, TakesCutsBack) {
  std::mt19937_64 random(1);
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Result<Prepared> prepared = prepare(testing::checker(3, 2, seed));
    ASSERT_TRUE(prepared.has_value());
    Pslg pslg = prepared->pslg;
    RegionTable table = prepared->table;
    const std::size_t first = pslg.points.size();
    std::vector<std::uint32_t> piece_of;
    for (int round = 0; round < 2; ++round) {  // pieces of pieces
      std::vector<SegmentCut> cuts;
      for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
        if (random() % 3 != 0) continue;
        const Point a = pslg.points[pslg.segments[s].a.index()];
        const Point b = pslg.points[pslg.segments[s].b.index()];
        cuts.push_back({SegmentId{s}, {{(2 * a.x + b.x) / 3, (2 * a.y + b.y) / 3}}});
      }
      cut_segments(pslg, table, cuts);
    }
    const std::size_t pieces = pslg.segments.size();
    piece_of = unite_pieces(pslg, table, first);
    EXPECT_EQ(piece_of.size(), pieces);
    EXPECT_EQ(pslg.points, prepared->pslg.points);
    EXPECT_EQ(pslg.point_markers, prepared->pslg.point_markers);
    ASSERT_EQ(pslg.segments.size(), prepared->pslg.segments.size());
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      EXPECT_EQ(pslg.segments[s].a, prepared->pslg.segments[s].a);
      EXPECT_EQ(pslg.segments[s].b, prepared->pslg.segments[s].b);
      EXPECT_EQ(table.sides[s].left, prepared->table.sides[s].left);
    }
    for (std::size_t k = 0; k < table.interfaces.size(); ++k)
      EXPECT_EQ(table.interfaces[k].segments, prepared->table.interfaces[k].segments);
    for (std::size_t k = 0; k < table.regions.size(); ++k)
      EXPECT_EQ(table.regions[k].sides, prepared->table.regions[k].sides);
  }
}

}  // namespace
}  // namespace cover
