// Size functions that meshes can follow: fine spots that lie between vertices are found.
#pragma once

#include <optional>
#include <string_view>

#include <cover/options.hpp>
#include <cover/point.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"

namespace cover {

struct GradedFunction {
  SizeFunction sizes;
  /// Where the grid should have been finer: it lets expect four times what is wished.
  std::optional<Point> missed;
};

/// `wish`, and around places in the region where it is smaller than what lies around it lets expect
/// no more than what grows from there by `slope` per unit of distance. The same function where it
/// varies so slowly that vertices cannot miss such a place.
///
/// `wish` is asked on a grid of triangles, RegionBoundary::size_grid wide, of the region without
/// what only cuts its sides (straight_runs.hpp); it is refined where values differ by more than
/// sizes may and are about as small as a triangle; up to 20,000 triangles for each region: `missed`
/// tells whether that was too few.
///
/// REQUIRES: slope > 0; size_grid > 0
/// Errors:   bad_option, with a place, where it falls below 1e-9 of the region's extent: it passes
///           through zero there, and edges would have no length. `name` is its text, `least`
///           what it has been raised to
/// Cost:     O(n log n) for a region of n points; the function that is made, O(log m) a call
Result<GradedFunction> graded_function(SizeFunction wish, std::string_view name,
                                       const RegionBoundary& boundary, double slope,
                                       std::optional<double> least = {});

}  // namespace cover
