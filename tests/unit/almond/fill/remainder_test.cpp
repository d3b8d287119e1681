#include "almond/fill/remainder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../stages.hpp"
#include "almond/almond_triangles.hpp"

namespace cover {
namespace {

using testing::square;
using testing::Stages;

TEST(FindRemainder, AreasAddUp) {
  for (const int n : {4, 5, 7, 12, 50}) {
    Stages s(testing::boundary_of({testing::regular_polygon(n)}));
    const Remainder r = find_remainder(s.layer, s.almonds, {});
    ASSERT_TRUE(r.blamed.empty()) << n;
    double area = 0;
    const auto add = [&](Point a, Point b, Point c) { area += cross(b - a, c - a) / 2; };
    for (const Triangle& f : r.cdt.triangles) {
      add(r.cdt.points[f.v[0]], r.cdt.points[f.v[1]], r.cdt.points[f.v[2]]);
    }
    std::vector<Point> points = s.layer.points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    SplitChords none;
    none.first.assign(s.layer.chords.size() + 1, 0);
    EXPECT_TRUE(triangulate_almonds(s.almonds, s.layer, none, s.rule, points, triangles).empty());
    for (const auto& t : triangles) add(points[t[0]], points[t[1]], points[t[2]]);
    EXPECT_NEAR(area, testing::area_of(s.boundary), 1e-14) << n;
  }
}

TEST(FindRemainder, NamesTheAlmondsOfChordsThatCross) {
  Stages s(square());
  // Push a cut of one arc far into the opposite almond.
  const auto chord = std::find_if(s.layer.chords.begin(), s.layer.chords.end(), [&](const auto& c) {
    return c.kind == ChordKind::exterior && c.b >= 8;
  });
  ASSERT_NE(chord, s.layer.chords.end());
  s.layer.points[chord->b] = {0.5, 3};
  const Remainder r = find_remainder(s.layer, s.almonds, {});
  EXPECT_FALSE(r.blamed.empty());
}

/// Three arcs run through a side that has no almond any more. All are told at once; one in each
/// trial, thousands of them used up all trials.
TEST(FindRemainder, NamesAllThatCrossASideLeftOut) {
  ChordLayer layer;
  layer.points = {{0, 0},    {10, 0}, {10, 5},   {8, 5}, {7.5, -1}, {7, 5},
                  {5.5, -1}, {5, 5},  {3.5, -1}, {3, 5}, {0, 5}};
  const std::vector<std::uint32_t> of_chord{0, 1, 2, 3, 3, 4, 4, 5, 5, 6, 7};
  std::vector<Almond> almonds(8);
  almonds[0].kind = AlmondKind::none;
  const auto n = static_cast<std::uint32_t>(layer.points.size());
  for (std::uint32_t k = 0; k < n; ++k)
    layer.chords.push_back({k, (k + 1) % n, of_chord[k], ChordKind::exterior, 0, 1});
  const Remainder r = find_remainder(layer, almonds, {});
  for (const std::uint32_t almond : {0U, 3U, 4U, 5U})
    EXPECT_NE(std::find(r.blamed.begin(), r.blamed.end(), almond), r.blamed.end()) << almond;
  EXPECT_EQ(std::find(r.blamed.begin(), r.blamed.end(), 1U), r.blamed.end());
}

/// Arcs of three pairs of almonds cross, and one of these a fourth: one by one on request only.
TEST(FindRemainder, NamesAsManyCrossingsAsAskedFor) {
  ChordLayer layer;
  std::vector<Almond> almonds(7);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double x = 10 * k;
    const auto first = static_cast<std::uint32_t>(layer.points.size());
    layer.points.insert(layer.points.end(), {{x, 0}, {x + 4, 4}, {x, 4}, {x + 4, 0}});
    layer.chords.push_back({first, first + 1, 2 * k, ChordKind::exterior, 0, 1});
    layer.chords.push_back({first + 2, first + 3, 2 * k + 1, ChordKind::exterior, 0, 1});
  }
  layer.points.insert(layer.points.end(), {{1, -1}, {1, 5}});
  layer.chords.push_back({12, 13, 6, ChordKind::exterior, 0, 1});
  const auto blamed = [&](std::size_t most) {
    std::vector<std::uint32_t> all = find_remainder(layer, almonds, {}, most).blamed;
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(blamed(1).size(), 2U);
  const std::vector<std::uint32_t> all = blamed(10);
  EXPECT_TRUE(std::adjacent_find(all.begin(), all.end()) == all.end());
  EXPECT_EQ(all.size(), 6U);  // of the three that cross each other, two
  for (const std::uint32_t almond : {2U, 3U, 4U, 5U})
    EXPECT_TRUE(std::binary_search(all.begin(), all.end(), almond)) << almond;
}

}  // namespace
}  // namespace cover
