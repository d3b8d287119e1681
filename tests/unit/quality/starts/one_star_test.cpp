#include "quality/starts/one_star.hpp"

#include "../mesh_checks.hpp"
#include "quality/fault/merit.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(OneStar, JoinsEverySideToOneVertex) {
  const RegionBoundary boundary = boundary_of({regular_polygon(100, 2, {5, 5})});
  const MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(90), Angle::degrees(0)));
  const auto star = one_star(mesh, boundary).star;
  ASSERT_TRUE(star.has_value());
  EXPECT_EQ(star->triangles.size(), 100u);
  const auto at = locate_sides(*star, boundary.sides);
  MutableMesh hub(*star, 100, at, mesh.sides);
  hub.set_goal(mesh.goal());
  expect_sound(hub, boundary);
  EXPECT_TRUE(merit_of(hub, mesh.goal()).complete);
}

TEST(OneStar, IsNoneWithAHoleOrABay) {
  const RegionBoundary ring =
      boundary_of({regular_polygon(12, 2), reversed(regular_polygon(8, 1))});
  EXPECT_FALSE(one_star(cdt_mesh(ring), ring).star.has_value());
  const RegionBoundary bay =
      boundary_of({{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}});
  EXPECT_FALSE(one_star(cdt_mesh(bay), bay).star.has_value());
}

}  // namespace
}  // namespace cover
