#include "quality/optimum/placement.hpp"

#include "../grow_fully.hpp"
#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Placement, FindsTheMiddleOfARegularPolygon) {
  const RegionBoundary boundary = boundary_of({regular_polygon(7, 3, {1, 2})});
  const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(65), Angle::degrees(50)));
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  const Hole hole(mesh, cavity);
  const Placement p = place(hole, {2, 2.5}, kInverted);
  EXPECT_LE(p.worst, hole.worst({1, 2}, kInverted) + 2e-2);
  EXPECT_EQ(p.worst, hole.worst(p.at, kInverted));
  EXPECT_GT(p.evaluations, 1u);
  EXPECT_EQ(place(hole, {9, 9}, kInverted).worst, kInverted);
}

TEST(Placement, HasNoRoomAtAReflexCorner) {
  const Loop arrow{{0, 0}, {4, -3}, {1, 0.2}, {4, 3}};  // 3.5 rad at (1, 0.2)
  for (const bool is_convex : {false, true}) {
    Loop loop = arrow;
    if (is_convex) loop[2] = {6, 0};
    const RegionBoundary boundary = boundary_of({loop});
    const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(100), Angle::degrees(0)));
    Cavity cavity(mesh);
    cavity.start(0);
    grow_fully(cavity);
    ASSERT_EQ(cavity.size(), 4);
    EXPECT_EQ(has_room(mesh, cavity, 0), is_convex);
    EXPECT_TRUE(has_room(mesh, cavity, 100));
  }
}

TEST(Placement, WhereThereIsNoRoomNoPlaceIsGood) {
  const RegionBoundary boundary = boundary_of({regular_polygon(9, 3, {1, 2})});
  const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(140), Angle::degrees(20)));
  int refused = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Cavity cavity(mesh);
    cavity.start(t);
    for (const double limit : {0.0, 0.2, 0.5, 1.0}) {
      if (has_room(mesh, cavity, limit)) continue;
      ++refused;
      const Hole hole(mesh, cavity);
      const Point a = mesh.corner(t, 0);
      for (int i = 1; i < 40; ++i) {
        for (int j = 1; i + j < 40; ++j) {
          const Point p =
              a + (i / 40.0) * (mesh.corner(t, 1) - a) + (j / 40.0) * (mesh.corner(t, 2) - a);
          EXPECT_GT(hole.worst(p, kInverted), limit);
        }
      }
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace cover
