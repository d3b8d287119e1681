// The whole region as one star.
#pragma once

#include <cstdint>
#include <optional>

#include "cdt/triangulation.hpp"
#include "quality/mutable/mutable_mesh.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// A star, if there is one, and what it took to look for it.
struct OneStar {
  std::optional<Triangulation> star;
  std::uint64_t evaluations = 0;  ///< stars looked at
};

/// The triangulation that joins every side to one new vertex, well placed, if all sides see it. For
/// round regions with many sides it has the fewest triangles and a smaller largest angle than
/// any refinement.
///
/// REQUIRES: `mesh` is the region's constrained Delaunay triangulation, its goal set
/// Cost:     O(sides), most often after a single look
OneStar one_star(const MutableMesh& mesh, const RegionBoundary& boundary);

}  // namespace cover
