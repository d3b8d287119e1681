// Each kind of repair on a mesh of its own: what came about is better, what did not left no trace.
#include "mend/repairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mend/effort.hpp"
#include "unit/mend/joined_meshes.hpp"

namespace cover {
namespace {

constexpr std::uint64_t kPlacesForAll = 100'000;

MostBad none_bad() { return {0, 0, kNone, 0}; }

void expect_same(const JoinedMesh& a, const JoinedMesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.line, b.line);
  EXPECT_EQ(a.region, b.region);
  std::vector<IndexTriple> of_a = a.triangles, of_b = b.triangles;
  for (std::vector<IndexTriple>* all : {&of_a, &of_b}) {
    for (IndexTriple& t : *all)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(all->begin(), all->end());
  }
  EXPECT_EQ(of_a, of_b);
}

/// A hexagon: without the vertex in its middle, its corners of 120 degrees would be those of
/// triangles.
struct Needed {
  JoinedMesh before = testing::hexagon_around({0, 0});
  MeshWithUndo mesh{before, {{0}}};
  std::uint32_t inside = 6;
};

TEST(Repairs, AVertexGoesWhereNothingIsWorseWithoutIt) {
  const JoinedMesh before = testing::rectangles(4, 4, 4);
  MeshWithUndo mesh(before, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  const std::uint32_t middle = 12;
  EXPECT_TRUE(repairs.without(middle, MostBad::in(mesh)));
  EXPECT_FALSE(mesh.is_there(middle));
  EXPECT_EQ(repairs.left().count, kPlacesForAll - kRemoval);
}

TEST(Repairs, AVertexThatIsNeededStaysAndTheMeshIsAsItWas) {
  Needed needed;
  const JoinedMesh first = needed.mesh.result(needed.before);
  Repairs repairs(needed.mesh, {kPlacesForAll});
  EXPECT_FALSE(repairs.without(needed.inside, MostBad::in(needed.mesh)));
  EXPECT_TRUE(needed.mesh.is_there(needed.inside));
  expect_same(needed.mesh.result(needed.before), first);
}

TEST(Repairs, WhatCameAboutIsTakenBackUnlessItIsKept) {
  const JoinedMesh before = testing::rectangles(4, 4, 4);
  MeshWithUndo mesh(before, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  ASSERT_TRUE(repairs.without(12, MostBad::in(mesh)));
  mesh.keep();
  ASSERT_TRUE(repairs.without(6, MostBad::in(mesh)));
  mesh.undo(0);
  EXPECT_FALSE(mesh.is_there(12));
  EXPECT_TRUE(mesh.is_there(6));
}

TEST(Repairs, MoreVerticesMendAnObtuseCorner) {
  const JoinedMesh flat = testing::flat_triangle(1);
  MeshWithUndo mesh(flat, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  ASSERT_TRUE(repairs.is_bad(0));
  EXPECT_TRUE(repairs.is_grave(0));
  EXPECT_FALSE(repairs.is_bad_by_a_movable(0)) << "its corner is fixed, and it is gravely bad";
  EXPECT_TRUE(repairs.with_more_vertices(0, none_bad(), 1));
  EXPECT_EQ(mesh.bad(), 0U);
  EXPECT_EQ(mesh.result(flat).points.back(), (Point{2, 0})) << "the foot";
}

TEST(Repairs, CutsMendItToo) {
  const JoinedMesh flat = testing::flat_triangle(1);
  MeshWithUndo mesh(flat, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  EXPECT_TRUE(repairs.with_cuts(0, none_bad()));
  EXPECT_EQ(mesh.result(flat).points.back(), (Point{2, 0}));
}

TEST(Repairs, WithoutPlacesNothingIsMendedAndNothingChanges) {
  const JoinedMesh flat = testing::flat_triangle(1);
  MeshWithUndo mesh(flat, {{0}});
  Repairs repairs(mesh, {0});
  EXPECT_FALSE(repairs.with_more_vertices(0, none_bad(), effort::mend::kMostTries));
  EXPECT_FALSE(repairs.with_fewer_vertices(0, none_bad()));
  EXPECT_FALSE(repairs.with_other_vertices(0, none_bad(), 1000));
  EXPECT_FALSE(repairs.with_cuts(0, none_bad()));
  EXPECT_EQ(mesh.bad(), 1U);
  expect_same(mesh.result(flat), flat);
}

TEST(Repairs, NoPlaceIsTriedForOthersWhereNoVertexNearCanBePutElsewhere) {
  JoinedMesh before = testing::hexagon_around({1.5, 0});
  before.line[6] = JoinedMesh::kFixed;
  MeshWithUndo mesh(before, {{0}});
  ASSERT_GT(mesh.bad(), 0U);
  const auto bad = std::find_if(mesh.triangles().begin(), mesh.triangles().end(),
                                [](const MeshWithUndo::Triangle& t) { return t.cost > 0; });
  Repairs repairs(mesh, {kPlacesForAll});
  const auto t = static_cast<std::uint32_t>(bad - mesh.triangles().begin());
  EXPECT_FALSE(repairs.with_other_vertices(t, none_bad(), kPlacesForAll));
  EXPECT_EQ(repairs.left().count, kPlacesForAll);
}

TEST(Repairs, FewerVerticesMendWhatOneOfThemMakesBad) {
  // A right-angled triangle with a vertex next to its longest side, which sees that side flat.
  JoinedMesh before;
  before.points = {{0, 0}, {4, 0}, {0, 4}, {1.9, 1.9}};
  before.line = {JoinedMesh::kFixed, JoinedMesh::kFixed, JoinedMesh::kFixed, JoinedMesh::kInside};
  before.pieces = {{0, 1, 0}, {1, 2, 1}, {2, 0, 2}};
  before.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  before.region = {0, 0, 0};
  MeshWithUndo mesh(before, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  std::uint32_t bad = 0;
  while (!repairs.is_bad(bad)) ++bad;
  EXPECT_TRUE(repairs.with_fewer_vertices(bad, none_bad()));
  EXPECT_FALSE(mesh.is_there(3));
  EXPECT_EQ(mesh.bad(), 0U);
}

TEST(Repairs, OthersComeInPlaceOfThoseThatGo) {
  const JoinedMesh before = testing::rectangles(6, 6, 6);
  MeshWithUndo mesh(before, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  const std::array<std::uint32_t, 2> middle{24, 25};
  int asked_of = 0;
  EXPECT_TRUE(repairs.with_others_in_place_of(middle, MostBad::in(mesh), [&](int taken) -> Others {
    asked_of = taken;
    return {taken - 1, 20};
  }));
  EXPECT_EQ(asked_of, 2);
  EXPECT_LT(mesh.result(before).points.size(), before.points.size());
  EXPECT_EQ(mesh.bad(), 0U);
}

TEST(Repairs, WhereNoOthersWillDoTheOldOnesAreThereAgain) {
  Needed needed;
  const JoinedMesh first = needed.mesh.result(needed.before);
  Repairs repairs(needed.mesh, {kPlacesForAll});
  EXPECT_FALSE(
      repairs.with_others_in_place_of(std::array{needed.inside}, MostBad::in(needed.mesh), [](int) {
        return Others{0, 20};
      }));
  expect_same(needed.mesh.result(needed.before), first);
}

TEST(Repairs, NobodyAsksForOthersInPlaceOfNone) {
  Needed needed;
  Repairs repairs(needed.mesh, {kPlacesForAll});
  EXPECT_FALSE(repairs.with_others_in_place_of({}, MostBad::in(needed.mesh), [](int) -> Others {
    ADD_FAILURE() << "nothing was taken away";
    return {};
  }));
  EXPECT_LT(repairs.left().count, kPlacesForAll) << "so that rounds end where nothing can be done";
}

TEST(Repairs, NeighboursComeFirstAndOnlyThoseThatMayMove) {
  const JoinedMesh before = testing::rectangles(32, 2, 32);
  MeshWithUndo mesh(before, {{0}});
  Repairs repairs(mesh, {kPlacesForAll});
  const std::uint32_t middle = 33 + 16;
  const std::vector<std::uint32_t> near = repairs.near(middle, 5);
  ASSERT_EQ(near.size(), 5U);
  EXPECT_EQ(near[0], middle);
  for (const std::uint32_t v : near) {
    EXPECT_TRUE(mesh.is_movable(v));
    EXPECT_LE(std::abs(mesh.at(v).x - mesh.at(middle).x), 2);
  }
}

}  // namespace
}  // namespace cover
