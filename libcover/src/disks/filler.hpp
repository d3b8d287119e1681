// The interface of a fill: how the remainder, or any polygon with holes, is triangulated.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <stop_token>
#include <string>
#include <vector>

#include <cover/point.hpp>

namespace cover {

/// A piece of boundary with the domain on its left.
struct Chord {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  bool locked = false;  ///< must stay whole
  /// Triangles with a corner on this chord are good enough if they keep pi - angle >= nu: beside a
  /// flat almond nothing better is asked for.
  double nu = std::numbers::pi;
};

/// A connected polygon with holes. A vertex may be visited several times; points on no chord are
/// isolated points inside.
struct FillTask {
  std::vector<Point> points;
  std::vector<Chord> chords;
};

/// The points that a fill put on a chord, from its end a to its end b.
struct ChordSplit {
  std::uint32_t chord = 0;              ///< index into FillTask::chords
  std::vector<std::uint32_t> vertices;  ///< indices as in Filling::triangles
};

/// The triangulation of a FillTask.
struct Filling {
  std::vector<Point> added;                             ///< vertex points.size() + k is added[k]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise
  std::vector<ChordSplit> splits;                       ///< by chord; only chords that got points
  bool target_reached = true;                           ///< no angle above what the fill aims at
  std::string remark;                                   ///< what fell short, empty if nothing
};

/// A way to triangulate a polygon with holes without large angles.
class Filler {
 public:
  virtual ~Filler() = default;

  /// Triangulates `task`.
  ///
  /// ENSURES: the triangles cover the domain, conform, and keep locked chords whole;
  ///          `target_reached` says whether every angle is at most what the fill aims at.
  [[nodiscard]] virtual Filling fill(const FillTask& task, std::stop_token stop) const = 0;
};

}  // namespace cover
