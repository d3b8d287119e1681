// One region from its boundary to a mesh that is measured, mended and beside its limits.
#include "method/mesh_one_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/run_all.hpp"
#include "region/whole_mesh.hpp"
#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

using testing::boundary_of;

RegionMesh mesh_of(const RegionBoundary& boundary, const Options& options = {}) {
  return mesh_one_region(boundary, options, {});
}

void expect_covering(const RegionBoundary& boundary, const RegionMesh& mesh) {
  EXPECT_FALSE(find_flaw(boundary, mesh));
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_EQ(mesh.report.quality.triangles, mesh.triangles.size());
  EXPECT_EQ(mesh.report.steiner_vertices, mesh.steiner.size());
}

/// A wall ten times as long as the layer is thick, with vertices that no two walls have in common.
RegionBoundary uneven_layer() {
  return boundary_of({{{0, 0}, {4, 0}, {10, 0}, {10, 1}, {7, 1}, {0, 1}}});
}

TEST(MeshOneRegion, IsMeasuredAndItsTargetsAreMetWhereTheyCanBe) {
  const RegionBoundary boundary = boundary_of({testing::smooth_star(200, 1)});
  const RegionMesh mesh = mesh_of(boundary);
  expect_covering(boundary, mesh);
  EXPECT_LE(mesh.report.quality.largest_nu.supplement().in_degrees(), 100 + 1e-6);
  EXPECT_EQ(mesh.report.limits.of_largest, Standing::met);
  EXPECT_EQ(mesh.report.limits.of_smallest, Standing::met);
  EXPECT_GT(mesh.report.seconds, 0);
}

TEST(MeshOneRegion, WhatIsMissedStandsBesideItsLimits) {
  const RegionBoundary boundary = uneven_layer();
  const RegionMesh mesh = mesh_of(boundary);
  expect_covering(boundary, mesh);
  EXPECT_TRUE(std::any_of(mesh.report.notes.begin(), mesh.report.notes.end(),
                          [](const Note& note) { return note.kind == Note::Kind::target_missed; }));
  const RegionLimits& limits = mesh.report.limits;
  EXPECT_TRUE(limits.of_largest != Standing::unknown || limits.of_smallest != Standing::unknown);
  // No mesh is better than what is proven, and this is one.
  EXPECT_LE(mesh.report.quality.largest_nu.in_radians(), limits.largest_nu.in_radians() + 1e-9);
}

TEST(MeshOneRegion, TheAlmondMethodIsAskedForNoTarget) {
  Options options;
  options.method = Method::almond;
  const RegionBoundary boundary = uneven_layer();
  const RegionMesh mesh = mesh_of(boundary, options);
  expect_covering(boundary, mesh);
  EXPECT_EQ(mesh.report.limits.of_largest, Standing::unknown);
  EXPECT_EQ(mesh.report.limits.of_smallest, Standing::unknown);
}

TEST(MeshOneRegion, CouplingsAreMendedUnlessTheyComeLast) {
  std::size_t first = 0, last = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    std::mt19937_64 random(seed);
    const RegionBoundary boundary = boundary_of({testing::random_star(12, 0.3, random)});
    Options options;
    first += mesh_of(boundary, options).report.box.negative_inside;
    options.couplings = Couplings::last;
    last += mesh_of(boundary, options).report.box.negative_inside;
  }
  EXPECT_EQ(first, 0U);
  EXPECT_GT(last, 0U);
}

TEST(MeshOneRegion, IsTheSameForAnyTeam) {
  const RegionBoundary boundary = boundary_of({testing::smooth_star(3000, 2)});
  const RegionMesh alone = mesh_of(boundary);
  run_all(1, 3, [&](std::size_t, const Team& team) {
    const RegionMesh together = mesh_one_region(boundary, {}, {}, team);
    EXPECT_EQ(together.triangles, alone.triangles);
    EXPECT_EQ(together.steiner, alone.steiner);
  });
}

TEST(MeshOneRegion, WhereItIsToStopItIsDoneSoonAndProvesNothing) {
  std::stop_source source;
  source.request_stop();
  const RegionMesh mesh =
      mesh_one_region(boundary_of({testing::smooth_star(3000, 2)}), {}, source.get_token());
  EXPECT_EQ(mesh.report.limits.of_largest, Standing::unknown);
}

}  // namespace
}  // namespace cover
