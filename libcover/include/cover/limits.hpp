// How what was reached stands to what is possible.
#pragma once

#include <array>
#include <cstddef>

#include <cover/angle.hpp>

namespace cover {

/// An angle of a region beside its target and its proven limit.
enum class Standing {
  unknown,  ///< nobody looked for a limit
  met,      ///< the target is met
  optimal,  ///< no mesh is better by more than 1e-5 degrees
  near,     ///< no mesh is better by more than a degree
  open,     ///< nobody knows
  coupled,  ///< optimal or near among the meshes that have no other negative couplings
};
inline constexpr std::size_t kStandings = 6;

/// Proven limits of a region and what was reached (libcover/docs/limits.md). With
/// Standing::coupled, of the meshes alone that have no other negative couplings than the one made.
struct RegionLimits {
  Angle largest_nu = Angle::degrees(180);  ///< no covering mesh has a larger pi - largest angle
  Angle smallest = Angle::degrees(60);     ///< no covering mesh with pi - largest >= under has more
  Angle under;                             ///< the condition, as pi - largest angle
  Standing of_largest = Standing::unknown;
  Standing of_smallest = Standing::unknown;
};

/// Regions by how they stand.
struct LimitCounts {
  std::array<std::size_t, kStandings> largest{};
  std::array<std::size_t, kStandings> smallest{};

  void add(const RegionLimits& limits) {
    ++largest[static_cast<std::size_t>(limits.of_largest)];
    ++smallest[static_cast<std::size_t>(limits.of_smallest)];
  }
};

/// "met", "optimal", ...
const char* describe(Standing standing);

}  // namespace cover
