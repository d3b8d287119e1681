// Straight pieces on their way from the input to a clean PSLG, each knowing where it comes from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/point.hpp>
#include <cover/report.hpp>

#include "base/none.hpp"

namespace cover {

/// The element of the input that a piece belongs to.
struct Origin {
  enum class Kind : std::uint8_t { segment, ring, line };
  Kind kind = Kind::segment;
  std::uint32_t index = 0;  ///< into Input::segments, Input::polygons or Input::lines
  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// A straight line as it was drawn, or as welding bent it.
struct Raw {
  Point a;
  Point b;
  Origin origin;
};

/// A piece of a raw line, in its direction.
struct Strand {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t raw = 0;  ///< index into Network::raws
};

/// Gives every place one number.
class PointPool {
 public:
  /// The number of the point at `p`, a new one if there is none yet.
  std::uint32_t index_of(Point p);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  std::vector<Point> take() { return std::move(points_); }

 private:
  /// Where the number of `p` stands, or would stand.
  [[nodiscard]] std::size_t slot_of(Point p) const;
  void grow();

  std::vector<Point> points_;
  std::vector<std::uint32_t> slots_;  ///< a hash table of numbers, half empty; kNone: free
};

/// All lines of an input. The strands of a ring are closed: at every point an even number of them
/// ends. Every step keeps that, so even-odd always says what a polygon covers.
struct Network {
  std::vector<Point> points;         ///< all different; each is the end of a strand, lone or named
  std::vector<std::uint32_t> input;  ///< by point: index into Input::points, or kNone
  std::vector<std::uint32_t> lone;   ///< points that stay whether a strand ends at them or not
  std::vector<std::uint32_t> named;  ///< those of Input::point_names, which stay as well
  std::vector<Raw> raws;
  std::vector<Strand> strands;  ///< none of length zero
};

/// Collects the lines of `input`, one strand each; equal points become one. The lines of
/// polygons that are `hidden`, by number, are left out.
///
/// What is dropped or merged is appended to `changes`.
/// REQUIRES: find_unusable finds nothing
/// Cost:     O(n log n).
Network gather(const Input& input, std::vector<Change>& changes,
               const std::vector<bool>& hidden = {});

/// "segment 3 from (0, 0) to (1, 0) (line 7)", "the edge of polygon 2 from ... to ...".
std::string name_of_raw(const Input& input, const Network& network, std::uint32_t raw);
/// The element for programs.
InputRef ref_of(const Input& input, Origin origin);
/// "polygon 3", "polygon 3 'gate'".
std::string name_of_polygon(const Input& input, std::uint32_t polygon);

}  // namespace cover
