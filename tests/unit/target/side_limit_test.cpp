#include "target/side_limit.hpp"

#include "unit/quality/mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

/// The limits by side of the boundary.
std::vector<SideLimit> limits_of(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  return side_limits(cdt, locate_sides(cdt, boundary.sides));
}

TEST(SideLimit, ASlitAllowsOnlySlimTriangles) {
  const RegionBoundary slit = boundary_of({{{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}}});
  const std::vector<SideLimit> limits = limits_of(slit);
  for (std::size_t s = 0; s < limits.size(); ++s) {
    const auto& [a, b] = slit.sides[s];
    const bool is_long = slit.points[a].y == slit.points[b].y;
    // Angles x with tan(x) = 0.01 / 0.5 along the slit; free to the middle across it.
    EXPECT_NEAR(limits[s].slim_cot, is_long ? 50 : 1, 1e-9);
  }
}

TEST(SideLimit, ASharpCornerIsTheLimitOfItsSides) {
  const double cot = 1 / std::tan(0.1);
  const RegionBoundary needle = boundary_of({{{0, 0}, {1, -0.1}, {1, 0}}});
  for (const SideLimit& limit : limits_of(needle)) {
    EXPECT_LE(limit.slim_cot, std::max(cot, 10.0) + 1e-9);
    EXPECT_GE(limit.slim_cot, 1);
  }
}

TEST(SideLimit, NoTriangleOfAnyMeshIsBetter) {
  const RegionBoundary star = flower(60);
  MutableMesh mesh = cdt_mesh(star);
  for (const MeshTriangle& t : mesh.triangles) {
    const Corners k(mesh.points[t.v[0]], mesh.points[t.v[1]], mesh.points[t.v[2]]);
    const double smallest = std::max({k.dot[0], k.dot[1], k.dot[2]}) / k.cross;
    for (const std::uint32_t n : t.n) {
      if (!is_side(n)) continue;
      EXPECT_GE(smallest, mesh.sides[side_index(n)].slim_cot * (1 - 1e-12));
    }
  }
}

TEST(SideLimit, ACornerThatMustBeHalvedIsTheLimitOfItsSides) {
  // A corner of 30 degrees between sides of length 1 and 3: the triangle across has 143 degrees.
  const double pi = 3.14159265358979323846, x = pi / 6;
  const RegionBoundary boundary =
      boundary_of({{{0, 0}, {3, 0}, {3, 3}, {std::cos(x), std::sin(x)}}});
  const std::vector<SideLimit> limits = limits_of(boundary);
  const Goal goal = default_goal();
  int at_corner = 0;
  for (std::size_t s = 0; s < limits.size(); ++s) {
    const auto& [a, b] = boundary.sides[s];
    const bool is_there = boundary.points[a].x == 0 || boundary.points[b].x == 0;
    at_corner += is_there ? 1 : 0;
    const double smallest = goal.small + allowance_for(limits[s], goal).small;
    if (is_there) {
      EXPECT_GE(smallest, 1 / std::tan(x / 2) - 1e-9);
      const auto& [start, end] = limits[s].corners;
      const CornerLimit& corner = boundary.points[a].x == 0 ? start : end;
      EXPECT_NEAR(corner.half_cot, 1 / std::tan(x / 2), 1e-9);
      const double across = std::atan2(std::sin(x), 3 - std::cos(x));
      EXPECT_NEAR(corner.ear_large, 1 / std::tan(x + across), 1e-9);
      EXPECT_NEAR(corner.ear_cot, 1 / std::tan(across), 1e-9);
    }
    // With 150 degrees allowed, the corner may be cut off.
    const Goal lax = Goal::of(Angle::degrees(150), Angle::degrees(5));
    EXPECT_NEAR(allowance_for(limits[s], lax).small, 0, 1e-9);
  }
  EXPECT_EQ(at_corner, 2);
}

}  // namespace
}  // namespace cover
