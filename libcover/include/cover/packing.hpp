// How a disk packing came about: for pictures and figures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <cover/point.hpp>
#include <cover/result.hpp>

namespace cover {

/// What became of a gap, a part with three or four sides between disks and segments; with the
/// number of triangles that it is made of before thinning.
enum class GapKind : std::uint8_t {
  three_disks,     ///< 6 triangles
  two_disks_line,  ///< 4
  good,            ///< 16, or 2 less per line
  cut,             ///< 28, or 2 to 4 less per line
  reflex,          ///< an arc above 180 degrees: split by a disk on the centre line; at most 56
  reflex_overlap,  ///<   ... one of whose halves is no gap: 12 there, or fewer by the lines
  two_lines,       ///< 6
  touching,        ///< opposite sides touch: two gaps of three sides
  cell,            ///< rounding spoilt the construction: its polygon was triangulated
};
inline constexpr std::size_t kGapKinds = 9;

/// The packing of a region, in its coordinates.
struct PackingRecord {
  /// What a disk was put for.
  enum class Purpose : std::uint8_t { corner, connection, reduction };
  struct Disk {
    Point centre;
    double radius = 0;
    Purpose purpose = Purpose::corner;
  };
  struct GapCell {
    GapKind kind = GapKind::good;
    std::vector<Point> polygon;  ///< centres and tangency points, counter-clockwise
  };
  std::vector<Disk> disks;
  std::vector<GapCell> gaps;
  std::vector<std::array<Point, 3>> triangles;  ///< of the result
  std::vector<std::array<Point, 2>> outline;    ///< the boundary
  std::array<std::size_t, kGapKinds> kinds{};   ///< how many gaps of each kind
  int attempts = 0;                             ///< 1 unless rounding made it begin anew
};

/// What a picture of packings shows.
enum class PackingStage : std::uint8_t {
  disks,      ///< the first disks: in corners or on the boundary, and between holes
  gaps,       ///< all disks, and the gaps by kind
  triangles,  ///< the result
};

/// Draws packings as one SVG, `width` pixels wide.
///
/// Errors: cannot_write
Status write_packing_svg(const std::vector<PackingRecord>& packings, PackingStage stage, int width,
                         const std::string& path);

}  // namespace cover
