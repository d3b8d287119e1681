// Meshes of regions without a negative coupling on inner edges, where flips alone break the bound.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include <cover/options.hpp>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// How hard couplings are mended. A place costs some 0.5 us.
struct MendEffort {
  std::uint64_t places_per_angle = 60'000;  ///< that are tried for each angle beyond the bound,
  std::uint64_t places_per_side = 60'000;   ///< and where nothing but sides given up is left
  bool looks_for_room = true;               ///< for a side that is given up even then

  /// For a side, before room is looked for.
  static constexpr std::uint64_t kFewPlaces = 100;

  /// Of 12,000 Voronoi cells and five maps no place beyond 2,000 has saved a side, and 300 save all
  /// but one in fifty. No room is looked for where sides are cut instead.
  static MendEffort of(Effort effort, bool sides_are_cut) {
    MendEffort out;
    if (effort != Effort::thorough) out.places_per_side = effort == Effort::fast ? 300 : 2'000;
    out.looks_for_room = !sides_are_cut && effort != Effort::fast;
    return out;
  }
};

/// A mesh whose inner edges are all locally Delaunay, with all angles within the bound.
struct MendedMesh {
  RegionMesh mesh;
  std::vector<std::uint32_t> gone;  ///< vertices of layers that are not there any more, as before
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
///           looked for, up to 240 searches (HalfDiscRoom)
std::optional<MendedMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh,
                                                      const std::stop_token& stop,
                                                      const MendEffort& effort = {});

}  // namespace cover
