#include "mend/ease_mesh.hpp"

#include <gtest/gtest.h>

#include "geom/angle_rounding.hpp"

namespace cover {
namespace {

std::size_t obtuse(const JoinedMesh& mesh) {
  std::size_t count = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    count += bluntness_of(mesh.points[a], mesh.points[b], mesh.points[c]) == Blunt::yes ? 1 : 0;
  return count;
}

/// Two squares with the corner between them, on the lower line, moved to the right by `off`: its
/// edge up is at no right angle to the line then. The upper corner is inside.
JoinedMesh two_squares(double off) {
  JoinedMesh mesh;
  mesh.points = {{0, 0}, {1 + off, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
  mesh.line = {JoinedMesh::kFixed, 0, JoinedMesh::kFixed, JoinedMesh::kFixed, JoinedMesh::kInside,
               JoinedMesh::kFixed};
  mesh.lines = {{{0, 0}, {2, 0}}};
  mesh.pieces = {{0, 1, 0}, {1, 2, 0}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  mesh.region.assign(4, 0);
  return mesh;
}

TEST(EaseMesh, WhatIsObtuseByLittleIsMadeRight) {
  JoinedMesh mesh = two_squares(-1e-4);
  ASSERT_GT(obtuse(mesh), 0u);
  const std::vector<Point> before = mesh.points;
  ASSERT_TRUE(ease({}, mesh));
  EXPECT_EQ(obtuse(mesh), 0u);
  EXPECT_EQ(mesh.points[1].y, 0);  // stays on its line
  for (const std::size_t fixed : {0, 2, 3, 5}) EXPECT_EQ(mesh.points[fixed], before[fixed]);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_LT(length(mesh.points[v] - before[v]), 1e-3);
}

TEST(EaseMesh, WhatIsFarFromRightStays) {
  JoinedMesh mesh = two_squares(-0.3);
  const std::vector<Point> before = mesh.points;
  ASSERT_GT(obtuse(mesh), 0u);
  ease({}, mesh);
  EXPECT_EQ(mesh.points, before);
}

TEST(EaseMesh, StraightAcrossIsAtARightAngle) {
  const Point p{1, 1}, a{0, 2}, b{4, 2.5};
  const Vector along{1, 0.25};
  const Point q = straight_across(p, along, a, b);
  EXPECT_NEAR(dot(q - p, along), 0, 1e-15);
  EXPECT_NEAR(cross(q - a, b - a), 0, 1e-14);
}

}  // namespace
}  // namespace cover
