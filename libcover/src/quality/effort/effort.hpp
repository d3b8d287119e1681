// What the plan of a region may cost: budgets and shares, in one place.
//
// One star evaluation takes some 0.1 us. Figures are from tests/bench/region_faults.py on Voronoi
// cells, parcels and maps, where nothing else is said.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cover::effort {

/// Targets for the smallest angle, in parts of the goal's, with which angles above 120 degrees or
/// the bound are narrowed, in turn. Coarser steps leave the smallest angles smaller than need be.
inline constexpr std::array<double, 10> kSmallestParts{0.75, 0.6,  0.45, 0.36, 0.285,
                                                       0.22, 0.16, 0.11, 0.06, 0.018};
inline constexpr double kAimBelowLimit = 0.008;             ///< aimed at below these, in cotangents
inline constexpr std::uint64_t kNarrowedPerTriangle = 100;  ///< star evaluations for that, at most
inline constexpr std::uint64_t kImprovePerTriangle = 100;   ///< star evaluations after refinement

/// Where at most this share of the triangles misses the goal, they are searched for one by one: on
/// clean input that ends at the goal, on maps nearly everything that is left is forced.
inline constexpr double kFewMissed = 0.02;
inline constexpr std::size_t kFewAtLeast = 3;
inline constexpr std::uint64_t kSearchPerTriangle = 20;  ///< of the mesh, in star evaluations
inline constexpr std::uint64_t kSearchPerMissed =
    5'000;  ///< or for each that misses, if that is more
inline constexpr std::uint64_t kLastPerTriangle =
    100;  ///< for the last improvement of such regions

}  // namespace cover::effort
