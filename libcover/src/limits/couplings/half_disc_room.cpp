// Boxes, divided until each is settled: outside of the circle, outside of the region, or with all
// that it has of the region in one half disc. Whether that is so is told by exact signs at its
// corners: half discs and circles are convex.
//
// What sees the side. Let p be in the open half disc of side s, and on the left of every side that
// comes into the half disc (its walls). Go from a place q inside s towards p: the first wall that
// is met is met from its left, so p would be on its right. There is none, and p sees q.
//
// What a box has of the region. Where just one side passes through it, from edge to edge, and its
// other side is not the region's as well, that is the part on its left. The same holds where just
// two sides that meet in the box pass, if the corner is below 180 degrees. Near such a corner A, of
// u degrees between two free sides of lengths a and b, the two discs cover all directions between
// the sides up to the distance min(a, b) cos(u/2): the nearer side is at most at u/2.
// Tested by tests/unit/limits/couplings/half_disc_room_test.cpp.
#include "limits/couplings/half_disc_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/numbers.hpp"
#include "geom/foot.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr double kMargin = 1e-9;    ///< of lengths: far more than rounding makes
constexpr double kFlattest = 1e-5;  ///< of triangles, twice their area in parts of squared lengths
constexpr int kLevels = 14;         ///< of division
constexpr int kFirstLevel = 4;      ///< from it on places are looked for
constexpr std::size_t kMostBoxes = 24'000;  ///< of one level, and in all for a circle,
constexpr std::size_t kLeastBoxes = 300;    ///< but fewer
constexpr std::size_t kMostWork = 500'000;  ///< where there are many sides, which each box asks
/// Likewise of discs whose walls are looked for, which asks all sides: later ones cover nothing.
constexpr std::size_t kMostWorkOnWalls = 20'000'000;
constexpr std::array<std::array<double, 2>, 5> kTrials{
    {{0.5, 0.5}, {0.23, 0.31}, {0.71, 0.27}, {0.29, 0.77}, {0.79, 0.69}}};

std::array<Point, 4> corners_of(const Box& box) {
  return {box.low, Point{box.high.x, box.low.y}, box.high, Point{box.low.x, box.high.y}};
}

Point at(const Box& box, const std::array<double, 2>& share) {
  return {box.low.x + share[0] * box.width(), box.low.y + share[1] * box.height()};
}

/// Whether the nearest point of the box is farther from `p` than that.
bool is_beyond(const Box& box, Point p, double distance) {
  const double x = std::max({box.low.x - p.x, p.x - box.high.x, 0.0});
  const double y = std::max({box.low.y - p.y, p.y - box.high.y, 0.0});
  return x * x + y * y > distance * distance;
}

bool is_seen_bluntly(Point a, Point p, Point b) {
  return compare_with_90_degrees(a, p, b) == Sign::positive;
}

}  // namespace

HalfDiscRoom::Circle HalfDiscRoom::circle_through(const std::array<Point, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector u = b - a, v = c - a;
  const double area = 2 * cross(u, v);
  // So flat that the middle is not known as well as kMargin asks: no circle.
  if (!(area > kFlattest * (squared_length(u) + squared_length(v)))) return {corners, a, kInfinity};
  const Vector to =
      (1 / area) * (squared_length(u) * Vector{v.y, -v.x} + squared_length(v) * Vector{-u.y, u.x});
  return {corners, a + to, length(to)};
}

/// What may concern a box. What does not concern it does not concern its parts, so a part is asked
/// with what is left of the lists of the whole.
struct HalfDiscRoom::Near {
  std::span<const std::uint32_t> sides;  ///< that may touch it
  std::span<const std::uint32_t> discs;  ///< that may meet it, by their places in the search
};

struct HalfDiscRoom::Search {
  Circle circle;
  std::vector<Disc> discs;                       ///< that meet the circle
  std::vector<bool> is_used;                     ///< by side: its disc covers a box
  Box box;                                       ///< the first one
  std::size_t discs_left = 0;                    ///< whose walls may still be looked for
  std::vector<std::uint32_t> touching, meeting;  ///< sides and discs, of the box asked last
};

