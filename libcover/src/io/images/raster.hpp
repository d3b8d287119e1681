// Pictures as numbers, and the readers that make them of files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/point.hpp>
#include <cover/result.hpp>

namespace cover {

/// A pixel without anything: fully transparent. No colour is this, nor a number that anyone takes
/// for a label; -1 is one.
inline constexpr std::uint64_t kNoPixel = std::uint64_t{1} << 63U;

/// Where a file says that its picture lies on a map.
struct PlaceOnMap {
  std::string system;  ///< "EPSG:25832"; empty: not said
  Point first;         ///< where the first pixel of the first row is
  double pixel_width = 1;
  double pixel_height = 1;
};

/// A number for each pixel: a grey value or label; or a colour, 16 bits for each of red, green,
/// blue.
struct Raster {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint64_t> pixels;  ///< by rows from the lowest one, in each from the left
  bool is_colour = false;
  bool is_signed = false;    ///< numbers are those of std::int64_t
  std::size_t pictures = 1;  ///< in the file, of which this is the first
  Point corner;              ///< the lower left one
  double pixel_width = 1;
  double pixel_height = 1;
  std::optional<PlaceOnMap> place;       ///< told only: `corner` and sizes of pixels know none
  std::optional<std::uint64_t> no_data;  ///< pixels that hold nothing, as the file says, if any do
};

/// Readers by format. `source` is the file's name for messages. More pixels than a file of its size
/// can have (kImagePixels) are refused before there is memory for them.
///
/// Errors: syntax, truncated, unsupported_format
/// Cost:   O(pixels + length of data)
Result<Raster> decode_png(std::string_view data, const std::string& source);
Result<Raster> decode_bmp(std::string_view data, const std::string& source);
Result<Raster> decode_tiff(std::string_view data, const std::string& source);
Result<Raster> decode_nrrd(std::string_view data, const std::string& source);
Result<Raster> decode_mha(std::string_view data, const std::string& source);

/// Whether data begin as a TIFF picture does: the extension .tif has other users.
bool is_tiff(std::string_view data);

}  // namespace cover
