#include "cdt/sides.hpp"

#include <gtest/gtest.h>

#include "cdt/cdt.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(LocateSides, FindsTheTriangleOnTheLeftOfEverySide) {
  std::mt19937_64 random(7);
  const auto boundary = testing::boundary_of({testing::random_star(60, 0.2, random)});
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const std::vector<EdgeRef> at = locate_sides(cdt, boundary.sides);
  ASSERT_EQ(at.size(), boundary.sides.size());
  for (std::size_t s = 0; s < at.size(); ++s) {
    ASSERT_LT(at[s].triangle, cdt.triangles.size());
    const Triangle& t = cdt.triangles[at[s].triangle];
    EXPECT_EQ(t.v[at[s].edge.next()], boundary.sides[s][0]);
    EXPECT_EQ(t.v[at[s].edge.previous()], boundary.sides[s][1]);
    EXPECT_TRUE(t.is_locked(at[s].edge));
  }
}

TEST(LocateSides, SaysWhichPairsAreNoEdgesOfTriangles) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<IndexPair> sides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const Triangulation cdt = triangulate_domain(square, sides).triangulation;
  const std::vector<IndexPair> clockwise{{0, 3}, {1, 0}, {2, 1}, {3, 2}};
  for (const EdgeRef& at : locate_sides(cdt, clockwise)) EXPECT_EQ(at.triangle, kNone);
}

}  // namespace
}  // namespace cover
