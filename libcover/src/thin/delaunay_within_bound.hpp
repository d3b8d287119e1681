// Meshes of regions without a negative coupling on inner edges, where flips alone break the bound.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

/// Places that are tried for each angle to mend, some 0.5 us each.
inline constexpr std::uint64_t kPlacesToMend = 60'000;
/// The same where nothing but sides given up is left: of 12,000 Voronoi cells and five maps no
/// place beyond these has saved one,
inline constexpr std::uint64_t kPlacesForSides = 2'000;
/// and these save all but one in fifty.
inline constexpr std::uint64_t kFewPlacesForSides = 300;

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
/// `sides_are_cut` where they are given up: then no room is looked for in which they could be kept.
/// REQUIRES: `mesh` is measured
/// ENSURES:  the mesh holds the bound, has no negative coupling on inner edges and is measured; if
///           all that was so before, fewer are given up on sides
/// Cost:     O(n log n), and kPlacesToMend places for each angle to mend, `for_sides` where nothing
///           but sides given up is left; where a side is still given up then and `looks_for_room`,
///           up to 240 searches for room (HalfDiscRoom)
std::optional<MendedMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh,
                                                      const std::stop_token& stop,
                                                      std::uint64_t for_sides = kPlacesToMend,
                                                      bool looks_for_room = true);

}  // namespace cover
