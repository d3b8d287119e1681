#include "quality/mutable/mutable_mesh.hpp"

#include "../mesh_checks.hpp"
#include "base/containers/shared.hpp"
#include "base/run_all.hpp"
#include "quality/mutable/to_region_mesh.hpp"
#include "quality/repair/improve.hpp"
#include "quality/starts/delaunay_refinement.hpp"

namespace cover {
namespace {

using namespace testing;

RegionBoundary square() { return boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1.1}}}); }

TEST(Allowances, KeepEachThatIsDifferentOnce) {
  Allowances allowances(2);
  EXPECT_EQ(allowances[1], Allowance());
  for (int k = 0; k < 40; ++k) {
    Allowance allowance;
    allowance.large = k % 20;
    allowances.push_back(allowance);
    allowances.push_back(allowances[1]);
  }
  ASSERT_EQ(allowances.size(), 82U);
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_EQ(allowances[2 + 2 * k].large, static_cast<double>(k % 20));
    EXPECT_EQ(allowances[3 + 2 * k], Allowance());
  }
}

TEST(Shared, CopiesAreTheSameUntilOneIsChanged) {
  Shared<std::vector<int>> first(std::vector<int>{1, 2});
  const Shared<std::vector<int>> second = first;
  EXPECT_EQ(&*first, &*second);
  first.change().push_back(3);
  EXPECT_EQ(first->size(), 3U);
  EXPECT_EQ(second->size(), 2U);
  const int* const place = first->data();
  first.change()[0] = 7;
  EXPECT_EQ(first->data(), place) << "nobody else has it";
}

TEST(MutableMesh, TakesOverATriangulation) {
  const RegionBoundary boundary = flower(60);
  const MutableMesh mesh = cdt_mesh(boundary);
  EXPECT_EQ(mesh.triangle_count(), 58u);
  EXPECT_EQ(mesh.fixed_vertices(), 60u);
  expect_sound(mesh, boundary);
}

