// From pixels to painted polygons.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover {

/// A picture whose pixels have labels.
struct LabelImage {
  struct Label {
    std::string name;
    bool is_void = false;
  };
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint32_t> labels;  ///< by rows from the lowest one; index into `names`
  std::vector<Label> names;
};

/// What became of a picture.
struct ImageBorders {
  std::vector<InputPolygon> polygons;  ///< pixel (i, j) is the square from (i, j) to (i + 1, j + 1)
  std::size_t smoothed = 0;            ///< borders
  std::size_t less_smoothed = 0;       ///< of these, where others were in the way
  std::size_t tiny = 0;                ///< regions of fewer than 4 pixels
};

/// A polygon for each set of pixels of one label that hang together by their sides. Polygons share
/// their borders bit for bit. Without `smooth`, borders are the pixels' sides. With it, they are
/// curves between the places where three or more regions meet, which stay; no border is farther
/// than kMostMoved pixels from the pixels' sides; straight lines and circles come out straight and
/// round; what touches what is as it was: no two borders meet but at their ends, and around each
/// end they have the same order. Where a curve would break this, that border is smoothed less, and
/// in the end not at all. The frame of the picture stays as it is.
///
/// EXACT: crossings and orders are found by exact predicates
/// Cost:  O(pixels + n log n) for n sides of pixels on borders
/// Errors: unsupported_format for more regions than kImageRegions: photographs are none
Result<ImageBorders> borders_of(const LabelImage& image, bool smooth, const std::string& source);

}  // namespace cover
