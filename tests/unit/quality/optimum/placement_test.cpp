#include "quality/optimum/placement.hpp"

#include <random>

#include "../coupled_meshes.hpp"
#include "../grow_fully.hpp"
#include "../mesh_checks.hpp"
#include "quality/mutable/cavity.hpp"

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

TEST(Placement, IsJudgedByTheCouplingsAllAround) {
  std::mt19937_64 random(4);
  const RegionBoundary boundary = boundary_of({random_star(30, 0.6, random)});
  for (const Goal& goal : {soft_goal(), strict_goal()}) {
    MutableMesh mesh = refined_minding_mesh(boundary, goal, 200);
    mesh.measure_all();
    Cavity cavity(mesh);
    std::size_t stars = 0;
    for (std::uint32_t v = mesh.fixed_vertices(); v < mesh.points.size(); ++v) {
      if (!cavity.start_star(v)) continue;
      const Hole hole(mesh, cavity);
      const Point from = mesh.points[v];
      for (const double by : {0.0, 0.1, 0.4}) {
        const Point p = from + by * (mesh.points[cavity.vertex(0)] - from);
        const double expected = hole.worst(p, kInverted);
        LinearPieces pieces;
        const double linear = hole.linearise(p, kInverted, 0, -kInverted, pieces);
        mesh.points[v] = p;
        double worst = -kInverted;
        for (int k = 0; k < cavity.triangle_count(); ++k) {
          const MeshTriangle& t = mesh.triangles[cavity.triangle(k)];
          worst = std::max(worst, mesh.excess_of(t.v, t.n));
        }
        mesh.points[v] = from;
        if (worst == kInverted) {
          EXPECT_EQ(expected, kInverted);
          EXPECT_EQ(linear, kInverted);
          continue;
        }
        // Couplings that are as they should be count in one of them only.
        worst = std::max(worst, 0.0);
        EXPECT_NEAR(std::max(expected, 0.0), worst, 1e-6 * std::max(1.0, worst));
        EXPECT_NEAR(std::max(linear, 0.0), worst, 1e-6 * std::max(1.0, worst));
        ++stars;
      }
    }
    EXPECT_GT(stars, 10u);
  }
}

}  // namespace
}  // namespace cover
