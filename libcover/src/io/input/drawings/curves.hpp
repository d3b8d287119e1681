// Circles and arcs cut into chords, once per circle, so that neighbours that give the same curve,
// or overlapping pieces of it, get identical points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <cover/arcs.hpp>
#include <cover/point.hpp>

#include "geom/turn.hpp"

namespace cover {

/// A piece of a circle. Angles in degrees, counter-clockwise from the x axis; the arc runs
/// counter-clockwise where `to` is larger than `from`, else clockwise.
struct Arc {
  Point centre;
  double radius = 0;
  double from = 0;
  double to = 360;
  double step = 120;  ///< largest angle that one chord may span
  long chords = 0;    ///< as many were asked for, and the step is theirs; 0: as the step says
  [[nodiscard]] bool full() const { return is_full_turn(from, to); }
  /// Both ends of a full circle: the angle of the two that was rounded less.
  [[nodiscard]] double seam() const { return std::abs(to) < std::abs(from) ? to : from; }
};

/// The largest angle, in degrees and at most 120, of a chord that leaves its arc by no more than
/// `chord_error`.
///
/// REQUIRES: chord_error > 0, radius > 0
double step_for_chord_error(double radius, double chord_error);

/// The point at an angle in degrees. Exact on the axes, symmetric about them and the diagonals.
Point point_on_circle(Point centre, double radius, double degrees);

/// Cuts the arcs of one file. First all arcs are added, then points may be asked for.
///
/// A circle is known by the very doubles of its centre and radius. The ends of all arcs on it are
/// points of the circle, and each gap between neighbouring ends is divided evenly by the smallest
/// step that any of its arcs asks for. A point depends on its circle and its angle alone.
class CurveCutter {
 public:
  void add(const Arc& arc);

  /// Points along the arc, both ends included; of a full circle the first is repeated last.
  /// Nothing if there would be more than `most` of them.
  ///
  /// REQUIRES: the arc was added, and no other one since the first call
  std::optional<std::vector<Point>> points(const Arc& arc, std::size_t most);

  /// A sentence for each circle that has an arc of more chords than it asks for, since another one
  /// asks for shorter ones; of several such arcs the one that asks for the longest is told.
  ///
  /// REQUIRES: points of all arcs were asked for
  [[nodiscard]] std::vector<std::string> finer_than_asked() const;

 private:
  struct Circle {
    std::vector<double> ends;  ///< in [0, 360)
    double step = 120;
    Arc coarsest;                ///< of the largest step, if Arc::chords says how many chords
    std::vector<double> angles;  ///< of all points, ascending; empty: not cut yet
  };
  using Key = std::tuple<double, double, double>;
  static bool cut(Circle& circle, std::size_t most);
  /// The first of its angles that an arc has, and how many chords follow.
  static std::array<std::size_t, 2> chords_of(const Circle& circle, const Arc& arc);

  std::map<Key, Circle> circles_;
};

/// Numbers the circles of an input as they come.
class CircleNumbers {
 public:
  /// REQUIRES: `circles` outlives this, and nobody else adds to it
  explicit CircleNumbers(std::vector<ArcCircle>& circles) : circles_(circles) {}
  /// The number of a circle, from 1 on; the same doubles are the same circle.
  std::uint32_t of(const ArcCircle& circle);

 private:
  std::vector<ArcCircle>& circles_;
  std::map<ArcCircle, std::uint32_t> numbers_;
};

/// The angle in degrees that an arc about `centre` spans from a to b: in (0, 360], or in [-360, 0)
/// where it runs clockwise. From a point to itself it is a full turn.
double sweep_between(Point a, Point b, Point centre, bool clockwise);

/// An arc from one given point to another about `centre`, both ends kept bit for bit; where the
/// two are not equally far from the centre the radius goes over evenly. The same arc given from its
/// other end has the same points.
///
/// ENSURES: nothing if there would be more than `most` points
std::optional<std::vector<Point>> cut_arc_between(Point a, Point b, Point centre, bool clockwise,
                                                  double step, std::size_t most);

}  // namespace cover
