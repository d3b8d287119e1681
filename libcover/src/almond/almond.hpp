// The almond of a side: what lies between the side and an arc on which no vertex is passed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <cover/ids.hpp>
#include <cover/point.hpp>

#include "base/team.hpp"
#include "cdt/sides.hpp"
#include "geom/vector.hpp"
#include "target/angle_limit.hpp"

namespace cover {

/// What stands over a side.
enum class AlmondKind : std::uint8_t {
  whole,      ///< the arc through the apex, or the one that sees the side under 120 degrees
  shrunk,     ///< a flatter arc
  triangle,   ///< no arc: the side's triangle of the constrained Delaunay triangulation
  none,       ///< nothing: the side itself bounds the remainder, and stays whole
  hull_side,  ///< a side that may be split: its "arc" is the side itself
};

/// The almond of the side from `u` to `v`: the points on its left that see it under more than
/// pi - nu. Its limit is the side and an arc from u to v.
///
/// A point of the arc is addressed by its *ratio* r = |uX| / |Xv|, from 0 at u to infinity at v, or
/// by its *place* s in [0, 1], which is proportional to the length of arc from u:
/// r = sin(s nu) / sin((1 - s) nu). Neither needs the centre of the circle, which runs to infinity
/// as nu goes to 0.
/// Ref: mitchell_1993_covering, section 2
struct Almond {
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  std::uint32_t apex = 0;  ///< third corner of the side's triangle
  EdgeRef base;            ///< the side's triangle
  AlmondKind kind = AlmondKind::whole;
  bool apex_limits = false;  ///< the apex sees the side under 120 degrees or more: no cap
  Point from, to;            ///< positions of u and v
  double length = 0;         ///< of chord()
  double resolution = 0;     ///< spacing of the final coordinates across the side, at its ends
  double nu = 0, sin_nu = 0, cos_nu = 1;

  [[nodiscard]] Vector chord() const { return to - from; }
  /// True if other arcs are to be met with this one.
  [[nodiscard]] bool has_arc() const {
    return kind != AlmondKind::triangle && kind != AlmondKind::none;
  }
  /// True if the arc passes the apex: by construction, not by measurement.
  [[nodiscard]] bool passes_apex() const {
    return apex_limits && (kind == AlmondKind::whole || kind == AlmondKind::triangle);
  }
  /// Makes the almond flatter, or sets it up.
  void set_nu(double value);

  /// Negative inside the circle of the arc, zero on it, positive outside; near the arc it is the
  /// distance from it times `length`. For nu = 0 the circle is the line of the side.
  [[nodiscard]] double power(Point x) const;
  /// The derivative of power() at `x` in direction `d`.
  [[nodiscard]] double power_slope(Point x, Vector d) const;
  /// The point of the arc with ratio `r`.
  [[nodiscard]] Point at_ratio(double r) const;
  /// The point of the arc with place `s`.
  [[nodiscard]] Point at_place(double s) const;
  /// The place of the point with ratio `r`.
  [[nodiscard]] double place_of_ratio(double r) const;
  /// The ratio of a point of the arc.
  [[nodiscard]] double ratio_of(Point x) const {
    return cover::length(x - from) / cover::length(x - to);
  }
  /// True if `x`, a point of the circle, lies on the arc and not on the rest of the circle.
  [[nodiscard]] bool on_the_arc(Point x) const { return dot(from - x, to - x) < 0; }
  /// Height of the arc over the side; at an end, a place s, it is about 4 s times that.
  [[nodiscard]] double height() const;
};

/// Heights over a side below this many spacings of the coordinates cannot be told from zero.
inline constexpr double kFlatArc = 16;

/// How far two computed positions of the same point of an arc may be apart, relative to the length
/// of the side: 8 times the rounding error of a coordinate difference of that length.
inline constexpr double kArcRounding = 0x1p-50;

/// One almond per side, as large as the paper makes it. Whether the cap of 120 degrees applies is
/// decided exactly; where it does not, the apex is on the arc by construction. `origin` is added to
/// the coordinates in the end, and decides what they can resolve.
std::vector<Almond> make_almonds(const Triangulation& cdt, std::span<const IndexPair> sides,
                                 std::span<const SegmentId> segments, const AngleLimit& limit,
                                 Point origin, const Team& team = {});

}  // namespace cover
