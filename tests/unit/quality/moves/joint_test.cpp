#include "quality/moves/joint.hpp"

#include "quality/moves/relocate.hpp"
#include "small_mesh.hpp"

namespace cover {
namespace {

using namespace testing;

/// Two free vertices, each the middle of its half of an octagon:
///
///      5-------4-------3
///     /      .' '.      \       vertices 8 on the left, 9 on the right; triangle 0 lies above
///    6     8 ----- 9     2      the edge between them, triangle 1 below, and 8 triangles
///     \      '. .'      /       around
///      7-------0-------1
SmallMesh two_stars(const Goal& goal, const std::vector<Point>& octagon, Point left, Point right,
                    std::uint32_t fixed = 8) {
  std::vector<Point> all = octagon;
  all.push_back(left);
  all.push_back(right);
  const std::vector<IndexTriple> triangles{{4, 8, 9}, {0, 9, 8}, {8, 4, 5}, {8, 5, 6}, {8, 6, 7},
                                           {8, 7, 0}, {9, 0, 1}, {9, 1, 2}, {9, 2, 3}, {9, 3, 4}};
  return {goal, {all.begin(), all.begin() + fixed}, {all.begin() + fixed, all.end()}, triangles};
}

/// Two squares side by side.
const std::vector<Point> kSquares{{0, -1}, {2, -1}, {2.2, 0},  {2, 1},
                                  {0, 1},  {-2, 1}, {-2.2, 0}, {-2, -1}};
/// One wide half and one narrow one.
const std::vector<Point> kUneven{{0, -0.85}, {1.6, -0.6}, {3.1, 0.2}, {2.1, 1.9},
                                 {0, 0.55},  {-1.4, 0.3}, {-1.5, 0},  {-1.7, -0.4}};

/// Each vertex moved alone, until none gets better.
void relocate_all(MutableMesh& mesh) {
  Workplace work(mesh);
  for (int k = 0; k < 100; ++k) {
    bool has_moved = false;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) has_moved |= try_relocate(work, t);
    if (!has_moved) return;
  }
  ADD_FAILURE() << "moves for ever";
}

std::uint32_t worst_triangle(const MutableMesh& mesh) {
  return static_cast<std::uint32_t>(std::max_element(mesh.excess.begin(), mesh.excess.end()) -
                                    mesh.excess.begin());
}

TEST(Joint, MendsWhereTrianglesTieThatShareVertices) {
  // No move of one vertex lowers the worst excess. Two at once halve it.
  SmallMesh small = two_stars(goal_of(80, 0), kUneven, {-1, 0}, {1, 0});
  relocate_all(small.mesh);
  const double stuck = worst_excess(small.mesh);
  ASSERT_GT(stuck, 0);
  const Everything before(small.mesh);

  std::uint64_t evaluations = 0;
  JointMove move;
  do {
    move = place_jointly(small.mesh, worst_triangle(small.mesh));
    evaluations += move.evaluations;
    expect_sound(small.mesh, small.boundary);
  } while (move.has_moved);
  EXPECT_LT(worst_excess(small.mesh), 0.5 * stuck);
  EXPECT_GT(evaluations, 0U);

  // Only the free vertices have moved.
  const Everything after(small.mesh);
  EXPECT_EQ(after.corners, before.corners);
  EXPECT_EQ(after.beyond, before.beyond);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(after.points[v], before.points[v]);
  EXPECT_NE(after.points[8], before.points[8]);
  EXPECT_NE(after.points[9], before.points[9]);
}

TEST(Joint, LeavesTheBestPlaces) {
  SmallMesh small = two_stars(goal_of(61, 0), kSquares, {-0.9, 0.1}, {0.9, 0.2});
  int moved = 0;
  while (moved < 50 && place_jointly(small.mesh, worst_triangle(small.mesh)).has_moved) ++moved;
  ASSERT_GT(moved, 0);
  ASSERT_LT(moved, 50);
  ASSERT_GT(worst_excess(small.mesh), 0);
  const Everything before(small.mesh);
  EXPECT_FALSE(place_jointly(small.mesh, worst_triangle(small.mesh)).has_moved);
  EXPECT_TRUE(Everything(small.mesh) == before);
}

TEST(Joint, LeavesFixedVerticesAndNeedsTwoFreeOnes) {
  for (const std::uint32_t fixed : {9U, 10U}) {
    SmallMesh small = two_stars(goal_of(65, 0), kSquares, {-0.4, 0.5}, {0.5, 0.4}, fixed);
    ASSERT_GT(worst_excess(small.mesh), 0);
    const Everything before(small.mesh);
    const JointMove move = place_jointly(small.mesh, 0);
    EXPECT_FALSE(move.has_moved);
    EXPECT_TRUE(Everything(small.mesh) == before);
    EXPECT_EQ(move.evaluations, 0U);
  }
}

TEST(Joint, LeavesWhatMeetsTheGoal) {
  SmallMesh small = two_stars(goal_of(120, 0), kSquares, {-1, 0}, {1, 0});
  ASSERT_LE(worst_excess(small.mesh), 0);
  const Everything before(small.mesh);
  EXPECT_FALSE(place_jointly(small.mesh, 0).has_moved);
  EXPECT_TRUE(Everything(small.mesh) == before);
}

}  // namespace
}  // namespace cover
