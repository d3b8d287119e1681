#include "quality/optimum/min_max_polygon_with_vertex.hpp"

#include "../grow_fully.hpp"
#include "../mesh_checks.hpp"
#include "quality/optimum/placement.hpp"

namespace cover {
namespace {

using namespace testing;

/// The polygon that a search with one vertex in the middle does not get right.
Loop skewed_pentagon() {
  return {{0.13020758953298486, 0.5980504977765327},
          {0.13213424753855418, 0.5972036750876587},
          {0.13368151616536372, 0.597225398981256},
          {0.13248801903979057, 0.6008923999539126},
          {0.13084046384018813, 0.6008433984946989}};
}

TEST(MinMaxPolygonWithVertex, FindsAPlaceFarFromTheMiddle) {
  const RegionBoundary boundary = boundary_of({skewed_pentagon()});
  const Goal goal = Goal::of(Angle::degrees(95), Angle::degrees(0));
  MutableMesh mesh = cdt_mesh(boundary, goal);
  Cavity cavity(mesh);
  cavity.start(0);
  grow_fully(cavity);
  ASSERT_EQ(cavity.size(), 5);
  const Hole hole(mesh, cavity);
  EXPECT_GT(place(hole, hole.centre(), kInverted).worst, 0);
  Patch patch;
  const double worst = min_max_polygon_with_vertex(mesh, cavity, kInverted, patch).worst;
  EXPECT_LE(worst, 0);
  Installed installed;
  ASSERT_TRUE(install_patch(mesh, cavity, patch, installed));
  EXPECT_DOUBLE_EQ(worst_excess(mesh), worst);
  EXPECT_EQ(mesh.points.size(), 6u);
  expect_sound(mesh, boundary);
}

TEST(MinMaxPolygonWithVertex, CutsCornersOffWhereThatIsBetter) {
  const std::uint64_t seed = test_seed(41);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  int cut = 0;
  for (int k = 0; k < 20; ++k) {
    const RegionBoundary boundary = boundary_of({random_star(7, 0.5, random)});
    MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(100), Angle::degrees(0)));
    Cavity cavity(mesh);
    cavity.start(0);
    grow_fully(cavity);
    if (cavity.size() != 7) continue;
    Patch patch;
    const double before = worst_excess(mesh);
    const double worst = min_max_polygon_with_vertex(mesh, cavity, before, patch).worst;
    if (worst == kInverted) continue;
    EXPECT_LT(worst, before);
    Installed installed;
    ASSERT_TRUE(install_patch(mesh, cavity, patch, installed));
    EXPECT_EQ(installed.count, 7);
    EXPECT_DOUBLE_EQ(worst_excess(mesh), worst);
    expect_sound(mesh, boundary);
    for (int t = 0; t < patch.count(); ++t) {
      const Patch::Corner& c = patch.corners(t);
      cut += c[0] < 7 && c[1] < 7 && c[2] < 7 ? 1 : 0;
    }
  }
  EXPECT_GT(cut, 0);
}

}  // namespace
}  // namespace cover
