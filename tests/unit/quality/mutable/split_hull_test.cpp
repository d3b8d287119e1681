#include "quality/mutable/split_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cdt/triangulation.hpp"
#include "geom/vector.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(SplitHull, PiecesAreSidesAndTheirEndsAreFixed) {
  // A triangle of which one side of the hull has two vertices on it, and one vertex lies inside.
  RegionBoundary boundary = testing::boundary_of({{{0, 0}, {6, 0}, {0, 6}}});
  const auto at = [&](Point p) {
    const auto found = std::find(boundary.points.begin(), boundary.points.end(), p);
    return static_cast<std::uint32_t>(found - boundary.points.begin());
  };
  const std::uint32_t a = at({0, 0}), b = at({6, 0}), c = at({0, 6});
  std::size_t bottom = 0;
  for (std::size_t s = 0; s < boundary.sides.size(); ++s) {
    if (boundary.sides[s] == IndexPair{a, b}) bottom = s;
  }
  boundary.segments[bottom] = kHullSide;
  std::vector<Point> points = boundary.points;
  const std::vector<Point> steiner{{2, 2}, {2, 0}, {4, 0}};
  points.insert(points.end(), steiner.begin(), steiner.end());
  const std::vector<IndexTriple> triples{{a, 4, 3}, {4, 5, 3}, {5, b, 3}, {b, c, 3}, {c, a, 3}};
  Triangulation triangles = with_neighbours(points, triples);
  const SplitSides sides = locate_split_sides(triangles, boundary);

  EXPECT_EQ(sides.fixed, 5U);
  ASSERT_EQ(sides.at.size(), 5U);
  EXPECT_EQ(sides.split, std::vector<std::uint32_t>({static_cast<std::uint32_t>(bottom)}));
  EXPECT_EQ(triangles.points[5], (Point{2, 2}));
  for (const EdgeRef& side : sides.at) {
    ASSERT_NE(side.triangle, kNone);
    EXPECT_EQ(triangles.triangles[side.triangle].n[side.edge], kNone);
  }
  const EdgeRef first = sides.at[bottom];
  const auto& v = triangles.triangles[first.triangle].v;
  EXPECT_EQ(v[first.edge.next()], a);
  EXPECT_EQ(triangles.points[v[first.edge.previous()]], (Point{2, 0}));

  // A side that is no side of the hull and not there is not replaced by anything.
  boundary.segments[bottom] = SegmentId{0U};
  EXPECT_EQ(locate_split_sides(triangles, boundary).at[bottom].triangle, kNone);
}

}  // namespace
}  // namespace cover
