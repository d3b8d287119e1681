#include "cdt/cdt.hpp"

#include <gtest/gtest.h>

#include "geom/predicates.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

double area(const Triangulation& t) {
  double sum = 0;
  for (const Triangle& f : t.triangles) {
    sum += testing::doubled_area({t.points[f.v[0]], t.points[f.v[1]], t.points[f.v[2]]}) / 2;
  }
  return sum;
}

/// Neighbours mutual, locks equal from both sides, every triangle counter-clockwise.
void expect_consistent(const Triangulation& t) {
  for (std::uint32_t k = 0; k < t.triangles.size(); ++k) {
    const Triangle& f = t.triangles[k];
    ASSERT_EQ(orientation(t.points[f.v[0]], t.points[f.v[1]], t.points[f.v[2]]), Sign::positive);
    for (const Corner i : kCorners) {
      const std::uint32_t n = f.n[i];
      if (n == kNone) continue;
      const Triangle& g = t.triangles[n];
      const Corner j = g.edge_to(k);
      ASSERT_EQ(g.n[j], k);
      EXPECT_EQ(g.is_locked(j), f.is_locked(i));
    }
  }
}

TEST(TriangulateDomain, LeavesHolesAndTheOutsideEmpty) {
  const auto boundary = testing::boundary_of(
      {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, testing::reversed({{1, 1}, {2, 1}, {2, 2}, {1, 2}})});
  const CdtResult r = triangulate_domain(boundary.points, boundary.sides);
  ASSERT_TRUE(r.conflicts.empty());
  expect_consistent(r.triangulation);
  EXPECT_DOUBLE_EQ(area(r.triangulation), 15);
  EXPECT_EQ(r.triangulation.triangles.size(), 8U);
}

TEST(TriangulateDomain, KeepsSlitsAndIsolatedPoints) {
  auto boundary =
      testing::boundary_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {2, 2}}}, {{3, 1}});
  const CdtResult r = triangulate_domain(boundary.points, boundary.sides);
  ASSERT_TRUE(r.conflicts.empty());
  expect_consistent(r.triangulation);
  EXPECT_EQ(r.triangulation.triangles.size(), 8U);  // 2 * (7 points - 1) - 4 hull edges
}

