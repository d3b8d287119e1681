#include "thin/fewer_vertices.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cover {
namespace {

constexpr std::uint32_t kFixed = ConformingMesh::kFixed, kInside = ConformingMesh::kInside;

/// Rectangles beside each other, columns x rows small squares in all, halved by diagonals; the
/// regions change at every `width`-th column. Lines may be cut, and are, where squares meet them.
ConformingMesh grid(std::uint32_t columns, std::uint32_t rows, std::uint32_t width) {
  ConformingMesh mesh;
  const auto number = [&](std::uint32_t x, std::uint32_t y) { return y * (columns + 1) + x; };
  const double right = columns, top = rows;
  const std::uint32_t strips = columns / width;
  // Lines: bottom and top of every strip, then walls from left to right.
  for (std::uint32_t s = 0; s < strips; ++s) {
    const double x = s * width, to = x + width;
    mesh.lines.push_back({{x, 0}, {to, 0}});
    mesh.lines.push_back({{x, top}, {to, top}});
  }
  for (std::uint32_t s = 0; s <= strips; ++s)
    mesh.lines.push_back({{double(s * width), 0}, {double(s * width), top}});
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) {
      mesh.points.push_back({double(x), double(y)});
      const bool wall = x % width == 0, edge = y == 0 || y == rows;
      const std::uint32_t strip = std::min(x / width, strips - 1);
      mesh.line.push_back(wall && edge ? kFixed
                          : wall       ? 2 * strips + x / width
                          : edge       ? 2 * strip + (y == 0 ? 0 : 1)
                                       : kInside);
      if (x < columns && edge)
        mesh.pieces.push_back({number(x, y), number(x + 1, y), 2 * strip + (y == 0 ? 0 : 1)});
      if (y < rows && wall)
        mesh.pieces.push_back({number(x, y), number(x, y + 1), 2 * strips + x / width});
      if (x == columns || y == rows) continue;
      mesh.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
      mesh.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
      mesh.region.insert(mesh.region.end(), 2, x / width);
    }
  }
  EXPECT_EQ(mesh.points.back(), (Point{right, top}));
  return mesh;
}

std::size_t movable(const ConformingMesh& mesh) {
  std::size_t count = 0;
  for (const std::uint32_t line : mesh.line) count += line != kFixed ? 1 : 0;
  return count;
}

const ThinEffort kEffort{2000, 2'000'000, 10'000, 100'000, {}};

TEST(FewerVertices, AGridBecomesTwoTrianglesForEachRectangle) {
  const ConformingMesh before = grid(12, 6, 4);
  MeshWithUndo mesh(before, std::vector<WantedAngles>(3));
  const Thinned thinned = thin_mesh(mesh, kEffort);
  EXPECT_EQ(thinned.bad_before, 0u);
  EXPECT_EQ(thinned.bad, 0u);
  const ConformingMesh after = mesh.result(before);
  EXPECT_EQ(movable(after), 0u);  // cuts went from both sides of the walls
  EXPECT_EQ(after.triangles.size(), 6u);
  EXPECT_EQ(after.pieces.size(), 10u);
}

TEST(FewerVertices, AnglesThatAreAskedForStay) {
  const ConformingMesh before = grid(32, 2, 32);
  MeshWithUndo mesh(before, {{1.01}});  // 44.7 degrees: squares, cut into halves
  EXPECT_EQ(mesh.bad(), 0u);
  thin_mesh(mesh, kEffort);
  EXPECT_EQ(mesh.bad(), 0u);
  const std::size_t kept = movable(mesh.result(before));
  EXPECT_GE(kept, 15u);  // one for every half of a square of the strip's height
  MeshWithUndo free(before, {{0}});
  thin_mesh(free, kEffort);
  EXPECT_EQ(movable(free.result(before)), 0u);
}

TEST(FewerVertices, ObtuseTrianglesAreMended) {
  ConformingMesh flat;  // 127 degrees at the top
  flat.points = {{0, 0}, {4, 0}, {2, 1}};
  flat.line.assign(3, kFixed);
  flat.lines = {{{0, 0}, {4, 0}}, {{4, 0}, {2, 1}}, {{2, 1}, {0, 0}}};
  flat.pieces = {{0, 1, 0}, {1, 2, 1}, {2, 0, 2}};
  flat.triangles = {{0, 1, 2}};
  flat.region = {0};
  MeshWithUndo mesh(flat, {{0}});
  const Thinned thinned = thin_mesh(mesh, kEffort);
  EXPECT_EQ(thinned.bad_before, 1u);
  EXPECT_EQ(thinned.bad, 0u);
  const ConformingMesh after = mesh.result(flat);
  ASSERT_EQ(after.points.size(), 4u);  // the foot
  EXPECT_EQ(after.points[3], (Point{2, 0}));
}

TEST(FewerVertices, WhatIsWorseThanAnyMayBeGoesForWhatIsOnlyBad) {
  ConformingMesh flat;  // 157 degrees at the top, 11 at both ends, which nothing makes larger
  flat.points = {{0, 0}, {4, 0}, {2, 0.4}};
  flat.line.assign(3, kFixed);
  flat.lines = {{{0, 0}, {4, 0}}, {{4, 0}, {2, 0.4}}, {{2, 0.4}, {0, 0}}};
  flat.pieces = {{0, 1, 0}, {1, 2, 1}, {2, 0, 2}};
  flat.triangles = {{0, 1, 2}};
  flat.region = {0};
  const double cot_of_30 = 1.7320508, cot_of_120 = -0.5773503;
  MeshWithUndo mesh(flat, {{cot_of_30, 0, false, cot_of_120}});
  EXPECT_EQ(mesh.beyond_worst(), 1u);
  thin_mesh(mesh, kEffort);
  EXPECT_EQ(mesh.beyond_worst(), 0u);
  EXPECT_EQ(mesh.bad(), 2u);
  MeshWithUndo any(flat, {{cot_of_30}});  // one bad triangle is better than two
  thin_mesh(any, kEffort);
  EXPECT_EQ(any.bad(), 1u);
}

TEST(FewerVertices, MoreEffortIsNotWorse) {
  const ConformingMesh before = grid(9, 9, 3);
  std::size_t last = movable(before);
  for (const std::uint64_t places : {1U, 20U, 500U}) {
    MeshWithUndo mesh(before, std::vector<WantedAngles>(3));
    thin_mesh(mesh, {places, 1'000'000, 1000, 10'000, {}});
    EXPECT_EQ(mesh.bad(), 0u);
    const std::size_t now = movable(mesh.result(before));
    EXPECT_LE(now, last);
    last = now;
  }
}

TEST(FewerVertices, CutsGoThroughAllThinLayersToWhereThereIsRoom) {
  // Sixty layers, a hundred times as long as thick, and a vertex in the middle of the first wall.
  constexpr std::uint32_t kLayers = 60;
  ConformingMesh before = grid(kLayers, 1, 1);
  for (Point& p : before.points) p.y *= 100;
  for (StraightLine& line : before.lines) line.a.y *= 100, line.b.y *= 100;
  const std::uint32_t middle = static_cast<std::uint32_t>(before.points.size());
  const std::uint32_t low = 0, right = 1, top = kLayers + 1, far = kLayers + 2;
  before.points.push_back({0, 50});
  before.line.push_back(kFixed);
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
  const Thinned thinned = mend_what_is_left(mesh, {0, 0, 100'000, 1'000'000, {}});
  EXPECT_EQ(thinned.bad, 0U);
  EXPECT_EQ(mesh.result(before).points.size(), before.points.size() + kLayers);
}

}  // namespace
}  // namespace cover
