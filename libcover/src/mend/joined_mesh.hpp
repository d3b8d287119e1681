// The meshes of all regions as one, in plain arrays: what is mended and thinned out.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cover/point.hpp>

#include "geom/topology/half_edges.hpp"

namespace cover {

/// A straight line that vertices may be put on.
struct StraightLine {
  Point a, b;
};

/// The meshes of all regions as one, or that of a region alone, whose vertices know what they may
/// do.
struct JoinedMesh {
  /// In place of a line: the vertex stays where it is.
  static constexpr std::uint32_t kFixed = 0xfffffffeU;
  /// In place of a line: the vertex lies inside of a region. Of an edge: it is on no line.
  static constexpr std::uint32_t kInside = 0xffffffffU;
  /// In place of a line: the vertex lies inside of a region and stays where it is, or goes.
  static constexpr std::uint32_t kMayGo = 0xfffffffdU;

  /// An edge of the mesh that is a piece of a line.
  struct Piece {
    std::uint32_t a, b;
    std::uint32_t line;
  };

  std::vector<Point> points;
  std::vector<std::uint32_t> line;  ///< by point: the line that it cuts, or one of the above
  std::vector<StraightLine> lines;  ///< those that may be cut
  std::vector<Piece> pieces;  ///< each once, in any direction; lines beyond `lines` stay whole
  std::vector<IndexTriple> triangles;  ///< counter-clockwise
  std::vector<std::uint32_t> region;   ///< by triangle
};

}  // namespace cover
