// The limits of regions, for verify_cover(): from the PSLG alone, beside the angles of the mesh.
#pragma once

#include <span>
#include <vector>

#include <cover/limits.hpp>
#include <cover/verify.hpp>

#include "limits/angles/limit_prover.hpp"
#include "verify/expected_domain.hpp"

namespace cover {

/// By RegionId - 1. `region` is by triangle, kVoid for those to be passed over.
///
/// REQUIRES: the triangles are known to cover the regions, and no side is split
/// Cost:     O(n), and ProofEffort for every region that misses a target
std::vector<RegionLimits> verify_limits(const TriangleSoup& mesh, std::span<const RegionId> region,
                                        const ExpectedDomain& domain, const ReachedAngles& wanted,
                                        const Team& team = {});

}  // namespace cover