TEST(MutableMesh, CutsSlitsOpen) {
  RegionBoundary boundary = boundary_of({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {{0.5, 1}, {1.5, 1}});
  const auto index = [&](Point p) {
    return static_cast<std::uint32_t>(std::find(boundary.points.begin(), boundary.points.end(), p) -
                                      boundary.points.begin());
  };
  const std::uint32_t a = index({0.5, 1}), b = index({1.5, 1});
  boundary.sides.push_back({a, b});
  boundary.sides.push_back({b, a});
  std::sort(boundary.sides.begin(), boundary.sides.end());
  boundary.segments.resize(boundary.sides.size());
  expect_sound(cdt_mesh(boundary), boundary);
}

TEST(MutableMesh, FlipsAndFlipsBack) {
  const RegionBoundary boundary = square();
  MutableMesh mesh = cdt_mesh(boundary);
  const auto inner_edge = [&] {
    for (int i = 0; i < 3; ++i) {
      if (!is_side(mesh.triangles[0].n[static_cast<std::size_t>(i)])) return i;
    }
    return -1;
  };
  const double before = worst_excess(mesh);
  const double predicted = mesh.excess_after_flip(0, inner_edge(), kInverted);
  ASSERT_TRUE(mesh.flip(0, inner_edge()));
  EXPECT_DOUBLE_EQ(worst_excess(mesh), predicted);
  expect_sound(mesh, boundary);
  ASSERT_TRUE(mesh.flip(0, inner_edge()));
  EXPECT_DOUBLE_EQ(worst_excess(mesh), before);
  expect_sound(mesh, boundary);
}

TEST(MutableMesh, RefusesToFlipTheDiagonalOfAReflexQuadrilateral) {
  const RegionBoundary boundary = boundary_of({{{0, 0}, {4, 0}, {1, 1}, {0, 4}}});
  MutableMesh mesh = cdt_mesh(boundary);
  for (int i = 0; i < 3; ++i) {
    if (is_side(mesh.triangles[0].n[static_cast<std::size_t>(i)])) continue;
    EXPECT_EQ(mesh.excess_after_flip(0, i, kInverted), kInverted);
    EXPECT_FALSE(mesh.flip(0, i));
  }
  expect_sound(mesh, boundary);
}

TEST(MutableMesh, IsTheSameMeshAfterArrangement) {
  const RegionBoundary boundary = flower(60);
  MutableMesh mesh = cdt_mesh(boundary);
  RefineLimits limits{.smallest_cot = 2, .budget = 1000};
  refine(mesh, limits);
  improve(mesh, 100000);
  const auto corners = [&] {
    std::vector<std::array<Point, 3>> all;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.is_hole(t)) continue;
      all.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
      std::rotate(all.back().begin(), std::min_element(all.back().begin(), all.back().end()),
                  all.back().end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto before = corners();
  const double worst = worst_excess(mesh);
  mesh.drop_vertex(mesh.add_vertex({0, 0}));
  mesh.drop_triangle(mesh.add_triangle());
  mesh.arrange();
  EXPECT_EQ(corners(), before);
  EXPECT_EQ(worst_excess(mesh), worst);
  EXPECT_EQ(mesh.triangles.size(), mesh.triangle_count());
  EXPECT_EQ(std::count(mesh.home.begin(), mesh.home.end(), kNone), 0);
  expect_sound(mesh, boundary);
}

/// Some ranges of triangles, with places that are free.
TEST(MutableMesh, IsArrangedTheSameByAnyNumberOfThreads) {
  const RegionBoundary boundary = flower(20'000);
  MutableMesh mesh = cdt_mesh(boundary);
  refine(mesh, RefineLimits{.smallest_cot = 2, .budget = 100'000});
  for (int k = 0; k < 3; ++k) {
    mesh.drop_vertex(mesh.add_vertex({0, 0}));
    mesh.drop_triangle(mesh.add_triangle());
  }
  const LocalFrame frame(boundary.points);
  const RegionMesh before = to_region_mesh(mesh, frame, boundary.points);
  const auto changed = [&](const Team& team) {
    MutableMesh copy = mesh;
    copy.arrange(team);
    copy.set_goal(Goal::of(Angle::degrees(95), Angle::degrees(25)), team);
    return copy;
  };
  const MutableMesh alone = changed(Team());
  for (const unsigned workers : {2U, 3U, 7U, 64U}) {
    with_team(workers, [&](const Team& team) {
      const RegionMesh made = to_region_mesh(mesh, frame, boundary.points, team);
      EXPECT_FALSE(made.triangles.empty());
      EXPECT_EQ(made.triangles, before.triangles);
      EXPECT_EQ(made.steiner, before.steiner);
      const MutableMesh other = changed(team);
      ASSERT_EQ(other.triangles.size(), alone.triangles.size());
      for (std::size_t t = 0; t < alone.triangles.size(); ++t) {
        ASSERT_EQ(other.triangles[t].v, alone.triangles[t].v);
        ASSERT_EQ(other.triangles[t].n, alone.triangles[t].n);
        ASSERT_EQ(other.excess[t], alone.excess[t]);
      }
      EXPECT_EQ(other.points, alone.points);
      EXPECT_EQ(other.home, alone.home);
      for (std::size_t s = 0; s < alone.sides.size(); ++s)
        ASSERT_EQ(other.allowances[s], alone.allowances[s]);
    });
  }
}

TEST(MutableMesh, TellsWhetherSidesForceAnything) {
  MutableMesh round = cdt_mesh(flower(60));
  round.set_goal(default_goal());
  EXPECT_TRUE(round.is_unforced());
  MutableMesh thin = cdt_mesh(boundary_of({{{0, 0}, {1, 0}, {1, 0.02}, {0, 0.02}}}));
  thin.set_goal(default_goal());
  EXPECT_FALSE(thin.is_unforced());
}

TEST(MutableMesh, ForcedTrianglesMeetTheGoal) {
  // The long side sees the tip of the notch at an angle that no mesh can avoid.
  const RegionBoundary boundary = boundary_of({{{0, 0}, {10, 0}, {10, 5}, {5, 0.5}, {0, 5}}});
  MutableMesh mesh = cdt_mesh(boundary, Goal::of(Angle::degrees(100), Angle::degrees(0)));
  std::size_t forced = 0;
  for (std::uint32_t s = 0; s < mesh.sides.size(); ++s) forced += mesh.allowances[s].large > 0;
  EXPECT_GE(forced, 1u);
  EXPECT_LE(worst_excess(mesh), 0);
  mesh.set_goal(Goal::of(Angle::degrees(175), Angle::degrees(0)));
  for (std::uint32_t s = 0; s < mesh.sides.size(); ++s) EXPECT_EQ(mesh.allowances[s].large, 0);
}

TEST(MutableMesh, ManyPlacesAreThoseThatOneAfterTheOtherWouldBe) {
  MutableMesh one, many;
  for (MutableMesh* mesh : {&one, &many}) {
    for (int k = 0; k < 5; ++k) mesh->add_triangle(), mesh->add_vertex({});
    for (const std::uint32_t place : {1U, 3U, 0U})
      mesh->drop_triangle(place), mesh->drop_vertex(place);
  }
  std::vector<std::uint32_t> triangles(5), vertices(5);
  many.reserve_more(5, 5);
  many.add_triangles(triangles);
  many.add_vertices(vertices);
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(triangles[static_cast<std::size_t>(k)], one.add_triangle());
    EXPECT_EQ(vertices[static_cast<std::size_t>(k)], one.add_vertex({}));
  }
  EXPECT_EQ(many.triangles.size(), one.triangles.size());
  EXPECT_EQ(many.excess.size(), one.excess.size());
  EXPECT_EQ(many.home.size(), one.home.size());
  EXPECT_EQ(many.triangle_count(), one.triangle_count());
}

}  // namespace
}  // namespace cover
