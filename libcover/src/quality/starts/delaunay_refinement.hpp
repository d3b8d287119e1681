// Constrained Delaunay refinement with locked sides.
#pragma once

#include <cstdint>

#include "quality/mutable/mutable_mesh.hpp"
#include "quality/parts/work_in_parts.hpp"
#include "sizes/size_field.hpp"

namespace cover {

/// What `refine` aims at, and where it stops.
struct RefineLimits {
  double smallest_cot = 0;            ///< triangles with a smaller angle get a vertex near them
  double largest_radius = kInverted;  ///< so do those with a larger circumradius
  double apex_cot = -0.36;            ///< no new vertex sees a side at a larger angle: 110 degrees
  bool keeps_couplings = false;       ///< no new vertex makes the coupling of a side negative
  std::size_t budget = 0;             ///< vertices
  /// Sides from this one on are edges to other parts of a mesh (Part): what reaches them waits.
  std::uint32_t first_border = kSideBit;
};

/// Inserts circumcentres and off-centres of triangles with small angles, and of those that are too
/// large for `sizes`. A point is not inserted if
/// - a side lies in the way, or would be seen from it at too large an angle;
/// - it lies in the circle of a triangle that is the best there is for a side whose angle is
///   forced above the goal (or for the edges of such a triangle, if these are forced in turn).
/// The triangle is left then.
///
/// A large mesh is refined in parts; a point whose cavity reaches a border waits until all parts
/// are one mesh again, so that borders leave no trace.
///
/// REQUIRES: `mesh` is constrained Delaunay, with its goal set
/// ENSURES:  `mesh` is constrained Delaunay, its excesses measured, its numbers arranged
/// Ref:      J. Ruppert, J. Algorithms 18 (1995); A. Uengoer, CGTA 42 (2009)
void refine(MutableMesh& mesh, const RefineLimits& limits, SizeField sizes = {},
            const Sharing& sharing = {});

}  // namespace cover
