// Pictures of labels as geometry.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

struct Raster;

/// How a picture is taken.
struct ImageOptions {
  /// Smaller sets of pixels become part of their neighbours; see take_in_speckles(). 0: none.
  std::size_t speckle = 0;
  bool smooth = true;  ///< false: borders are the sides of pixels
  /// Lines of labels and names: "#ff0000,copper", "7,grain"; void for what is no material. Empty:
  /// labels are their own names.
  std::string legend;
  std::string legend_source;  ///< for messages
};

/// A region for each set of pixels of one label that hang together by their sides; see
/// ImageBorders. Labels are colours, as "#ff0000", or numbers. Pixels that are fully transparent
/// are void. A pixel is a unit square (in .nrrd and .mha what the header says), y points upwards,
/// and the lower left corner of the picture is the origin.
///
/// Errors: syntax, truncated, unsupported_format; also for pictures of more regions than
///         kImageRegions
/// Cost:   O(n log n) in the number of pixels
Result<Input> parse_image(std::string_view data, std::string_view extension,
                          const std::string& source, const ImageOptions& options = {});

/// The same of pixels that are known already.
///
/// Errors: syntax, of the legend; unsupported_format
Result<Input> input_of(const Raster& raster, const std::string& source,
                       const ImageOptions& options = {});

}  // namespace cover
