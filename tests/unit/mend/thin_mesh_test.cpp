#include "mend/thin_mesh.hpp"

#include <gtest/gtest.h>

#include "unit/mend/joined_meshes.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kFixed = JoinedMesh::kFixed;

std::size_t movable(const JoinedMesh& mesh) {
  std::size_t count = 0;
  for (const std::uint32_t line : mesh.line) count += line != kFixed ? 1 : 0;
  return count;
}

const ThinEffort kEffort{2000, 2'000'000, {10'000, 100'000}};

TEST(ThinMesh, AGridBecomesTwoTrianglesForEachRectangle) {
  const JoinedMesh before = testing::rectangles(12, 6, 4);
  MeshWithUndo mesh(before, std::vector<WantedAngles>(3));
  const BadTriangles bad = thin_mesh(mesh, kEffort);
  EXPECT_EQ(bad.before, 0u);
  EXPECT_EQ(bad.after, 0u);
  const JoinedMesh after = mesh.result(before);
  EXPECT_EQ(movable(after), 0u);  // cuts went from both sides of the walls
  EXPECT_EQ(after.triangles.size(), 6u);
  EXPECT_EQ(after.pieces.size(), 10u);
}

TEST(ThinMesh, AnglesThatAreAskedForStay) {
  const JoinedMesh before = testing::rectangles(32, 2, 32);
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

TEST(ThinMesh, ObtuseTrianglesAreMended) {
  const JoinedMesh flat = testing::flat_triangle(1);  // 127 degrees at the top
  MeshWithUndo mesh(flat, {{0}});
  const BadTriangles bad = thin_mesh(mesh, kEffort);
  EXPECT_EQ(bad.before, 1u);
  EXPECT_EQ(bad.after, 0u);
  const JoinedMesh after = mesh.result(flat);
  ASSERT_EQ(after.points.size(), 4u);  // the foot
  EXPECT_EQ(after.points[3], (Point{2, 0}));
}

TEST(ThinMesh, WhatIsWorseThanAnyMayBeGoesForWhatIsOnlyBad) {
  const JoinedMesh flat = testing::flat_triangle(
      0.4);  // 157 degrees at the top, 11 at both ends, which nothing makes larger
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

TEST(ThinMesh, MoreEffortIsNotWorse) {
  const JoinedMesh before = testing::rectangles(9, 9, 3);
  std::size_t last = movable(before);
  for (const std::uint64_t places : {1U, 20U, 500U}) {
    MeshWithUndo mesh(before, std::vector<WantedAngles>(3));
    thin_mesh(mesh, {places, 1'000'000, {1000, 10'000}});
    EXPECT_EQ(mesh.bad(), 0u);
    const std::size_t now = movable(mesh.result(before));
    EXPECT_LE(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace cover
