// What no mesh of a region can have better than the one that was made.
#pragma once

#include <memory>

#include <cover/options.hpp>
#include <cover/report.hpp>

#include "base/team.hpp"
#include "limits/region_proof.hpp"
#include "region/region_boundary.hpp"
#include "region/region_mesh.hpp"

namespace cover {

/// What limits of the region are proven by.
std::unique_ptr<RegionProof> proof_of(const RegionBoundary& boundary);

/// Limits of the targets that `mesh` misses. `proof` is what was proven of the region on the way,
/// or null.
RegionLimits proven_limits(const RegionBoundary& boundary, const RegionMesh& mesh,
                           const Options& options, const Team& team,
                           std::unique_ptr<RegionProof> proof);

}  // namespace cover
