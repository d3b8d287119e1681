#include "almond/almond_triangles.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "stages.hpp"

namespace cover {
namespace {

using testing::Stages;

TEST(TriangulateAlmonds, PaperCentreSeesTheSideUnderThePromisedAngle) {
  const Stages s(testing::boundary_of({testing::regular_polygon(20)}));
  std::vector<Point> points = s.layer.points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  SplitChords none;
  none.first.assign(s.layer.chords.size() + 1, 0);
  ASSERT_TRUE(triangulate_almonds(s.almonds, s.layer, none, s.rule, points, triangles).empty());
  EXPECT_EQ(points.size() - s.layer.points.size(), 20U);  // a centre each
  double least = 4;
  for (const auto& t : triangles) {
    const Point a = points[t[0]], b = points[t[1]], c = points[t[2]];
    least = std::min({least, nu_at(b, a, c), nu_at(c, b, a), nu_at(a, c, b)});
  }
  EXPECT_NEAR(least, std::numbers::pi / 6, 1e-12);
}

}  // namespace
}  // namespace cover
