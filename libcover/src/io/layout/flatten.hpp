// All cells of a layout laid out in one plane.
#pragma once

#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

#include "io/layout/gds_library.hpp"
#include "io/layout/layer_map.hpp"

namespace cover {

/// Draws a cell with everything in it: polygons, paths with a width as polygons, paths without one
/// as lines, texts on the label layer as seeds. Coordinates are in the user's unit; those that no
/// cell turns or magnifies are the doubles next to what a person would write.
///
/// Errors: bad_option, where there is no such cell, or the library has several top cells and none
///         is named; unsupported_format, where cells contain themselves or there is more to draw
///         than the file has itself and kLayoutShapes or kLayoutPoints
/// Cost:   O(what is drawn), and what lies outside the window is passed over by rows of arrays
Result<Input> flatten(const GdsLibrary& library, const std::string& source,
                      const ReadOptions& options, LayerMap& layers);

}  // namespace cover
