#include "quality/moves/flip.hpp"

#include "quality/moves/relocate.hpp"
#include "quality/moves/remove.hpp"
#include "quality/moves/restar.hpp"
#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

/// Two triangles that share the edge from 1 to 2:
///
///        2
///       /|\        .
///      0 | 3       triangle 0 on the left, triangle 1 on the right
///       \|/
///        1
SmallMesh kite(const Goal& goal, Point left, Point right, double height,
               const std::vector<IndexPair>& slits = {}) {
  return {goal, {left, {0, 0}, {0, height}, right}, {}, {{0, 1, 2}, {1, 3, 2}}, slits};
}

TEST(Flip, MendsLargeAnglesOnBothSidesOfAnEdge) {
  // 127 degrees opposite to the edge. No vertex is free, and a new one sees a side of the rhombus
  // under 90 degrees at least.
  const Goal goal = goal_of(80, 20);
  SmallMesh small = kite(goal, {-1, 2}, {1, 2}, 4);
  expect_leaves_alone(try_relocate, small.mesh);
  expect_leaves_alone(try_remove, small.mesh);
  MutableMesh other = small.mesh;
  Workplace with_vertex(other);
  try_restar(with_vertex, 0);
  EXPECT_GE(angles_of(other).largest, 90 - 1e-9);
  EXPECT_NEAR(angles_of(small.mesh).largest, 126.87, 0.01);

  Workplace work(small.mesh);
  ASSERT_TRUE(try_flip(work, 0));
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangles[0].v, (std::array<std::uint32_t, 3>{0, 1, 3}));
  EXPECT_EQ(small.mesh.triangles[1].v, (std::array<std::uint32_t, 3>{0, 3, 2}));
  EXPECT_NEAR(angles_of(small.mesh).largest, 63.43, 0.01);
  EXPECT_LE(worst_excess(small.mesh), 0);
}

TEST(Flip, HasBothTrianglesAndThoseBesideThemLookedAtAgain) {
  // Triangle 2 lies beside the two that are flipped, triangle 3 only beside triangle 2.
  const std::vector<Point> points{{-1, 2}, {0, 0}, {0, 4}, {1, 2}, {3, 3}, {3, 5}};
  SmallMesh small(goal_of(80, 0), points, {}, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {2, 4, 5}});
  Workplace work(small.mesh);
  const std::uint64_t flips = work.flips_left;
  ASSERT_TRUE(try_flip(work, 0));
  EXPECT_EQ(again_of(work), (std::set<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(work.flips_left, flips - 1);
  expect_sound(small.mesh, small.boundary);
}

TEST(Flip, TakesTheEdgeThatWinsMost) {
  // Triangle 0 has 152 degrees at 2, which only the flip of its longest edge takes away. The flip
  // of the edge from 1 to 2 leaves them nearly as they are.
  const std::vector<Point> points{{0, 0}, {8, 0}, {4, 1}, {4, -5}, {7, 5}};
  SmallMesh small(goal_of(80, 0), points, {}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}});
  Workplace work(small.mesh);
  ASSERT_TRUE(try_flip(work, 0));
  EXPECT_EQ(small.mesh.triangles[0].v, (std::array<std::uint32_t, 3>{2, 0, 3}));
  EXPECT_EQ(small.mesh.triangles[1].v, (std::array<std::uint32_t, 3>{2, 3, 1}));
  EXPECT_EQ(small.mesh.triangles[2].v, (std::array<std::uint32_t, 3>{2, 1, 4}));
  expect_sound(small.mesh, small.boundary);
}

TEST(Flip, LeavesTheBetterOfTwoDiagonals) {
  SmallMesh better = kite(goal_of(62, 0), {-4, 1}, {4, 1}, 2);
  ASSERT_GT(worst_excess(better.mesh), 0);
  expect_leaves_alone(try_flip, better.mesh);
}

TEST(Flip, LeavesEqualDiagonalsAndGainsBelowAHundredth) {
  SmallMesh square = kite(goal_of(80, 0), {-1, 1}, {1, 1}, 2);
  ASSERT_GT(worst_excess(square.mesh), 0);
  expect_leaves_alone(try_flip, square.mesh);

  // 90.01 degrees, that of the other diagonal 89.99: the excess is lower by a thousandth.
  SmallMesh nearly = kite(goal_of(80, 0), {-0.9999, 1}, {0.9999, 1}, 2);
  const double before = worst_excess(nearly.mesh);
  const double after = nearly.mesh.excess_after_flip(0, 0, kInverted);
  ASSERT_LT(after, before);
  ASSERT_GT(after, improvement_of(before));
  expect_leaves_alone(try_flip, nearly.mesh);
}

TEST(Flip, RefusesWhatWouldTurnOverOrBeFlat) {
  // The other diagonal passes outside, above vertex 2, and then exactly through it.
  const Goal goal = goal_of(62, 0);
  SmallMesh reflex = kite(goal, {-2, 5}, {2, 5}, 2);
  ASSERT_GT(worst_excess(reflex.mesh), 0);
  expect_leaves_alone(try_flip, reflex.mesh);
  SmallMesh flat = kite(goal, {-2, 2}, {2, 2}, 2);
  ASSERT_GT(worst_excess(flat.mesh), 0);
  expect_leaves_alone(try_flip, flat.mesh);
}

TEST(Flip, RefusesSides) {
  // As in the first test, with a slit in place of the edge.
  SmallMesh slit = kite(goal_of(80, 20), {-1, 2}, {1, 2}, 4, {{1, 2}});
  ASSERT_EQ(slit.boundary.sides.size(), 6U);
  ASSERT_GT(worst_excess(slit.mesh), 0);
  expect_leaves_alone(try_flip, slit.mesh);
}

TEST(Flip, RefusesANegativeCouplingWhereTheyCount) {
  // 127 degrees at 0 and 37 at 3 are Delaunay. The other diagonal leaves 98 degrees, but the angles
  // opposite to it are more than 180 together.
  Goal goal = goal_of(100, 0);
  for (const bool couplings : {true, false}) {
    goal.coupling = {};
    if (couplings) goal.coupling = {.weight = 1, .inside = true, .strict = true};
    SmallMesh small = kite(goal, {-1, 2}, {6, 2}, 4);
    if (couplings) {
      expect_leaves_alone(try_flip, small.mesh);
      continue;
    }
    Workplace work(small.mesh);
    EXPECT_TRUE(try_flip(work, 0));
    EXPECT_LE(worst_excess(small.mesh), 0);
  }
}

TEST(Flip, EndsWithTheFlipsThatAreLeft) {
  SmallMesh small = kite(goal_of(80, 20), {-1, 2}, {1, 2}, 4);
  const Everything before(small.mesh);
  Workplace work(small.mesh);
  work.flips_left = 0;
  EXPECT_FALSE(try_flip(work, 0));
  EXPECT_TRUE(Everything(small.mesh) == before);
}

}  // namespace
}  // namespace cover