TEST(TriangulateDomain, StandsSidesThatBoundNothing) {
  // Clockwise, with an island that is counter-clockwise: the left of the outer sides is outside.
  const auto boundary = testing::boundary_of(
      {testing::reversed({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), {{1, 1}, {2, 1}, {2, 2}, {1, 2}}});
  const CdtResult r = triangulate_domain(boundary.points, boundary.sides);
  ASSERT_TRUE(r.conflicts.empty());
  EXPECT_EQ(r.triangulation.triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(area(r.triangulation), 1);
  // A loop that is open: what is on its left runs on to the hull.
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const std::vector<IndexPair> open{{0, 1}, {1, 4}};
  const CdtResult leaked = triangulate_domain(points, open);
  expect_consistent(leaked.triangulation);
  EXPECT_DOUBLE_EQ(area(leaked.triangulation), 4);
  // Collinear points, as rounding may leave them.
  const std::vector<Point> line{{0, 0}, {1, 1}, {3, 3}};
  const std::vector<IndexPair> back_and_forth{{0, 1}, {1, 2}, {2, 1}, {1, 0}};
  EXPECT_TRUE(triangulate_domain(line, back_and_forth).triangulation.triangles.empty());
}

TEST(TriangulateHull, NamesWhatIsNoPslg) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  const std::vector<IndexPair> none, through{{0, 2}}, cross{{1, 3}, {0, 2}};
  auto r = triangulate_hull(square, through);
  ASSERT_EQ(r.conflicts.size(), 1U);
  EXPECT_EQ(r.conflicts[0].kind, CdtConflict::Kind::point_on_segment);
  EXPECT_EQ(r.conflicts[0].first, 4U);
  r = triangulate_hull(std::vector<Point>(square.begin(), square.end() - 1), cross);
  ASSERT_EQ(r.conflicts.size(), 1U);
  EXPECT_EQ(r.conflicts[0].kind, CdtConflict::Kind::crossing);
  EXPECT_EQ(r.conflicts[0].first, 0U);
  EXPECT_EQ(r.conflicts[0].second, 1U);
  const std::vector<Point> two{{0, 0}, {4, 4}, {0, 4}, {4, 0}, {9, 0}, {9, 4}, {8, 2}, {10, 2}};
  const std::vector<IndexPair> crossing{{0, 1}, {2, 3}, {4, 5}, {6, 7}};
  EXPECT_EQ(triangulate_domain(two, crossing).conflicts.size(), 1U);
  EXPECT_EQ(triangulate_domain(two, crossing, 5).conflicts.size(), 2U);
  auto twice = square;
  twice.push_back({1, 1});
  r = triangulate_hull(twice, none);
  ASSERT_EQ(r.conflicts.size(), 1U);
  EXPECT_EQ(r.conflicts[0].kind, CdtConflict::Kind::duplicate_point);
  EXPECT_EQ(r.conflicts[0].first, 2U);
  EXPECT_EQ(r.conflicts[0].second, 5U);
}

// Each of these takes minutes if something in it is quadratic.
TEST(TriangulateHull, StandsHubsAndLongChords) {
  constexpr std::uint32_t kSize = 30000;
  std::vector<Point> wheel{{0, 0}};
  std::vector<IndexPair> spokes;
  for (const Point& p : testing::regular_polygon(kSize)) {
    spokes.push_back({0, static_cast<std::uint32_t>(wheel.size())});
    wheel.push_back(p);
  }
  EXPECT_EQ(triangulate_hull(wheel, spokes).triangulation.triangles.size(), kSize);
  std::vector<Point> zigzag;
  std::vector<IndexPair> chords;
  for (std::uint32_t k = 0; k < kSize; ++k) {
    const double t = k / 2 / double{kSize}, bend = t * t * 0x1p-20;
    zigzag.push_back(k % 2 == 0 ? Point{t * 0x1p-10, bend}
                                : Point{t * 0x1p-10 + 0x1p-28, 1 - bend});
    if (k > 0) chords.push_back({k - 1, k});
  }
  EXPECT_TRUE(triangulate_hull(zigzag, chords).conflicts.empty());
}

// Nor may these be: nearly all points, or all of them, on one line.
TEST(TriangulateHull, StandsManyPointsOnALine) {
  constexpr std::uint32_t kSize = 100000;
  std::vector<Point> points;
  std::vector<IndexPair> row;
  for (std::uint32_t k = 0; k < kSize; ++k) {
    points.push_back({static_cast<double>(k), 2.0 * k});
    if (k > 0) row.push_back({k - 1, k});
  }
  const CdtResult flat = triangulate_hull(points, row);
  EXPECT_TRUE(flat.conflicts.empty());
  EXPECT_TRUE(flat.triangulation.triangles.empty());
  row.push_back({7, 9});
  const CdtResult over = triangulate_hull(points, row);
  row.pop_back();
  ASSERT_EQ(over.conflicts.size(), 1U);
  EXPECT_EQ(over.conflicts[0].kind, CdtConflict::Kind::point_on_segment);
  EXPECT_EQ(over.conflicts[0].first, 8U);
  points.push_back(points[77]);
  const CdtResult flat_twice = triangulate_hull(points, row);
  points.pop_back();
  ASSERT_EQ(flat_twice.conflicts.size(), 1U);
  EXPECT_EQ(flat_twice.conflicts[0].kind, CdtConflict::Kind::duplicate_point);
  EXPECT_EQ(flat_twice.conflicts[0].second, kSize);
  points.push_back({0, 1e5});
  const CdtResult fan = triangulate_hull(points, row);
  ASSERT_TRUE(fan.conflicts.empty());
  EXPECT_EQ(fan.triangulation.triangles.size(), kSize - 1);
  expect_consistent(fan.triangulation);
  points.push_back(points[77]);
  const CdtResult twice = triangulate_hull(points, row);
  ASSERT_EQ(twice.conflicts.size(), 1U);
  EXPECT_EQ(twice.conflicts[0].kind, CdtConflict::Kind::duplicate_point);
  EXPECT_EQ(twice.conflicts[0].first, 77U);
}

}  // namespace
}  // namespace cover
