// GDSII layouts.
#pragma once

#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Boundaries, boxes and paths with a width become painted polygons, with the name of their layer
/// as material and region, so that those of one layer unite where they touch; paths without a width
/// become lines of that name. ReadOptions choose layers, names, cell and window.
///
/// Errors: those of parse_gds_library(), LayerMap::make() and flatten()
Result<Input> parse_gds(std::string_view bytes, const std::string& source,
                        const ReadOptions& options);

}  // namespace cover
