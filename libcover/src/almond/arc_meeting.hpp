// Where two arcs meet.
#pragma once

#include <array>
#include <span>

#include "almond/almond.hpp"
#include "almond/arc_walk.hpp"

namespace cover {

/// A common point of two arcs that is not known by identity.
struct Meeting {
  Point at;
  double place_a = 0;
  double place_b = 0;
};

/// At most two meetings.
struct Meetings {
  std::array<Meeting, 2> item;
  int count = 0;
};

/// The common points of two arcs besides the vertices that both are known to pass, whether or not
/// they are visible. Touching arcs, and arcs whose overlap is no wider than the square root of the
/// rounding error, have one.
///
/// An overlap of that width at a common vertex (arcs tangent there, as at a corner of 120 degrees)
/// is no meeting at all. Error bound: a few rounding errors of a coordinate difference as long as
/// the longer side, across both arcs.
Meetings meet(const Almond& a, std::span<const KnownVertex> known_a, const Almond& b,
              std::span<const KnownVertex> known_b);

}  // namespace cover