namespace {

/// Lists one behind the other.
struct Range {
  std::size_t begin, end;
};

Range append(std::vector<std::uint32_t>& lists, const std::vector<std::uint32_t>& list) {
  lists.insert(lists.end(), list.begin(), list.end());
  return {lists.size() - list.size(), lists.size()};
}

std::span<const std::uint32_t> part(const std::vector<std::uint32_t>& lists, Range range) {
  return std::span(lists).subspan(range.begin, range.end - range.begin);
}

std::vector<std::uint32_t> first_numbers(std::size_t n) {
  std::vector<std::uint32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// The boxes of one level, and what is near them.
struct Level {
  struct Cell {
    Box box;
    Range sides, discs;  ///< in `lists`
  };
  std::vector<Cell> cells;
  std::vector<std::uint32_t> lists;

  void clear() {
    cells.clear();
    lists.clear();
  }
};

}  // namespace

HalfDiscRoom::HalfDiscRoom(std::span<const Point> points, std::span<const IndexPair> sides,
                           const std::vector<bool>& is_free)
    : points_(points), sides_(sides), is_free_(is_free), is_slit_(sides.size()) {
  std::vector<IndexPair> sorted(sides.begin(), sides.end());
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t s = 0; s < sides.size(); ++s)
    is_slit_[s] =
        std::binary_search(sorted.begin(), sorted.end(), IndexPair{sides[s][1], sides[s][0]});
}

/// Windings, by exact signs.
/// REQUIRES: `p` is on no side
bool HalfDiscRoom::is_inside(Point p) const {
  int windings = 0;
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    const Point a = start(s), b = end(s);
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const Sign turn = orientation(a, b, p);
    if (a.y <= p.y && turn == Sign::positive) ++windings;
    if (a.y > p.y && turn == Sign::negative) --windings;
  }
  return windings > 0;
}

/// Half discs are taken without asking who sees what: that costs places, and is never wrong.
bool HalfDiscRoom::is_place(Point p, const Search& search) const {
  const auto& [a, b, c] = search.circle.corners;
  if (in_circle(a, b, c, p) != Sign::positive) return false;
  const auto holds_it = [&](std::uint32_t d) {
    const std::uint32_t s = search.discs[d].side;
    return is_seen_bluntly(start(s), p, end(s)) &&
           orientation(start(s), end(s), p) == Sign::positive;
  };
  if (std::any_of(search.meeting.begin(), search.meeting.end(), holds_it)) return false;
  const auto is_on_it = [&](std::uint32_t s) {
    return orientation(start(s), end(s), p) == Sign::zero;
  };
  // A box that no side touches is inside as a whole, or it would be settled.
  return search.touching.empty() ||
         (std::none_of(search.touching.begin(), search.touching.end(), is_on_it) && is_inside(p));
}

std::vector<std::uint32_t> HalfDiscRoom::walls_of(const Disc& disc) const {
  std::vector<std::uint32_t> walls;
  const IndexPair own = sides_[disc.side];
  const Point a = start(disc.side), b = end(disc.side);
  const double reach = disc.radius * (1 + 2 * kMargin);
  const Point m = disc.middle;
  const Box around{{m.x - reach, m.y - reach}, {m.x + reach, m.y + reach}};
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    // Most sides are far from it.
    if (s == disc.side || !box_of(std::array{start(s), end(s)}).meets(around) ||
        distance_to_segment(disc.middle, start(s), end(s)) > disc.radius * (1 + kMargin))
      continue;
    if (orientation(a, b, start(s)) != Sign::positive &&
        orientation(a, b, end(s)) != Sign::positive)
      continue;
    // From an end of the side on it leaves the disc at once, unless the corner is below 90 degrees.
    const bool from_b = sides_[s][0] == own[1], to_b = sides_[s][1] == own[1];
    const bool from_a = sides_[s][0] == own[0], to_a = sides_[s][1] == own[0];
    if (from_b || to_b || from_a || to_a) {
      const Point far = from_b || from_a ? end(s) : start(s);
      const bool at_b = from_b || to_b;
      if (compare_with_90_degrees(far, at_b ? b : a, at_b ? a : b) != Sign::negative) continue;
    }
    walls.push_back(s);
  }
  return walls;
}

