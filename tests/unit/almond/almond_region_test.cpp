#include "almond/almond_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/run_all.hpp"
#include "support/inputs/inputs.hpp"
#include "support/inputs/shapes.hpp"
#include "support/region_oracle.hpp"

namespace cover {
namespace {

using testing::boundary_of;
using testing::Loop;
using testing::reversed;

Options paper(int pieces = 6) {
  Options options;
  options.paper = true;
  options.pieces = pieces;
  return options;
}

/// Meshes in both modes and checks every promise.
void expect_covered(const RegionBoundary& boundary) {
  for (const Options& options : {Options{}, paper()}) {
    const RegionMesh mesh = almond_region(boundary, options, {});
    EXPECT_EQ(testing::judge_region(boundary, mesh), "") << (options.paper ? "paper" : "default");
    for (const Note& note : mesh.report.notes) {
      if (std::getenv("COVER_SHOW_NOTES") != nullptr) std::printf("%s\n", note.message.c_str());
    }
  }
}

TEST(AlmondRegion, TriangleStaysAsItIs) {
  const auto boundary = boundary_of({{{0, 0}, {1, 0}, {0.4, 0.7}}});
  const RegionMesh mesh = almond_region(boundary, paper(), {});
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.report.method, "cdt");
}

TEST(AlmondRegion, Square) { expect_covered(boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}})); }

TEST(AlmondRegion, RegularPolygons) {
  for (const int n : {4, 5, 6, 7, 8, 12, 30, 100, 1000}) {
    SCOPED_TRACE(n);
    expect_covered(boundary_of({testing::regular_polygon(n)}));
  }
}

// The triangles across a long arc are thin, each circle holds them all, and the chord stops every
// try until its almond is awake: minutes, if each try passes them all.
TEST(AlmondRegion, ALongArcOverItsChord) {
  constexpr int kSize = 20000;
  Loop arc;
  for (int k = 0; k <= kSize; ++k) {
    const double x = 2.0 * k / kSize - 1;
    arc.push_back({x, x * x});
  }
  const auto boundary = boundary_of({arc});
  const RegionMesh mesh = almond_region(boundary, {}, {});
  EXPECT_EQ(testing::judge_region(boundary, mesh), "");
  EXPECT_EQ(mesh.report.method, "almond");
}

// Large enough for several ranges of sides and triangles.
TEST(AlmondRegion, IsTheSameForAnyNumberOfThreads) {
  constexpr int kSize = 50'000;
  const auto boundary = boundary_of({testing::smooth_star(kSize, 3)});
  const RegionMesh alone = almond_region(boundary, {}, {});
  EXPECT_EQ(alone.report.method, "almond");
  EXPECT_GT(alone.steiner.size(), 1000U);
  for (const unsigned workers : {2U, 3U, 7U}) {
    SCOPED_TRACE(workers);
    RegionMesh shared;
    with_team(workers, [&](const Team& team) { shared = almond_region(boundary, {}, {}, team); });
    EXPECT_TRUE(shared.steiner == alone.steiner);
    EXPECT_TRUE(shared.triangles == alone.triangles);
    EXPECT_EQ(shared.report.notes.size(), alone.report.notes.size());
  }
}

TEST(AlmondRegion, RandomStars) {
  const std::uint64_t seed = testing::test_seed(1);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  const std::uint64_t count = testing::cases_asked_for("COVER_MANY", 40);
  for (std::uint64_t k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const int n = 4 + static_cast<int>(random() % 60);
    const double smallest = std::pow(10.0, -0.7 * static_cast<double>(random() % 6));
    expect_covered(boundary_of({testing::random_star(n, smallest, random)}));
    if (HasFailure() && count == 40) return;
  }
}

}  // namespace
}  // namespace cover
