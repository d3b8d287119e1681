#include "quality/starts/even_refinement.hpp"

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

void expect_angles_from_30_to_120(const MutableMesh& mesh) {
  const double cot30 = std::sqrt(3.0) * (1 + 1e-12), cot120 = -1 / std::sqrt(3.0) - 1e-12;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    for (const double d : k.dot) {
      EXPECT_LE(d, cot30 * k.cross);
      EXPECT_GE(d, cot120 * k.cross);
    }
  }
}

TEST(RefineEvenly, KeepsChewsPromiseWhereTheBoundaryIsEvenlySpaced) {
  const std::uint64_t seed = test_seed(11);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  const Goal none_forced = Goal::of(Angle::degrees(120), Angle::degrees(20));
  int refined = 0;
  for (int k = 0; k < 100; ++k) {
    const RegionBoundary boundary = boundary_of({wavy_square(4 + k % 8, 0.08, random)});
    MutableMesh mesh = cdt_mesh(boundary, none_forced);
    const std::size_t before = mesh.triangle_count();
    if (!refine_evenly(mesh)) {
      EXPECT_EQ(mesh.triangle_count(), before);
      continue;
    }
    ++refined;
    expect_sound(mesh, boundary);
    expect_angles_from_30_to_120(mesh);
  }
  EXPECT_GT(refined, 40);
}

TEST(RefineEvenly, KeepsChewsPromiseAroundAHole) {
  const RegionBoundary boundary =
      boundary_of({regular_polygon(40, 5), reversed(regular_polygon(12, 1.5))});
  MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(120), Angle::degrees(20)));
  ASSERT_TRUE(refine_evenly(mesh));
  expect_sound(mesh, boundary);
  expect_angles_from_30_to_120(mesh);
}

TEST(RefineEvenly, LeavesAloneWhatIsNotEvenlySpaced) {
  const RegionBoundary boundary = boundary_of({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}});
  MutableMesh mesh = cdt_mesh(boundary);
  EXPECT_FALSE(refine_evenly(mesh));
  EXPECT_EQ(mesh.triangle_count(), 3u);
}

TEST(RefineEvenly, LeavesAloneWhatWouldTakeManyVertices) {
  const RegionBoundary boundary = boundary_of({regular_polygon(200)});
  MutableMesh mesh = cdt_mesh(boundary);
  EXPECT_FALSE(refine_evenly(mesh));
  EXPECT_EQ(mesh.triangle_count(), 198u);
}

}  // namespace
}  // namespace cover
