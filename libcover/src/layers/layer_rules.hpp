// Which sides of which regions get layers: from names in the options to sides of regions.
#pragma once

#include <span>

#include <cover/input.hpp>
#include <cover/options.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>

#include "region/region_boundary.hpp"

namespace cover {

/// The options with the layers that the input asks for before their own.
Options with_layers_of(const Input& input, const Options& options);

/// Fills RegionBoundary::layers from Options::layers. Where several rules hold on a side, the last
/// counts.
///
/// Errors: bad_option for a line or a region that there is not, a region that is not beside the
///         line, layers thinner than coordinates can hold or thicker than the region
Status resolve_layers(const Pslg& pslg, const RegionTable& table, const Options& options,
                      std::span<RegionBoundary> boundaries);

}  // namespace cover
