#include "almond/fill/remainder.hpp"

#include <gtest/gtest.h>

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
    ASSERT_TRUE(r.faults.empty()) << n;
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
  EXPECT_FALSE(r.faults.empty());
}

}  // namespace
}  // namespace cover
