#include "quality/moves/relocate.hpp"

#include "quality/moves/flip.hpp"
#include "quality/moves/remove.hpp"
#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

/// Only angles near 60 degrees meet it: in a hexagon a star around its middle and no other mesh.
Goal even() { return goal_of(65, 55); }

TEST(Relocate, MendsSmallAndLargeAnglesAtAFreeVertex) {
  //     2---1
  //    /     \       .
  //   3      *0      the vertex * is close to corner 0: triangles 0 and 5 are thin
  //    \     /
  //     4---5
  SmallMesh small = hexagon_star(even(), {0.9, 0});
  EXPECT_LT(angles_of(small.mesh).smallest, 10);
  EXPECT_GT(angles_of(small.mesh).largest, 110);
  const Everything before(small.mesh);

  Workplace work(small.mesh);
  ASSERT_TRUE(try_relocate(work, 0));
  expect_sound(small.mesh, small.boundary);
  EXPECT_GE(angles_of(small.mesh).smallest, 55 - 1e-9);
  EXPECT_LE(angles_of(small.mesh).largest, 65 + 1e-9);
  EXPECT_LE(worst_excess(small.mesh), 0);
  EXPECT_LT(length(small.mesh.points[6] - Point{0, 0}), 0.1);

  // Nothing else has changed.
  Everything after(small.mesh);
  EXPECT_EQ(after.corners, before.corners);
  EXPECT_EQ(after.beyond, before.beyond);
  after.points[6] = before.points[6];
  EXPECT_EQ(after.points, before.points);
}

TEST(Relocate, MendsWhatNoFlipAndNoRemovalDoes) {
  // Without its vertex a hexagon has 120 degrees, and the flip of an edge of the star, too.
  SmallMesh small = hexagon_star(even(), {0.2, 0.1});
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_flip, small.mesh);
  expect_leaves_alone(try_remove, small.mesh);
  Workplace work(small.mesh);
  ASSERT_TRUE(try_relocate(work, 0));
  EXPECT_LE(worst_excess(small.mesh), 0);
}

TEST(Relocate, HasTheStarAndWhatLiesAroundItLookedAtAgain) {
  // Triangle 6 lies beside the star, triangle 7 only beside triangle 6.
  std::vector<Point> points = hexagon();
  points.push_back({1.5, 1});
  points.push_back({1, 2});
  SmallMesh small(
      even(), points, {{0.6, 0}},
      {{0, 1, 8}, {1, 2, 8}, {2, 3, 8}, {3, 4, 8}, {4, 5, 8}, {5, 0, 8}, {1, 0, 6}, {1, 6, 7}});
  Workplace work(small.mesh);
  ASSERT_TRUE(try_relocate(work, 0));
  EXPECT_EQ(again_of(work), (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5, 6}));
  expect_sound(small.mesh, small.boundary);
}

TEST(Relocate, LeavesAVertexAtItsBestPlace) {
  // Five angles around a vertex cannot all be below 72 degrees.
  SmallMesh small(goal_of(65, 0), regular_polygon(5), {{0, 0}},
                  {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}});
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_relocate, small.mesh);
}

TEST(Relocate, LeavesFixedVertices) {
  // As in the first test, but the vertex is one of the input.
  std::vector<Point> points = hexagon();
  points.push_back({0.9, 0});
  SmallMesh small(even(), points, {},
                  {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}});
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_relocate, small.mesh);
}

TEST(Relocate, LeavesAVertexThatDoesNotSeeItsLoop) {
  // On the line from 0 to 1, so that triangle 0 has no area.
  std::vector<Point> points{{2, 0}, {2, 2}, {0, 2}, {0, 0}};
  SmallMesh small(goal_of(100, 20), points, {{2, 1}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  ASSERT_EQ(small.mesh.excess[0], kInverted);
  expect_leaves_alone(try_relocate, small.mesh);
}

TEST(Relocate, StaysWhereTheVertexSeesAllOfItsLoop) {
  //           .-0
  //       .-'  /     An arrow, all of which is seen from beside corner 3 alone. The goal asks for
  //     1    *3      more than any place has, so that the vertex goes as far as it can.
  //       '-.  \     .
  //           '-2
  const std::vector<Point> points{{8, 5}, {-2, 0}, {8, -5}, {2, 0}};
  SmallMesh small(goal_of(61, 59), points, {{1.9, 0.01}},
                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const double before = worst_excess(small.mesh);
  Workplace work(small.mesh);
  ASSERT_TRUE(try_relocate(work, 0));
  expect_sound(small.mesh, small.boundary);  // exact signs
  EXPECT_LT(worst_excess(small.mesh), before);
}

}  // namespace
}  // namespace cover
