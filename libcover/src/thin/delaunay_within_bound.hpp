// Meshes of regions without a negative coupling on inner edges, where flips alone break the bound.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "region/region_boundary.hpp"
#include "target/region_mesh.hpp"

namespace cover {

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
/// Cost:     O(n log n), and some 60,000 places tried for each angle to mend, 0.5 us each; where a
///           side is still given up then, up to 240 searches for room (HalfDiscRoom)
std::optional<MendedMesh> mend_couplings_within_bound(const RegionBoundary& boundary,
                                                      const RegionMesh& mesh, std::stop_token stop,
                                                      bool sides_are_cut = false);

}  // namespace cover
