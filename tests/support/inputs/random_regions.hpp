// Regions of every awkward kind, at random.
#pragma once

#include <random>
#include <string>

#include "region/region_boundary.hpp"

namespace cover::testing {

/// A region and how it was made.
struct RandomRegion {
  std::string kind;
  RegionBoundary boundary;
};

/// A region of a kind chosen at random: stars, lattice shapes with cocircular and collinear points,
/// combs, slits, isolated points, holes, pinched vertices, polygonised arcs, gaps down to 1e-12.
RandomRegion random_region(std::mt19937_64& random);

/// The convex hull of random segments and points; hull edges that are no segment are kHullSide.
RandomRegion random_hull(std::mt19937_64& random);

/// `boundary` with every coordinate multiplied by `factor`, a power of two, and then shifted.
RegionBoundary transformed(RegionBoundary boundary, double factor, Point shift);

}  // namespace cover::testing
