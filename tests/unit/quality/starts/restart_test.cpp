#include "quality/starts/restart.hpp"

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Restart, CoversTheSameDomainFromTheSamePlaces) {
  const RegionBoundary boundary = flower(60);
  const MutableMesh mesh = cdt_mesh(boundary);
  for (std::uint32_t number = 0; number < 20; ++number) {
    const std::optional<MutableMesh> anew = restart(mesh, 1 + number, number);
    ASSERT_TRUE(anew);
    expect_sound(*anew, boundary);
    EXPECT_EQ(anew->points.size(), boundary.points.size() + 1 + number);
    EXPECT_TRUE(anew->goal() == mesh.goal());
    EXPECT_EQ(anew->points, restart(mesh, 1 + number, number)->points);
    EXPECT_NE(anew->points, restart(mesh, 1 + number, number + 1)->points);
  }
}

}  // namespace
}  // namespace cover