HalfDiscRoom::Search HalfDiscRoom::begin(const std::array<Point, 3>& corners,
                                         std::span<const std::uint32_t> first) const {
  const Circle circle = circle_through(corners);
  Search search{circle, {}, std::vector<bool>(sides_.size(), false), {}, 0, {}, {}};
  search.discs_left = kMostWorkOnWalls / sides_.size();
  Box region = box_of(points_);
  const Point m = circle.middle;
  const double r = circle.radius * (1 + kMargin);
  search.box.add({std::max(region.low.x, m.x - r), std::max(region.low.y, m.y - r)});
  search.box.add({std::min(region.high.x, m.x + r), std::min(region.high.y, m.y + r)});
  for (std::uint32_t s = 0; s < sides_.size(); ++s) {
    if (!is_free_[s]) continue;
    const Disc disc{midpoint(start(s), end(s)), length(end(s) - start(s)) / 2, s, {}};
    if (length(disc.middle - m) < r + disc.radius * (1 + kMargin)) search.discs.push_back(disc);
  }
  const auto is_first = [&](const Disc& d) {
    return std::find(first.begin(), first.end(), d.side) != first.end();
  };
  std::stable_partition(search.discs.begin(), search.discs.end(), is_first);
  return search;
}

/// Whether side and box have a point in common: by the axes that separate convex sets.
bool HalfDiscRoom::touches(std::uint32_t s, const Box& box) const {
  const Point a = start(s), b = end(s);
  if (!box_of(std::array{a, b}).meets(box)) return false;
  bool left = false, right = false;
  for (const Point& corner : corners_of(box)) {
    const Sign turn = orientation(a, b, corner);
    left = left || turn != Sign::negative;
    right = right || turn != Sign::positive;
    if (left && right) return true;
  }
  return false;
}

bool HalfDiscRoom::is_left(const Box& box, std::uint32_t s) const {
  for (const Point& corner : corners_of(box)) {
    if (orientation(start(s), end(s), corner) == Sign::negative) return false;
  }
  return true;
}

/// Whether all that the box has of the region is on the left of each of the sides that touch it.
bool HalfDiscRoom::keeps_left(const Box& box, const std::vector<std::uint32_t>& touching) const {
  for (const std::uint32_t s : touching) {
    if (is_slit_[s]) return false;
  }
  if (touching.size() == 1) return !box.holds(start(touching[0])) && !box.holds(end(touching[0]));
  if (touching.size() != 2) return false;
  std::uint32_t before = touching[0], after = touching[1];
  if (sides_[before][1] != sides_[after][0]) std::swap(before, after);
  return sides_[before][1] == sides_[after][0] && box.holds(end(before)) &&
         !box.holds(start(before)) && !box.holds(end(after)) &&
         orientation(start(before), end(before), end(after)) == Sign::positive;
}

/// REQUIRES: keeps_left()
bool HalfDiscRoom::corner_is_covered(const Box& box, const std::vector<std::uint32_t>& touching,
                                     Search& search) const {
  if (touching.size() != 2 || !is_free_[touching[0]] || !is_free_[touching[1]]) return false;
  std::uint32_t before = touching[0], after = touching[1];
  if (sides_[before][1] != sides_[after][0]) std::swap(before, after);
  const Point corner = end(before);
  const Vector back = start(before) - corner, on = end(after) - corner;
  const double a = length(back), b = length(on);
  const double half = std::sqrt(std::max(0.0, (1 + dot(back, on) / (a * b)) / 2));
  double farthest = 0;
  for (const Point& p : corners_of(box)) farthest = std::max(farthest, length(p - corner));
  if (!(half > kMargin) || farthest > std::min(a, b) * half * (1 - std::sqrt(kMargin)))
    return false;
  search.is_used[before] = search.is_used[after] = true;
  return true;
}

