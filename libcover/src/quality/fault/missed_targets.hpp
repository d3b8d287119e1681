// What a region did not reach, for the report.
#pragma once

#include <cstddef>
#include <vector>

#include <cover/options.hpp>
#include <cover/point.hpp>
#include <cover/report.hpp>

#include "quality/mutable/mutable_mesh.hpp"
#include "region/region_boundary.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// Why nothing better was found.
enum class Unreached {
  unknown,
  budget,     ///< the region's budget was used up
  couplings,  ///< they leave no room for a vertex
};

/// What is known of a mesh beside its triangles.
struct MeshHistory {
  const AngleLimit& limit;          ///< of its sides
  Unreached why{};                  ///< what is missed
  Point origin{};                   ///< of its frame, in the plane
  std::size_t layer_triangles = 0;  ///< the first so many: small angles of these were asked for
};

/// Notes on angles above Options::max_angle or below Options::min_angle, apart by reason: forced by
/// the input at named segments, or not reached at the places given.
///
/// REQUIRES: `mesh` has the goal of the options set; its first points are those of `boundary`, less
///           MeshHistory::origin
std::vector<Note> missed_targets(const MutableMesh& mesh, const RegionBoundary& boundary,
                                 const Options& options, const MeshHistory& history,
                                 const Team& team = {});

}  // namespace cover
