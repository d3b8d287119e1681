// Shapes for tests: boundaries of single regions, from loops or at random.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <cover/point.hpp>

#include "region/region_boundary.hpp"

namespace cover::testing {

using Loop = std::vector<Point>;

/// The boundary of the region between loops: the first one counter-clockwise, holes clockwise.
/// Loops may share points. `isolated` points lie inside.
RegionBoundary boundary_of(const std::vector<Loop>& loops, const std::vector<Point>& isolated = {});

/// A regular n-gon, counter-clockwise.
Loop regular_polygon(int n, double radius = 1, Point centre = {0, 0});

/// A star-shaped polygon with n vertices whose radii are uniform in [smallest, 1].
Loop random_star(int n, double smallest, std::mt19937_64& random, Point centre = {0, 0},
                 double radius = 1);

/// A unit square with `per_side` vertices on each side, moved across it at random by up to `by`.
Loop wavy_square(int per_side, double by, std::mt19937_64& random);

/// The same loop the other way round.
Loop reversed(Loop loop);

/// Twice the signed area, for sums that are compared with a mesh.
double doubled_area(const Loop& loop);

/// Area of what a boundary encloses.
double area_of(const RegionBoundary& boundary);

/// The seed of a random test: COVER_TEST_SEED if set, else `fallback`. Printed when a test fails
/// by way of SCOPED_TRACE(seed_trace(seed)).
std::uint64_t test_seed(std::uint64_t fallback);
/// How many cases a random test tries: what the environment variable `variable` says, else
/// `usual`.
std::uint64_t cases_asked_for(const char* variable, std::uint64_t usual);
std::string seed_trace(std::uint64_t seed);

}  // namespace cover::testing
