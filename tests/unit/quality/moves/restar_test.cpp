#include "quality/moves/restar.hpp"

#include "quality/fault/merit.hpp"
#include "quality/moves/flip.hpp"
#include "quality/moves/relocate.hpp"
#include "quality/moves/remove.hpp"
#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

/// A pentagon without a free vertex: two ears of 108 and 36 degrees, and a triangle of 72 and 36.
///
///          1
///        .' '.
///       2-----0        the edges 2 0 and 3 0; triangle 0 above
///        \  .' /        .
///         3---4
SmallMesh pentagon(const Goal& goal, const std::vector<IndexPair>& slits = {}) {
  return {goal, regular_polygon(5), {}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, slits};
}

TEST(Restar, MendsASmallAngleWithANewVertex) {
  // The targets allow large angles: only the small ones are missed, and every triangulation of a
  // pentagon without a new vertex has ears.
  SmallMesh small = pentagon(goal_of(150, 45));
  EXPECT_NEAR(angles_of(small.mesh).smallest, 36, 1e-9);
  expect_leaves_alone(try_flip, small.mesh);
  expect_leaves_alone(try_relocate, small.mesh);
  expect_leaves_alone(try_remove, small.mesh);

  Workplace work(small.mesh);
  ASSERT_TRUE(try_restar(work, 0));
  expect_sound(small.mesh, small.boundary);
  EXPECT_GE(angles_of(small.mesh).smallest, 45 - 1e-9);
  EXPECT_EQ(small.mesh.triangle_count(), 5U);
  EXPECT_EQ(small.mesh.points.size(), 6U);
  EXPECT_LE(worst_excess(small.mesh), 0);
}

TEST(Restar, MendsALargeAngleWithANewVertex) {
  SmallMesh small = pentagon(goal_of(75, 0));
  EXPECT_NEAR(angles_of(small.mesh).largest, 108, 1e-9);
  Workplace work(small.mesh);
  ASSERT_TRUE(try_restar(work, 0));
  expect_sound(small.mesh, small.boundary);
  EXPECT_LE(angles_of(small.mesh).largest, 75 + 1e-9);
  EXPECT_LT(length(small.mesh.points[5] - Point{0, 0}), 0.1);
}

TEST(Restar, TakesInWhatANewVertexWouldMakeNegative) {
  // Where no coupling may become negative, a star must be Delaunay: from the ear and its neighbour
  // alone it is not, since the circle of the third triangle holds the new vertex.
  Goal goal = goal_of(75, 0);
  goal.coupling = {kCouplingFirst, true, true, kInverted};
  for (const std::uint32_t t : {0U, 2U}) {
    SmallMesh small = pentagon(goal);
    Workplace work(small.mesh);
    ASSERT_TRUE(try_restar(work, t));
    expect_sound(small.mesh, small.boundary);
    EXPECT_LE(angles_of(small.mesh).largest, 75 + 1e-9);
    EXPECT_EQ(merit_of(small.mesh, goal).negative, 0U);
  }
}

TEST(Restar, HasTheStarAndWhatLiesBesideItLookedAtAgain) {
  // The first triangle lies beside the pentagon, the second one only beside the first.
  std::vector<Point> points = regular_polygon(5);
  points.push_back({1.5, 1});
  points.push_back({1, 2});
  SmallMesh small(goal_of(75, 0), points, {},
                  {{1, 0, 5}, {1, 5, 6}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  Workplace work(small.mesh);
  ASSERT_TRUE(try_restar(work, 2));
  expect_sound(small.mesh, small.boundary);
  std::set<std::uint32_t> expected{0};
  for (int k = 0; k < work.installed.count; ++k) {
    expected.insert(work.installed.triangles[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(expected.size(), 6U);
  EXPECT_EQ(again_of(work), expected);
}

TEST(Restar, LeavesWhereNoVertexHelps) {
  // Four angles around a vertex of a square, three around one of a triangle.
  SmallMesh square(goal_of(85, 0), {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, {{0, 1, 2}, {0, 2, 3}});
  ASSERT_GT(worst_excess(square.mesh), 0);
  expect_leaves_alone(try_restar, square.mesh);
  SmallMesh triangle(goal_of(70, 0), {{0, 0}, {2, 0}, {1, 1}}, {}, {{0, 1, 2}});
  ASSERT_GT(worst_excess(triangle.mesh), 0);
  expect_leaves_alone(try_restar, triangle.mesh);
}

TEST(Restar, RefusesHolesAcrossSides) {
  // As in the second test, with slits for edges: a hole is one triangle.
  SmallMesh small = pentagon(goal_of(75, 0), {{0, 2}, {0, 3}});
  ASSERT_EQ(small.boundary.sides.size(), 9U);
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_restar, small.mesh);
}

TEST(Restar, KeepsAFixedVertexThatLiesInside) {
  // A vertex of three, one of the input, in one of two halves of a square.
  const Point inside{1.3, 0.6};
  SmallMesh small(goal_of(95, 40), {{0, 0}, {2, 0}, {2, 2}, {0, 2}, inside}, {},
                  {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {0, 2, 3}});
  const double before = worst_excess(small.mesh);
  Workplace work(small.mesh);
  ASSERT_TRUE(try_restar(work, 2));
  expect_sound(small.mesh, small.boundary);
  EXPECT_LT(worst_excess(small.mesh), before);
  EXPECT_EQ(small.mesh.points[4], inside);
  EXPECT_NE(small.mesh.home[4], kNone);
}

TEST(Restar, TurnsNothingOverWhereAHoleIsNotSeen) {
  //   7---6       3---2     A bay: no point sees all of it, so that no hole is the whole. What is
  //   |   |       |   |     filled is seen by its vertex, exactly.
  //   |   5-------4   |
  //   0---------------1
  const std::vector<Point> points{{0, 0},   {6, 0},   {6, 3}, {5, 3},
                                  {5, 0.5}, {1, 0.5}, {1, 3}, {0, 3}};
  SmallMesh small(goal_of(75, 30), points, {},
                  {{0, 1, 5}, {5, 1, 4}, {1, 2, 4}, {4, 2, 3}, {0, 5, 7}, {7, 5, 6}});
  Workplace work(small.mesh);
  for (std::uint32_t t = 0; t < 6; ++t) {
    const double before = worst_excess(small.mesh);
    try_restar(work, t);
    expect_sound(small.mesh, small.boundary);
    EXPECT_LE(worst_excess(small.mesh), before);
  }
}

}  // namespace
}  // namespace cover
