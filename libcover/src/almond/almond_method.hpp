// The almond method for one region, from its constrained Delaunay triangulation to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <cover/report.hpp>

#include "almond/chords.hpp"
#include "almond/fill/fill_remainder.hpp"
#include "base/team.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// What the method works on.
struct AlmondInput {
  const Triangulation& cdt;
  std::span<const IndexPair> sides;
  std::span<const SegmentId> segments;  ///< by side
  const AngleLimit& limit;
  Point origin;          ///< to be added to all coordinates in the end
  bool sparing = false;  ///< only almonds that turn out to be needed; else one on every side
  Team team{};           ///< who shares the work
};

/// Something to report about a side.
struct SideRemark {
  Note::Kind kind = Note::Kind::repair;
  std::uint32_t side = 0;
  /// Continues "the almond of the segment from (0, 0) to (1, 0), seen by (0, 1), ".
  std::string what;
};

/// A covering triangulation.
struct AlmondMesh {
  std::vector<Point> points;  ///< those of the triangulation, then Steiner vertices, all in use
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<SideRemark> remarks;
  std::vector<FilledRemainder::Fallback> fallbacks;
};

/// Triangulates a region so that every triangle keeps rule.nu (promise 3), without a vertex on its
/// sides.
///
/// ENSURES: every triangle is counter-clockwise, and triangles and sides bound each other, in exact
///          arithmetic on the coordinates returned.
/// Cost:    O(n log n) and the fill's
/// Ref:     mitchell_1993_covering
AlmondMesh mesh_by_almonds(const AlmondInput& input, const CutRule& rule, const FillPlan& plan,
                           const std::stop_token& stop);

}  // namespace cover
