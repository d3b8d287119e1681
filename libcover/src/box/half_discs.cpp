// In a convex region every point inside sees all sides, and half discs are discs. Say the discs
// leave a set U of points besides the corners. Near a corner, free sides cover the directions that
// they make angles below 90 degrees with, all of them if the corner is below 180 degrees. So U is
// closed but for corners, and has an extreme point of its convex hull that is no corner. That point
// is on no arc alone, since U is outside of it; so two circles cross there, or it is on a side that
// is not free. Hence it is enough to look at the crossings of circles, at flat corners, where two
// circles touch, and at the sides that are not free.
// Tested by tests/unit/box/half_discs_test.cpp.
#include "box/half_discs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geom/box.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::size_t kMostSides = 24;
constexpr double kRoom = 1e-10;  ///< of squared lengths, in parts of that of the region

class Cover {
 public:
  Cover(std::span<const Point> points, std::span<const IndexPair> sides,
        const std::vector<bool>& is_free)
      : points_(points), sides_(sides), is_free_(is_free) {}

  [[nodiscard]] bool is_whole() {
    if (sides_.size() > kMostSides || sides_.size() != points_.size() || !is_convex_loop())
      return false;
    make_discs();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (discs_[i].is_free ? !corner_is_covered(i) : !side_is_covered(i)) return false;
    }
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      for (std::size_t j = i + 1; j < ring_.size(); ++j) {
        if (!crossings_are_covered(i, j)) return false;
      }
    }
    return true;
  }

 private:
  struct Disc {
    Point middle;
    double squared_radius = 0;
    bool is_free = false;
  };
  static constexpr std::size_t kNoSide = kMostSides;

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }
  [[nodiscard]] Point corner(std::size_t i) const { return points_[ring_[i]]; }

  /// ENSURES: if so, side i leads from corner i to the next, and side_[i] is its place
  [[nodiscard]] bool is_convex_loop() {
    std::array<std::size_t, kMostSides> leaving;
    leaving.fill(kNoSide);
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      if (leaving[sides_[s][0]] != kNoSide) return false;
      leaving[sides_[s][0]] = s;
    }
    std::uint32_t v = sides_[0][0];
    do {
      const std::size_t s = leaving[v];
      if (s == kNoSide || ring_.size() == sides_.size()) return false;
      ring_.push_back(v);
      side_.push_back(s);
      v = sides_[s][1];
    } while (v != sides_[0][0]);
    if (ring_.size() != sides_.size()) return false;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::size_t j = next(i), k = next(j);
      turn_.push_back(orientation(corner(i), corner(j), corner(k)));  // at corner j
      if (turn_.back() == Sign::negative) return false;
    }
    std::rotate(turn_.begin(), turn_.end() - 1, turn_.end());
    return true;
  }

  void make_discs() {
    const Box box = box_of(points_);
    room_ = kRoom * squared_length(box.high - box.low);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point a = corner(i), b = corner(next(i));
      discs_[i] = {midpoint(a, b), squared_length(b - a) / 4, is_free_[side_[i]]};
    }
  }

  [[nodiscard]] bool is_covered(Point p, std::size_t except, std::size_t other) const {
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (k != except && k != other && discs_[k].is_free &&
          squared_length(p - discs_[k].middle) < discs_[k].squared_radius - room_)
        return true;
    }
    return false;
  }

  /// At a flat corner the discs of both its sides leave the direction between them.
  [[nodiscard]] bool corner_is_covered(std::size_t i) const {
    const std::size_t before = i == 0 ? ring_.size() - 1 : i - 1;
    return turn_[i] == Sign::positive || is_covered(corner(i), i, before);
  }

  /// A side that is not free, as an interval from 0 to 1: no place of it is left, but for its ends.
  [[nodiscard]] bool side_is_covered(std::size_t i) const {
    const Point a = corner(i), b = corner(next(i));
    const Vector along = b - a;
    const double squared = squared_length(along), room = std::sqrt(kRoom);
    std::vector<std::array<double, 2>> covered;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (k == i || !discs_[k].is_free) continue;
      const double foot = part_on_line(along, discs_[k].middle - a);
      const double height = cross(along, discs_[k].middle - a) / std::sqrt(squared);
      const double half = discs_[k].squared_radius - height * height;
      if (!(half > room_)) continue;
      const double reach = std::sqrt(half / squared);
      std::array<double, 2> part{foot - reach + room, foot + reach - room};
      if (next(k) == i) part = {0, 2 * foot - room};  // the circle goes through the end
      if (next(i) == k) part = {2 * foot - 1 + room, 1};
      if (part[0] < part[1]) covered.push_back(part);
    }
    std::sort(covered.begin(), covered.end());
    double to = 0;
    for (const auto& [from, end] : covered) {
      if (from > to) return false;
      to = std::max(to, end);
    }
    return to >= 1;
  }

  [[nodiscard]] bool crossings_are_covered(std::size_t i, std::size_t j) const {
    const Disc &first = discs_[i], &second = discs_[j];
    if (!first.is_free || !second.is_free) return true;
    const Vector between = second.middle - first.middle;
    const double squared = squared_length(between);
    if (next(i) == j) return crossing_is_covered(mirrored(corner(j), first, between), i, j);
    if (next(j) == i) return crossing_is_covered(mirrored(corner(i), first, between), i, j);
    const double share = (squared + first.squared_radius - second.squared_radius) / (2 * squared);
    const double height = first.squared_radius / squared - share * share;
    if (height < -kRoom) return true;  // they do not meet
    const Point foot = first.middle + share * between;
    const Vector up = std::sqrt(std::max(height, 0.0)) * left_normal(between);
    return crossing_is_covered(foot + up, i, j) && crossing_is_covered(foot + (-1.0 * up), i, j);
  }

  /// The other crossing of two circles through `p`: its image in the line of their middles.
  [[nodiscard]] static Point mirrored(Point p, const Disc& first, Vector between) {
    const Vector normal = left_normal(between);
    return p + (-2 * part_on_line(normal, p - first.middle)) * normal;
  }

  [[nodiscard]] bool crossing_is_covered(Point p, std::size_t i, std::size_t j) const {
    if (is_covered(p, i, j)) return true;
    for (std::size_t k = 0; k < ring_.size(); ++k) {  // outside, clearly
      const Vector along = corner(next(k)) - corner(k);
      const double height = cross(along, p - corner(k));
      if (height < 0 && height * height > room_ * squared_length(along)) return true;
    }
    return false;
  }

  std::span<const Point> points_;
  std::span<const IndexPair> sides_;
  const std::vector<bool>& is_free_;
  std::vector<std::uint32_t> ring_;  ///< corners, counter-clockwise
  std::vector<std::size_t> side_;    ///< that leave them
  std::vector<Sign> turn_;           ///< at each corner
  std::array<Disc, kMostSides> discs_;
  double room_ = 0;
};

}  // namespace

bool half_discs_cover(std::span<const Point> points, std::span<const IndexPair> sides,
                      const std::vector<bool>& is_free) {
  return !sides.empty() && Cover(points, sides, is_free).is_whole();
}

}  // namespace cover
