#include "quality/moves/remove.hpp"

#include "quality/moves/flip.hpp"
#include "quality/moves/relocate.hpp"
#include "quality/moves/restar.hpp"
#include "quality/optimum/min_max_polygon.hpp"
#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

/// A triangle with a vertex in its middle, whose angles there are about 120 degrees.
///
///          2
///         /|\          triangle 0 below, 1 on the right, 2 on the left
///        / * \         .
///       /.' '.\        .
///      0-------1
SmallMesh vertex_of_three(const std::vector<Point>& more = {},
                          const std::vector<IndexTriple>& beside = {}) {
  std::vector<Point> points{{0, 0}, {4, 0}, {2, 3.5}};
  points.insert(points.end(), more.begin(), more.end());
  const auto v = static_cast<std::uint32_t>(points.size());
  std::vector<IndexTriple> corners{{0, 1, v}, {1, 2, v}, {2, 0, v}};
  corners.insert(corners.end(), beside.begin(), beside.end());
  return {default_goal(), points, {{2, 1.2}}, corners};
}

TEST(Remove, MendsLargeAnglesAroundAVertexOfThree) {
  // Wherever it is, one of three angles around a vertex has 120 degrees. Nothing can be flipped.
  SmallMesh small = vertex_of_three();
  EXPECT_GE(angles_of(small.mesh).largest, 120);
  expect_leaves_alone(try_flip, small.mesh);
  expect_leaves_alone(try_restar, small.mesh);
  MutableMesh other = small.mesh;
  Workplace moved(other);
  try_relocate(moved, 0);
  EXPECT_GE(angles_of(other).largest, 120 - 1e-9);

  Workplace work(small.mesh);
  ASSERT_TRUE(try_remove(work, 1));
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangle_count(), 1U);
  EXPECT_EQ(small.mesh.home[3], kNone);
  EXPECT_LE(worst_excess(small.mesh), 0);
}

TEST(Remove, HasNewTrianglesAndThoseBesideThemLookedAtAgain) {
  // Triangle 3 lies under the edge from 0 to 1, triangle 4 only beside triangle 3.
  SmallMesh small = vertex_of_three({{2, -3}, {4, -3}}, {{1, 0, 3}, {1, 3, 4}});
  Workplace work(small.mesh);
  ASSERT_TRUE(try_remove(work, 1));
  expect_sound(small.mesh, small.boundary);
  ASSERT_EQ(work.installed.count, 1);
  EXPECT_EQ(again_of(work), (std::set<std::uint32_t>{work.installed.triangles[0], 3}));
}

TEST(Remove, TakesFewerTrianglesWhereNothingIsWorse) {
  // A square has right angles with and without the vertex in its middle.
  SmallMesh small(goal_of(80, 0), {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{1, 1}},
                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const double before = worst_excess(small.mesh);
  Workplace work(small.mesh);
  ASSERT_TRUE(try_remove(work, 2));
  expect_sound(small.mesh, small.boundary);
  EXPECT_EQ(small.mesh.triangle_count(), 2U);
  EXPECT_EQ(worst_excess(small.mesh), before);
}

TEST(Remove, LeavesWhatWouldBeWorse) {
  SmallMesh small = hexagon_star(goal_of(61, 0), {0.1, 0.05});  // 120 degrees without its vertex
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_remove, small.mesh);
}

TEST(Remove, LeavesFixedVertices) {
  // As in the first test, but the vertex is one of the input.
  SmallMesh small(default_goal(), {{0, 0}, {4, 0}, {2, 3.5}, {2, 1.2}}, {},
                  {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  ASSERT_GT(worst_excess(small.mesh), 0);
  expect_leaves_alone(try_remove, small.mesh);
}

TEST(Remove, TurnsNothingOverInANonConvexStar) {
  // Of the two diagonals of an arrow one lies outside: it would be shorter.
  //
  //   2-------______        The vertex * sees all corners.
  //    \  *  3 ______       .
  //   1-------'      0
  const std::vector<Point> points{{0, -2}, {8, 0}, {0, 2}, {1, 0}};
  SmallMesh small(goal_of(100, 0), points, {{1.1, 0.01}},
                  {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  Workplace work(small.mesh);
  ASSERT_TRUE(try_remove(work, 0));
  expect_sound(small.mesh, small.boundary);  // exact signs
  std::set<std::set<std::uint32_t>> left;
  for (const MeshTriangle& t : small.mesh.triangles) {
    if (t.v[0] != kNone) left.insert({t.v.begin(), t.v.end()});
  }
  EXPECT_EQ(left, (std::set<std::set<std::uint32_t>>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Remove, LeavesStarsThatAreTooLarge) {
  for (const int corners : {kPolygonLimit, kPolygonLimit + 1}) {
    std::vector<IndexTriple> triangles;
    const auto n = static_cast<std::uint32_t>(corners);
    for (std::uint32_t k = 0; k < n; ++k) triangles.push_back({k, (k + 1) % n, n});
    // Beside the middle of the edge from 0 to 1, which it sees under nearly 180 degrees.
    const Loop loop = regular_polygon(corners);
    const Point middle = midpoint(loop[0], loop[1]);
    SmallMesh small(goal_of(100, 0), loop, {{0.999 * middle.x, 0.999 * middle.y}}, triangles);
    if (corners > kPolygonLimit) {
      expect_leaves_alone(try_remove, small.mesh);
      continue;
    }
    Workplace work(small.mesh);
    EXPECT_TRUE(try_remove(work, 0));
    EXPECT_EQ(small.mesh.triangle_count(), n - 2);
    expect_sound(small.mesh, small.boundary);
  }
}

}  // namespace
}  // namespace cover
