// The boundaries of all regions, complete with what is wished of each.
#pragma once

#include <vector>

#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

#include "base/team.hpp"
#include "region/region_boundary.hpp"

namespace cover {

/// The boundary of every region, by RegionId - 1, with the sizes and the layers that `options` ask
/// for.
///
/// Errors: bad_option; those of resolve_sizes() and resolve_layers()
/// Cost:   O(n log n)
Result<std::vector<RegionBoundary>> boundaries_with_wishes(const Pslg& pslg,
                                                           const RegionTable& table,
                                                           const Options& options,
                                                           const Team& team = {});

}  // namespace cover
