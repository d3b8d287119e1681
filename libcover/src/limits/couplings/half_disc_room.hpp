// Where a vertex may lie without making the coupling of a side negative.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cdt/cdt.hpp"
#include "geom/box.hpp"

namespace cover {

/// The open half discs over the free sides of a region, those that no vertex of its boundary
/// encroaches. A vertex in one of them that sees its side makes the coupling of that side negative.
class HalfDiscRoom {
 public:
  /// `sides` are directed, the region on their left; `is_free` by side.
  HalfDiscRoom(std::span<const Point> points, std::span<const IndexPair> sides,
               const std::vector<bool>& is_free);

  struct Circle {
    std::array<Point, 3> corners;
    Point middle;
    double radius;  ///< infinite where the corners are too flat to tell
  };

  struct Room {
    std::vector<Point> places;         ///< some, in all parts of what is found
    bool is_none = false;              ///< proven: there is no such place
    std::vector<std::uint32_t> sides;  ///< whose discs cover the circle then, ascending
  };

  [[nodiscard]] static Circle circle_through(const std::array<Point, 3>& corners);

  /// Places in the region, inside the circle through `corners`, and in none of the half discs. With
  /// `most` 0 one place ends the search: it asks only for the proof that there is none.
  ///
  /// `first` are sides whose discs are to be used before others for that.
  /// REQUIRES: `corners` counter-clockwise
  /// EXACT:    is_none is proven, and so is what is said of places
  /// Cost:     O(sides), and some thousand boxes times the sides, half a million of these products
  ///           and 300 boxes at most; and as many sides as kMostWorkOnWalls
  /// Ref:      docs/box_method.md, "The same in small"
  [[nodiscard]] Room within_circle(const std::array<Point, 3>& corners, std::size_t most,
                                   std::span<const std::uint32_t> first = {}) const;

 private:
  struct Disc {
    Point middle;
    double radius;
    std::uint32_t side;
    /// Sides that come into the half disc; nothing before they are asked for, which few discs are.
    std::optional<std::vector<std::uint32_t>> walls;
  };
  struct Near;
  /// What one search looks at.
  struct Search;

  [[nodiscard]] Point start(std::uint32_t s) const { return points_[sides_[s][0]]; }
  [[nodiscard]] Point end(std::uint32_t s) const { return points_[sides_[s][1]]; }
  [[nodiscard]] bool is_inside(Point p) const;
  [[nodiscard]] bool is_place(Point p, const Search& search) const;
  [[nodiscard]] std::vector<std::uint32_t> walls_of(const Disc& disc) const;
  [[nodiscard]] Search begin(const std::array<Point, 3>& corners,
                             std::span<const std::uint32_t> first) const;
  [[nodiscard]] bool touches(std::uint32_t s, const Box& box) const;
  [[nodiscard]] bool is_left(const Box& box, std::uint32_t s) const;
  [[nodiscard]] bool keeps_left(const Box& box, const std::vector<std::uint32_t>& touching) const;
  [[nodiscard]] bool corner_is_covered(const Box& box, const std::vector<std::uint32_t>& touching,
                                       Search& search) const;
  [[nodiscard]] bool is_settled(const Box& box, const Near& near, Search& search) const;

  std::span<const Point> points_;
  std::span<const IndexPair> sides_;
  std::vector<bool> is_free_;
  std::vector<bool> is_slit_;  ///< by side
};

}  // namespace cover
