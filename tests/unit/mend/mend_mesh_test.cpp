#include "mend/mend_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mend/effort.hpp"
#include "unit/mend/joined_meshes.hpp"

namespace cover {
namespace {

TEST(MendMesh, CutsGoThroughAllThinLayersToWhereThereIsRoom) {
  // Sixty layers, a hundred times as long as thick, and a vertex in the middle of the first wall.
  constexpr std::uint32_t kLayers = 60;
  JoinedMesh before = testing::rectangles(kLayers, 1, 1);
  for (Point& p : before.points) p.y *= 100;
  for (StraightLine& line : before.lines) line.a.y *= 100, line.b.y *= 100;
  const std::uint32_t middle = static_cast<std::uint32_t>(before.points.size());
  const std::uint32_t low = 0, right = 1, top = kLayers + 1, far = kLayers + 2;
  before.points.push_back({0, 50});
  before.line.push_back(JoinedMesh::kFixed);
  const auto whole = std::find_if(before.pieces.begin(), before.pieces.end(),
                                  [&](const auto& p) { return p.a == low && p.b == top; });
  ASSERT_NE(whole, before.pieces.end());
  const std::uint32_t wall = whole->line;
  *whole = {low, middle, wall};
  before.pieces.push_back({middle, top, wall});
  before.triangles[0] = {low, right, middle};
  before.triangles[1] = {right, far, middle};
  before.triangles.push_back({far, top, middle});
  before.region.push_back(0);
  MeshWithUndo mesh(before, std::vector<WantedAngles>(kLayers));
  ASSERT_EQ(mesh.bad(), 1U);
  const BadTriangles bad = mend_what_is_left(mesh, {100'000, 1'000'000});
  EXPECT_EQ(bad.after, 0U);
  EXPECT_EQ(mesh.result(before).points.size(), before.points.size() + kLayers);
}

TEST(MendMesh, TheFootMendsAnObtuseCornerOverAPiece) {
  const JoinedMesh flat = testing::flat_triangle(1);  // 127 degrees at the top
  MeshWithUndo mesh(flat, {{0}});
  EXPECT_EQ(mesh.grave(), 1U);
  const BadTriangles none = mend_mesh(mesh, {}, 0);  // no places, nothing done
  EXPECT_EQ(none.after, 1U);
  const BadTriangles bad = mend_mesh(mesh, {10'000, 10'000}, 0);
  EXPECT_EQ(bad.before, 1U);
  EXPECT_EQ(bad.after, 0U);
  EXPECT_EQ(mesh.result(flat).points.back(), (Point{2, 0}));
}

TEST(MendMesh, ManyThatNothingMendsAreTriedLess) {
  // Flat triangles whose sides stay whole: each vertex inside sees the longest one flat as well.
  const auto spent_on = [](std::size_t count) {
    JoinedMesh before;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t a = 3 * k, b = a + 1, c = a + 2;
      for (const Point& p : {Point{0, 10.0 * k}, Point{4, 10.0 * k}, Point{2, 10.0 * k + 1}})
        before.points.push_back(p);
      before.pieces.insert(before.pieces.end(), {{a, b, a}, {b, c, b}, {c, a, c}});
      before.triangles.push_back({a, b, c});
      before.region.push_back(0);
    }
    before.line.assign(before.points.size(), JoinedMesh::kFixed);
    MeshWithUndo mesh(before, {{0}});
    constexpr std::uint64_t kPlaces = 100'000'000;
    Repairs repairs(mesh, {kPlaces});
    mend_with_more_vertices(repairs, effort::mend::kMostTries);
    EXPECT_EQ(mesh.bad(), count);
    return static_cast<double>(kPlaces - repairs.left().count);
  };
  const double first = spent_on(effort::mend::kManyInVain);
  EXPECT_GT(first, 0);
  EXPECT_LT(spent_on(2 * effort::mend::kManyInVain), 1.5 * first);
}

}  // namespace
}  // namespace cover
