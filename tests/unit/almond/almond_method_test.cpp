// Regions of every awkward kind at random. COVER_FUZZ=n runs n of them instead of a few hundred.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "almond/almond_method.hpp"
#include "almond/almond_region.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"
#include "support/region_oracle.hpp"
#include "target/local_frame.hpp"

namespace cover {
namespace {

std::uint64_t fuzz_count(std::uint64_t fallback) {
  return testing::cases_asked_for("COVER_FUZZ", fallback);
}

/// Stops at the first failure unless many cases were asked for.
bool stop_early() { return std::getenv("COVER_FUZZ") == nullptr; }

void expect_promises_kept(const RegionBoundary& boundary, const Options& options) {
  const RegionMesh mesh = almond_region(boundary, options, {});
  EXPECT_EQ(testing::judge_region(boundary, mesh), "");
  if (std::getenv("COVER_SHOW_NOTES") != nullptr) {
    for (const Note& note : mesh.report.notes) std::printf("  %s\n", note.message.c_str());
  }
}

void run(std::uint64_t count, std::uint64_t seed, const Options& options,
         testing::RandomRegion (*make)(std::mt19937_64&)) {
  for (std::uint64_t k = 0; k < count; ++k) {
    std::mt19937_64 random(seed + k);
    const testing::RandomRegion region = make(random);
    SCOPED_TRACE(testing::seed_trace(seed + k) + " " + region.kind);
    expect_promises_kept(region.boundary, options);
    if (::testing::Test::HasFailure() && stop_early()) return;
  }
}

TEST(AlmondMethodOnRandomRegions, KeepsPromises) {
  run(fuzz_count(300), testing::test_seed(1), {}, testing::random_region);
}

TEST(AlmondMethodOnRandomRegions, KeepsPromisesAsInThePaper) {
  Options options;
  options.paper = true;
  run(fuzz_count(300), testing::test_seed(1), options, testing::random_region);
}

/// The almond method with an almond on every side and the improved cuts, which the default uses
/// only where it has to.
RegionMesh mesh_with_all_almonds(const RegionBoundary& boundary) {
  const Triangulation cdt = triangulate_domain(boundary.points, boundary.sides).triangulation;
  const AngleLimit limit = angle_limit(cdt, boundary.sides, boundary.segments);
  const FillPlan plan;
  AlmondMesh almonds = mesh_by_almonds(
      {cdt, boundary.sides, boundary.segments, limit, {}, false},
      {false, 6, limit.promised_nu(), LocalFrame(boundary.points).rounding()}, plan, {});
  RegionMesh mesh;
  mesh.steiner.assign(almonds.points.begin() + static_cast<std::ptrdiff_t>(boundary.points.size()),
                      almonds.points.end());
  mesh.triangles = std::move(almonds.triangles);
  mesh.report.nu_bound = Angle::radians(limit.promised_nu());
  return mesh;
}

TEST(AlmondMethodOnRandomRegions, KeepsPromisesWithAnAlmondOnEverySide) {
  const std::uint64_t seed = testing::test_seed(1);
  for (std::uint64_t k = 0; k < fuzz_count(300); ++k) {
    std::mt19937_64 random(seed + k);
    const testing::RandomRegion region = testing::random_region(random);
    SCOPED_TRACE(testing::seed_trace(seed + k) + " " + region.kind);
    EXPECT_EQ(testing::judge_region(region.boundary, mesh_with_all_almonds(region.boundary)), "");
    if (HasFailure() && stop_early()) return;
  }
}

/// Promise 5, too: scaled by a power of two, everything is the same; shifted exactly, too.
TEST(AlmondMethodOnRandomRegions, UnitAndOriginDoNotMatter) {
  const std::uint64_t seed = testing::test_seed(1);
  for (std::uint64_t k = 0; k < fuzz_count(100); ++k) {
    std::mt19937_64 random(seed + k);
    testing::RandomRegion region = testing::random_region(random);
    SCOPED_TRACE(testing::seed_trace(seed + k) + " " + region.kind);
    Options options;
    options.paper = k % 2 == 0;
    const RegionMesh mesh = almond_region(region.boundary, options, {});
    for (const double factor : {0x1p+30, 0x1p-30}) {
      const auto scaled = testing::transformed(region.boundary, factor, {});
      const RegionMesh other = almond_region(scaled, options, {});
      EXPECT_EQ(testing::judge_region(scaled, other), "");
      EXPECT_EQ(mesh.triangles, other.triangles);
    }
    // On a grid of 2^-20 a shift by 2^20 is exact.
    for (Point& p : region.boundary.points) {
      p = {std::round(std::ldexp(p.x, 20)), std::round(std::ldexp(p.y, 20))};
    }
    if (std::adjacent_find(region.boundary.points.begin(), region.boundary.points.end()) !=
        region.boundary.points.end()) {
      continue;
    }
    if (region.kind != "cells" && region.kind != "regular") continue;  // rounding may cross others
    const RegionMesh gridded = almond_region(region.boundary, options, {});
    const auto shifted = testing::transformed(region.boundary, 1, {0x1p+40, -0x1p+40});
    const RegionMesh other = almond_region(shifted, options, {});
    EXPECT_EQ(testing::judge_region(shifted, other), "");
    EXPECT_EQ(gridded.triangles, other.triangles);
    if (HasFailure() && stop_early()) return;
  }
}

TEST(AlmondMethodOnRandomRegions, KeepsPromisesWhereTheHullMayBeSplit) {
  for (const bool paper : {false, true}) {
    Options options;
    options.hull = true;
    options.paper = paper;
    run(fuzz_count(300), testing::test_seed(1), options, testing::random_hull);
  }
}

}  // namespace
}  // namespace cover
