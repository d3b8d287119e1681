// A GDSII file as its cells, with references between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

namespace cover {

/// A point in units of the database.
struct GdsPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  friend bool operator==(const GdsPoint&, const GdsPoint&) = default;
};

/// Layer and data type, or text type.
struct GdsLayer {
  std::int16_t layer = 0;
  std::int16_t type = 0;
  friend auto operator<=>(const GdsLayer&, const GdsLayer&) = default;
};

/// How a path ends, and how wide it is.
struct GdsPath {
  std::int32_t width = 0;  ///< negative: not magnified with its cell
  std::int16_t ends = 0;   ///< 0: flush, 1: round, 2: half a width more, 4: as the members say
  std::int32_t begin = 0;
  std::int32_t end = 0;
};

/// A polygon, or the middle line of a path.
struct GdsShape {
  static constexpr std::uint32_t kPolygon = ~std::uint32_t{0};
  GdsLayer layer;
  std::uint32_t first = 0;  ///< its points in GdsLibrary::points
  std::uint32_t count = 0;
  std::uint32_t path = kPolygon;  ///< index into GdsLibrary::paths
};

struct GdsText {
  GdsLayer layer;
  GdsPoint at;
  std::string text;
};

/// A cell in a cell, once or in rows and columns.
struct GdsReference {
  std::string name;
  std::uint32_t cell = 0;  ///< index into GdsLibrary::cells
  bool mirrored = false;   ///< about the x axis, before it is turned
  double magnification = 1;
  double angle = 0;  ///< degrees
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  std::array<GdsPoint, 3>
      at;                ///< where the first one is; beyond the last column; beyond the last row
  std::size_t byte = 0;  ///< place in the file
};

struct GdsCell {
  std::string name;
  std::vector<GdsShape> shapes;
  std::vector<GdsText> texts;
  std::vector<GdsReference> references;
};

struct GdsLibrary {
  double unit = 1e-3;    ///< of the database, in units of the user
  double metres = 1e-9;  ///< the same in metres
  std::vector<GdsPoint> points;
  std::vector<GdsPath> paths;
  std::vector<GdsCell> cells;
  std::size_t left_out = 0;  ///< shapes with no area: fewer than three points, or paths of one
  std::size_t absolute = 0;  ///< references whose angle or size is said to be absolute
};

/// Reads all cells.
///
/// ENSURES: every reference has its cell
/// Errors: truncated, syntax, unsupported_format, with the byte at fault
/// Cost:   O(n log n)
Result<GdsLibrary> parse_gds_library(std::string_view bytes, const std::string& source);

}  // namespace cover
