#include "cuts/unite_pieces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include <cover/cover_mesh.hpp>

#include "cuts/cut_segments.hpp"
#include "geom/curves/arc.hpp"
#include "geom/vector.hpp"
#include "support/inputs/arc_devices.hpp"
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
    const United united = unite_pieces(pslg, table, first);
    EXPECT_EQ(united.whole.size(), pieces);
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

/// A chord has a cut on its arc, and its halves are made straight, one of them cut once more: what
/// was a chord stays as it is, and straight segments are whole again.
TEST(UnitePieces, LeavesPointsOnArcs) {
  Input input = testing::input_of({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}});
  testing::add_circle(input, {0, 0}, 2, 6);
  const Result<Prepared> prepared = prepare(input);
  ASSERT_TRUE(prepared.has_value());
  Pslg pslg = prepared->pslg;
  RegionTable table = prepared->table;
  const std::size_t first = pslg.points.size();
  const auto at = [&](VertexId v) { return pslg.points[v.index()]; };
  const auto is_chord = [&](const Segment& s) { return circle_of(pslg, s) != nullptr; };
  const auto cut = [&](std::size_t s, Point p) {
    cut_segments(pslg, table, std::array{SegmentCut{SegmentId{s}, {p}}});
  };
  std::size_t chord = 0, line = 0;
  while (!is_chord(pslg.segments[chord])) ++chord;
  while (is_chord(pslg.segments[line])) ++line;
  const Segment whole = pslg.segments[chord];
  const Point middle = midpoint(at(whole.a), at(whole.b));
  const Point on_arc = Point{0, 0} + (2 / length(middle - Point{0, 0})) * (middle - Point{0, 0});
  cut(line, midpoint(at(pslg.segments[line].a), at(pslg.segments[line].b)));
  chord = 0;
  while (!is_chord(pslg.segments[chord])) ++chord;
  cut(chord, on_arc);
  straighten(pslg.segments[chord]);
  straighten(pslg.segments[chord + 1]);
  cut(chord + 1, midpoint(on_arc, at(whole.b)));

  const United united = unite_pieces(pslg, table, first);
  EXPECT_EQ(pslg.points.size(), first + 2);
  EXPECT_EQ(pslg.points[first], on_arc);
  EXPECT_EQ(pslg.segments.size(), prepared->pslg.segments.size() + 2);
  EXPECT_EQ(united.number,
            (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, kNone, 10, 11}));
  EXPECT_EQ(united.whole[chord + 1], united.whole[chord] + 1);
  EXPECT_EQ(united.whole[chord + 2], united.whole[chord + 1] + 1);
  EXPECT_EQ(pslg.segments[united.whole[chord]].b, VertexId{first});
  EXPECT_EQ(pslg.segments[united.whole[chord + 2]].b, whole.b);
}

}  // namespace
}  // namespace cover
