// How many triangles wished sizes will take.
#pragma once

#include <span>

#include <cover/estimate.hpp>
#include <cover/options.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

#include "base/faults/machine_memory.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// As many triangles as the smallest size wished in a region would take everywhere; 0 without any.
/// Options::size_field and growth are not looked at.
double most_triangles(const RegionBoundary& boundary);

/// About how many triangles the sizes wished in a region take: the integral of 4 / (sqrt(3) h^2)
/// over the sizes h that refinement will aim at, once sides are cut that Options::split_interfaces
/// lets it cut. Of numbers that no mesh can hold, a part.
///
/// Cost: O(n log n); O(n) where there are surely less than a million
double expected_triangles(const RegionBoundary& boundary, const Options& options);

/// About how many triangles a region gets: by sizes wished, and at least what its sides take.
double about_triangles(const RegionBoundary& boundary, const Options& options);

/// About as many bytes as a run takes for so many triangles and sides of regions.
double memory_for(double triangles, std::size_t sides);

/// Errors: bad_option if the sizes wished take more triangles than a mesh can hold; out_of_memory
///         if what is held of these surely takes more memory than `memory` bytes
Status check_expected_triangles(const RegionTable& table,
                                std::span<const RegionBoundary> boundaries, const Options& options,
                                Held held = Held::all, double memory = machine_memory());

}  // namespace cover
