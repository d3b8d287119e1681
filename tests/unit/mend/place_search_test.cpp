// Where one vertex is best put: added, moved inside, moved along its line.
#include "mend/place_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "unit/mend/joined_meshes.hpp"

namespace cover {
namespace {

constexpr std::uint64_t kPlacesToTry = 10'000;

std::uint32_t a_bad_triangle(const MeshWithUndo& mesh) {
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    if (mesh.triangles()[t].v[0] != kNone && mesh.triangles()[t].cost > 0) return t;
  }
  ADD_FAILURE() << "all are good";
  return 0;
}

TEST(PlaceSearch, ANewVertexIsBestAtTheFootOfAnObtuseCorner) {
  MeshWithUndo mesh(testing::flat_triangle(1), {{0}});
  PlacesLeft left{kPlacesToTry};
  VertexPlace best;
  PlaceSearch(mesh, left).add_one(0, {}, best);
  EXPECT_EQ(best.vertex, kNone);
  EXPECT_LT(best.cost, 1e-9);
  ASSERT_TRUE(best.spot.edge.has_value());
  EXPECT_EQ(best.spot.at, (Point{2, 0}));
  EXPECT_LT(left.count, kPlacesToTry);
  EXPECT_EQ(mesh.bad(), 1U) << "nothing is put there yet";
}

TEST(PlaceSearch, AVertexThatSeesASideFlatIsMovedToWhereItSeesNone) {
  const JoinedMesh hexagon = testing::hexagon_around({0, -1.5});
  MeshWithUndo mesh(hexagon, {{0}});
  const double cost = mesh.cost();
  ASSERT_GT(cost, 0);
  PlacesLeft left{kPlacesToTry};
  VertexPlace best;
  PlaceSearch(mesh, left).move_one(a_bad_triangle(mesh), {}, best);
  EXPECT_EQ(best.vertex, 6U);
  EXPECT_LT(best.cost, 1e-9);
  // Beyond the half discs over all sides.
  for (std::uint32_t k = 0; k < 6; ++k) {
    const Point a = hexagon.points[k], b = hexagon.points[(k + 1) % 6];
    EXPECT_GT(std::hypot(best.spot.at.x - (a.x + b.x) / 2, best.spot.at.y - (a.y + b.y) / 2), 1);
  }
  EXPECT_EQ(mesh.cost(), cost) << "it is where it was";
  EXPECT_EQ(mesh.at(6), (Point{0, -1.5}));
}

TEST(PlaceSearch, WhatStaysIsNotMoved) {
  MeshWithUndo mesh(testing::hexagon_around({0, -1.5}), {{0}});
  PlacesLeft left{kPlacesToTry};
  VertexPlace best;
  PlaceSearch(mesh, left).move_one(a_bad_triangle(mesh), std::vector<std::uint32_t>{6}, best);
  EXPECT_TRUE(std::isinf(best.cost));
  EXPECT_EQ(left.count, kPlacesToTry);
}

TEST(PlaceSearch, AVertexOnALineStaysOnIt) {
  // Cut beside the foot of the upper corner: it is moved along the side, and not away from it.
  JoinedMesh cut = testing::flat_triangle(1);
  cut.points.push_back({3, 0});
  cut.line.push_back(0);
  cut.pieces[0] = {0, 3, 0};
  cut.pieces.push_back({3, 1, 0});
  cut.triangles = {{0, 3, 2}, {3, 1, 2}};
  cut.region = {0, 0};
  MeshWithUndo mesh(cut, {{0}});
  PlacesLeft left{kPlacesToTry};
  VertexPlace best;
  PlaceSearch(mesh, left).move_one(a_bad_triangle(mesh), {}, best);
  EXPECT_EQ(best.vertex, 3U);
  EXPECT_LT(best.cost, 1e-9);
  EXPECT_EQ(best.spot.at, (Point{2, 0}));
}

TEST(PlacesLeft, AreOverAtNoneAndNeverBelow) {
  PlacesLeft left{3};
  EXPECT_FALSE(left.is_over());
  left.spend(2);
  EXPECT_EQ(left.count, 1U);
  left.spend(2);
  EXPECT_EQ(left.count, 0U);
  EXPECT_TRUE(left.is_over());
}

}  // namespace
}  // namespace cover
