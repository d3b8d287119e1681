#include "quality/repair/thin_out.hpp"

#include "../mesh_checks.hpp"
#include "../refine_limits.hpp"
#include "quality/repair/improve.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(ThinOut, TakesVerticesAwayAndKeepsTheGoal) {
  const RegionBoundary boundary = flower(300);
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, limits_of(28));
  improve(mesh, 1U << 30);
  const double before = worst_excess(mesh);
  const std::size_t triangles = mesh.triangle_count();
  const ThinOutResult result = thin_out(mesh, 1U << 30);
  expect_sound(mesh, boundary);
  EXPECT_GT(result.removed, 10u);
  EXPECT_EQ(mesh.triangle_count() + 2 * result.removed, triangles);
  EXPECT_LE(worst_excess(mesh), std::max(0.0, before));
}

}  // namespace
}  // namespace cover
