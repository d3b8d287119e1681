#include "geom/topology/mesh_borders.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace cover {
namespace {

/// n x n unit squares, each cut into two triangles, with the material that `of` gives each square.
template <class F>
CellMesh grid(int n, F of) {
  CellMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      mesh.points.push_back({double(x), double(y)});
      mesh.point_ids.push_back(100 + static_cast<long>(mesh.point_ids.size()));
    }
  mesh.materials = {"a", "b"};
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const std::uint32_t m = of(x, y);
      mesh.add_cell({at(x, y), at(x + 1, y), at(x + 1, y + 1)}, m);
      mesh.add_cell({at(x, y), at(x + 1, y + 1), at(x, y + 1)}, m);
    }
  return mesh;
}

TEST(BordersOf, KeepsTheOutlineAndTheInterfaceOnly) {
  const Input input = borders_of(grid(4, [](int x, int) { return x < 2 ? 0U : 1U; }));
  EXPECT_EQ(input.segments.size(), 16u + 4u);
  EXPECT_EQ(input.points.size(), 16u + 3u);  // inner nodes off the interface are gone
  EXPECT_EQ(input.point_ids[1], 101);
  EXPECT_EQ(input.void_rule, VoidRule::unseeded_faces);
  EXPECT_FALSE(input.seeds_may_miss);  // holes of a mesh are meant
  ASSERT_EQ(input.seeds.size(), 2u);
  EXPECT_EQ(input.seeds[0].material, "a");
  EXPECT_LT(input.seeds[0].at.x, 2);
  EXPECT_EQ(input.seeds[1].material, "b");
  EXPECT_GT(input.seeds[1].at.x, 2);
  EXPECT_TRUE(input.warnings.empty());
}

TEST(BordersOf, SeedsEveryPieceOfAMaterial) {
  // A checkerboard: squares of one material touch in points only.
  const Input input =
      borders_of(grid(4, [](int x, int y) { return static_cast<std::uint32_t>((x + y) % 2); }));
  EXPECT_EQ(input.seeds.size(), 16u);
  EXPECT_EQ(input.segments.size(), 40u);
}

TEST(BordersOf, SplitsAMaterialAlongALine) {
  CellMesh mesh = grid(2, [](int, int) { return 0U; });
  mesh.lines = {{1, 4, "cut", 5, 77}, {4, 7, "cut", 5, 78}, {7, 4, "cut", 5, 79}};
  const Input input = borders_of(mesh);
  EXPECT_EQ(input.seeds.size(), 2u);
  EXPECT_EQ(input.segments.size(), 10u);  // the repeated line is one segment
  long named = 0;
  for (const InputSegment& s : input.segments) named += s.name == "cut" && s.marker == 5;
  EXPECT_EQ(named, 2);
}

TEST(BordersOf, JoinsWhatWasNotStitched) {
  // Two squares that do not share the nodes of their common side, and one square twice.
  CellMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {2, 0}, {2, 1}, {1, 1}};
  mesh.point_ids = {1, 2, 3, 4, 5, 6, 7, 8};
  mesh.materials = {"a", "b"};
  mesh.add_cell({0, 1, 2, 3}, 0);
  mesh.add_cell({4, 5, 6, 7}, 1);
  mesh.add_cell({2, 3, 0, 1}, 1);
  const Input input = borders_of(mesh);
  EXPECT_EQ(input.points.size(), 6u);
  EXPECT_EQ(input.segments.size(), 7u);
  EXPECT_EQ(input.seeds.size(), 2u);
  ASSERT_EQ(input.warnings.size(), 2u);
  EXPECT_EQ(input.warnings[0], "2 nodes at the place of another: taken as the same");
  EXPECT_EQ(input.warnings[1], "1 cell given more than once: the first material counts");
}

TEST(BordersOf, FindsAPointInsideAnyPolygon) {
  // A hook whose centroid, and whose first corner triangle, lie outside or hold other corners.
  CellMesh mesh;
  mesh.points = {{0, 0}, {10, -4}, {1, 0.1}, {10, 4}};
  mesh.point_ids = {0, 1, 2, 3};
  mesh.materials = {"a"};
  mesh.add_cell({0, 1, 2, 3}, 0);
  const Input input = borders_of(mesh);
  ASSERT_EQ(input.seeds.size(), 1u);
  EXPECT_EQ(input.seeds[0].at, (Point{0.5, 0.05}));
}

TEST(BordersOf, GivesLinesAloneWithoutCells) {
  CellMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {5, 5}};
  mesh.point_ids = {0, 1, 2, 3};
  mesh.lines = {{0, 1, "", 0, 0}, {1, 2, "", 0, 1}, {2, 0, "", 0, 2}};
  mesh.kept = {3};
  const Input input = borders_of(mesh);
  EXPECT_EQ(input.segments.size(), 3u);
  EXPECT_EQ(input.points.size(), 4u);
  EXPECT_EQ(input.void_rule, VoidRule::holes_only);
  EXPECT_TRUE(input.seeds.empty());
}

}  // namespace
}  // namespace cover
