// Where the vertices of layers lie: straight up, in the mitre of a slight bend, and around corners.
#pragma once

#include <cstdint>
#include <vector>

#include <cover/point.hpp>

#include "geom/vector.hpp"

namespace cover::layers {

/// Corners of a regular polygon turn alike up to rounding, which shall not decide: by 1e-9 of a
/// bend, as long as edges are longer than some 1e-7 of the coordinates.
inline constexpr double kTurnRounding = 1 + 1e-9;
/// Bends to the right up to this get a mitre: angles beside it are at most 100 degrees.
inline constexpr double kMitre = 20 * kTurnRounding;  ///< degrees
/// How far from a right angle corners may be that are filled with squares, and walls up to which
/// layers run: angles are at most 100 degrees then.
inline constexpr double kSkew = 10 * kTurnRounding;  ///< degrees
/// Bends to the left below this get a mitre: angles beside it are 90 degrees and half of the bend
/// at most, below 130, which no bound forbids (promise 3). From there on, what follows is a wall.
inline constexpr double kInnerMitre = 90 - kSkew;  ///< degrees

/// How a vertex of the front becomes vertices of the next row.
struct Offset {
  enum class Kind : std::uint8_t {
    plain,   ///< one vertex
    corner,  ///< three, which make a square with it: the boundary turns right by about 90 degrees
    fan,     ///< several around a vertex of the boundary, which turns right by another angle
  };
  Kind kind = Kind::plain;
  Point base;
  Vector along;     ///< per unit of thickness; of the vertex itself, or of the corner's tip
  Vector from, to;  ///< unit normals of the two edges; not where plain

  /// The place of the vertex, or of the tip, over layers of this thickness.
  [[nodiscard]] Point at(double thickness) const { return base + thickness * along; }
};

/// The angle in degrees by which a line turns left from an edge with normal `from` to one with
/// normal `to`; in [-180, 180].
double turning_angle(Vector from, Vector to);

/// The offset of a vertex of the boundary between edges with these unit normals.
///
/// `turn_back`: the boundary goes round the end of a slit there.
/// REQUIRES: it turns left by less than kInnerMitre
Offset offset_of(Point base, Vector from, Vector to, bool turn_back);

/// The vertices of the next row over a vertex of the front, along the line; `below` is the
/// thickness of the rows there are. Before and after each of Kind::corner lie the other two corners
/// of its square.
std::vector<Offset> tops_of(const Offset& offset, double below);

/// The unit normal of the edge between two successive tops over one vertex.
Vector normal_between(const Offset& a, const Offset& b);

}  // namespace cover::layers
