#include "quality/repair/kicks.hpp"

#include "../mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(Kicks, NeverMakeItWorse) {
  const std::uint64_t seed = test_seed(23);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  int better = 0;
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(7, 0.5, random)});
    MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(95), Angle::degrees(0)));
    const Merit before = merit_of(mesh, mesh.goal());
    Budget budget{100'000'000, {}, false};
    const Merit merit = improve_by_kicks(mesh, mesh.goal(), before, budget);
    expect_sound(mesh, boundary);
    EXPECT_FALSE(is_better_by_largest(before, merit));
    better += is_better_by_largest(merit, before) ? 1 : 0;
  }
  EXPECT_GT(better, 5);
}

}  // namespace
}  // namespace cover
