// A region without layers: what a method leaves of negative couplings is mended.
#pragma once

#include <stop_token>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "quality/quality_region.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// method_with_fallback(), and of the quality method's mesh couplings mended as far as the bound
/// lets them.
///
/// Throws: what the method throws
ProvenMesh method_with_couplings_mended(const RegionBoundary& boundary, const Options& options,
                                        const std::stop_token& stop, const Team& team);

/// The same, but with targets before couplings where segments may be cut for them, if that leaves
/// fewer angles to cut for.
///
/// Throws: what the method throws
ProvenMesh better_of_couplings_and_angles(const RegionBoundary& boundary, const Options& options,
                                          const std::stop_token& stop, const Team& team);

}  // namespace cover
