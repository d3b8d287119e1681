// What a region did not reach, for the report.
#pragma once

#include <vector>

#include <cover/options.hpp>
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

/// Notes on angles above Options::max_angle or below Options::min_angle, apart by reason: forced by
/// the input at named segments, or not reached at the places given.
///
/// REQUIRES: `mesh` has the goal of the options set; its first points are those of `boundary`, less
///           `origin`; small angles of the first `thin` triangles were asked for
std::vector<Note> missed_targets(const MutableMesh& mesh, const RegionBoundary& boundary,
                                 const AngleLimit& limit, const Options& options, Unreached why,
                                 Point origin = {}, std::size_t thin = 0, const Team& team = {});

}  // namespace cover
