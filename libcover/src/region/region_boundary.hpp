// A region as a closed piece of work: it needs nothing of its neighbours.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cover/ids.hpp>
#include <cover/options.hpp>
#include <cover/point.hpp>

#include "cdt/cdt.hpp"
#include "geom/topology/half_edges.hpp"

namespace cover {

/// In place of a segment: a side of the convex hull that no segment prescribes (`--hull`). It
/// borders on the void, so it may be split.
inline constexpr SegmentId kHullSide{0xffffffffU};

/// The boundary of one region.
///
/// Vertices are in spatial order (geom/spatial_order.hpp) and sides in lexicographic order of their
/// indices, so that all that is computed from a boundary depends on its geometry alone and not on
/// the order of the input, and neighbours are near each other in memory.
struct RegionBoundary {
  RegionId id;
  std::vector<Point> points;        ///< local vertices: boundary vertices and isolated points
  std::vector<VertexId> vertices;   ///< their ids in the PSLG
  std::vector<IndexPair> sides;     ///< local, directed, region on the left; slits both ways
  std::vector<SegmentId> segments;  ///< the segment of each side, or kHullSide
  double size = 0;                  ///< wished edge length inside; 0: none
  std::vector<double> size_at;      ///< wished edge length by vertex, 0: none; empty: none at all
  std::vector<double> size_along;   ///< the same by side, all along it; empty: none at all
  std::vector<std::string> size_expressions;  ///< of size_function, which is the least of them
  double size_grid = 0;  ///< so near each other are the places where these are looked at first
  SizeFunction size_function;         ///< wished edge length by place, beside Options::size_field
  std::vector<std::uint32_t> layers;  ///< by side: which of Options::layers plus one; empty: none
  /// What layers leave of a region, whose bound counts for both: if this misses its own, it gets no
  /// almonds.
  bool is_rest = false;
  /// The triangles of triangulate_region(), or what they were before something was changed, where
  /// they were found on the way. Only time depends on them.
  std::shared_ptr<const std::vector<IndexTriple>> known_cdt{};
  /// A place where the search for small values of size_function was cut off, if it was.
  std::optional<Point> size_missed{};

  [[nodiscard]] std::span<const IndexTriple> known_triangles() const {
    return known_cdt ? *known_cdt : std::span<const IndexTriple>();
  }
  /// Some sides may be split.
  [[nodiscard]] bool has_hull_sides() const {
    return std::find(segments.begin(), segments.end(), kHullSide) != segments.end();
  }
};

}  // namespace cover
