// Meshes of regions without a negative coupling on inner edges, where flips alone break the bound.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include <cover/options.hpp>

#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// How many places are tried to mend couplings within the bound. A place costs some 0.5 us.
struct CouplingEffort {
  std::uint64_t places_per_angle = 60'000;  ///< that are tried for each angle beyond the bound,
  std::uint64_t places_per_side = 60'000;   ///< and for each side given up
  int circles_with_room = 120;              ///< that are filled for a side given up even then

  /// For a side, before room is looked for.
  static constexpr std::uint64_t kFewPlaces = 100;

  /// Of 12,000 Voronoi cells and five maps no place beyond 2,000 has saved a side, nor has a circle
  /// with room beyond the 16th; in a picture of grains one beyond the 24th has, with half as many
  /// places in each. With 100 places little effort gives up 234 sides of 6,000 cells, with 300 145,
  /// for 12 % more instructions. No room is looked for where sides are cut instead.
  static CouplingEffort of(Effort effort, bool sides_are_cut) {
    CouplingEffort out;
    if (effort != Effort::thorough) {
      out.places_per_side = effort == Effort::fast ? kFewPlaces : 2'000;
      out.circles_with_room = effort == Effort::fast ? 0 : 48;
    }
    if (sides_are_cut) out.circles_with_room = 0;
    return out;
  }
  /// Where layers are, few sides are left to mend: but with little effort, all is tried for each.
  static CouplingEffort beside_layers(Effort effort) {
    return effort == Effort::fast ? of(effort, false) : CouplingEffort();
  }
};

/// The constrained Delaunay triangulation of the vertices of `mesh`, of which some are moved, added
/// or taken away, those of layers only taken away and last, until it holds the bound and, if that
/// can be, no coupling of a side is given up. None if `mesh` is so already, if nothing better was
/// found, or if sides of the region may be split.
///
/// REQUIRES: `mesh` is measured
/// ENSURES:  the mesh holds the bound, has no negative coupling on inner edges and is measured; if
///           all that was so before, fewer are given up on sides
/// Cost:     O(n log n), and the places that `effort` allows for each angle to mend; where room is
///           looked for, twice as many searches as it allows (HalfDiscRoom)
std::optional<RegionMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh,
                                                      const std::stop_token& stop,
                                                      const CouplingEffort& effort = {});

}  // namespace cover