/// Leaves what touches and meets the box in `search`, unless it is settled.
bool HalfDiscRoom::is_settled(const Box& box, const Near& near, Search& search) const {
  const Circle& circle = search.circle;
  if (is_beyond(box, circle.middle, circle.radius * (1 + kMargin))) return true;
  std::vector<std::uint32_t>&sides = search.touching, &discs = search.meeting;
  sides.clear();
  std::copy_if(near.sides.begin(), near.sides.end(), std::back_inserter(sides),
               [&](std::uint32_t s) { return touches(s, box); });
  // Where nothing touches the whole it is inside already.
  if (sides.empty() && !near.sides.empty() && !is_inside(at(box, kTrials[0]))) return true;
  discs.clear();
  std::copy_if(near.discs.begin(), near.discs.end(), std::back_inserter(discs), [&](auto d) {
    return !is_beyond(box, search.discs[d].middle, search.discs[d].radius * (1 + kMargin));
  });
  const bool cuts = keeps_left(box, sides);
  const auto corners = corners_of(box);
  for (const std::uint32_t d : discs) {
    Disc& disc = search.discs[d];
    const Point a = start(disc.side), b = end(disc.side);
    if (!std::all_of(corners.begin(), corners.end(),
                     [&](const Point& p) { return is_seen_bluntly(a, p, b); }))
      continue;
    const auto is_kept_left = [&](std::uint32_t wall) {
      return is_left(box, wall) ||
             (cuts && std::find(sides.begin(), sides.end(), wall) != sides.end());
    };
    if (!is_kept_left(disc.side)) continue;
    if (!disc.walls) {
      if (search.discs_left == 0) continue;
      --search.discs_left;
      disc.walls = walls_of(disc);
    }
    if (!std::all_of(disc.walls->begin(), disc.walls->end(), is_kept_left)) continue;
    search.is_used[disc.side] = true;
    return true;
  }
  return cuts && corner_is_covered(box, sides, search);
}

HalfDiscRoom::Room HalfDiscRoom::within_circle(const std::array<Point, 3>& corners,
                                               std::size_t most,
                                               std::span<const std::uint32_t> first) const {
  Room room;
  Search search = begin(corners, first);
  if (!std::isfinite(search.circle.radius)) return room;
  Level level, next;
  const Range all_sides = append(level.lists, first_numbers(sides_.size()));
  level.cells.push_back(
      {search.box, all_sides, append(level.lists, first_numbers(search.discs.size()))});
  std::size_t left = std::clamp(kMostWork / sides_.size(), kLeastBoxes, kMostBoxes);
  for (int depth = 0; depth <= kLevels; ++depth) {
    room.places.clear();
    next.clear();
    for (const auto& [box, sides, discs] : level.cells) {
      if (left == 0) return room;
      --left;
      if (is_settled(box, {part(level.lists, sides), part(level.lists, discs)}, search)) continue;
      if (depth >= kFirstLevel || most == 0) {
        for (const auto& share : std::span(kTrials).first(most == 0 ? 1 : kTrials.size())) {
          if (!is_place(at(box, share), search)) continue;
          room.places.push_back(at(box, share));
          break;
        }
        if (most == 0 && !room.places.empty()) return room;
      }
      const Range touching = append(next.lists, search.touching);
      const Range meeting = append(next.lists, search.meeting);
      const Point m = midpoint(box.low, box.high);
      for (const Box& quarter : {Box{box.low, m}, Box{{m.x, box.low.y}, {box.high.x, m.y}},
                                 Box{{box.low.x, m.y}, {m.x, box.high.y}}, Box{m, box.high}})
        next.cells.push_back({quarter, touching, meeting});
    }
    if (next.cells.empty()) {
      room.is_none = true;
      for (std::uint32_t s = 0; s < sides_.size(); ++s) {
        if (search.is_used[s]) room.sides.push_back(s);
      }
      return room;
    }
    if ((most > 0 && room.places.size() >= most) || next.cells.size() > kMostBoxes) break;
    std::swap(level, next);
  }
  return room;
}

}  // namespace cover
