// The limits of a region beside what a mesh of it has reached.
#pragma once

#include <cover/limits.hpp>

#include "limits/angles/limit_prover.hpp"

namespace cover {

/// Looks for limits where a target is missed.
///
/// REQUIRES: `cdt` as for LimitProver; a covering mesh of the region has reached `reached`, and
///           `around` the vertices of `cdt`, if that is not empty: with it fewer sides are asked
/// ENSURES:  what is found does not depend on the team
/// Cost:     nothing where both targets are met; else O(triangles) and ProofEffort
RegionLimits region_limits(const Triangulation& cdt, const ReachedAngles& reached,
                           const ReachedAngles& wanted, const Team& team = {},
                           const ProofEffort& effort = {}, AnglesAround around = {});

/// The same by a prover that may have been asked before: also limits that `meshes` alone have,
/// which are Standing::coupled.
///
/// REQUIRES: one of `meshes` has reached that
RegionLimits region_limits(LimitProver& prover, const ReachedAngles& reached,
                           const ReachedAngles& wanted, const ProofEffort& effort,
                           AnglesAround around, Meshes meshes);

/// What is reached, where couplings leave no other mesh.
RegionLimits limits_by_couplings(const ReachedAngles& reached, const ReachedAngles& wanted);

/// True if both targets are met: no limit is looked for.
bool meets(const ReachedAngles& reached, const ReachedAngles& wanted);

}  // namespace cover
