// The triangle on the side ab has its apex at p. Boxes of the angles at a and b are quadrilaterals
// of the plane, and near a or b they are as fine as anywhere. A box is out if one of the following
// holds for all of it (docs/limits.md has the proofs):
//
//   - an angle of the triangle is out of the range, or leaves less than the least one to the rest
//     of a corner;
//   - the triangle contains an input vertex, or its edges cross a side (shadow);
//   - p lies in the clear zone of a side (zone): that would force an angle above `most`;
//   - a vertex w joined to a and beyond the edge ap sees that edge under more than `most` (wedge);
//   - in coupled meshes, the apex sees a free side under more than 90 degrees or under less than
//     some vertex does, or p lies so near to a corner's vertex that the half discs of its sides
//     hold it (around);
//   - from ap to the next side at a lengths would have to grow faster than triangles with such
//     angles can, or a vertex beyond ap is so near that one of them would contain it.
//
// All of these sets are convex, so four corners tell. Each test leaves room for many times
// the rounding of what it compares, so the search is a proof. The apex that is the other end of the
// next side (an ear) leaves no rest of a corner and is looked at by itself.
// Tested by tests/unit/limits/angles/limit_prover_test.cpp.
#include "limits/angles/apex_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geom/cotangent.hpp"

namespace cover {
namespace {

constexpr std::size_t kTriangles = 24;  ///< around a side, whose sides are obstacles
constexpr double kLargeBox = 0.3;       ///< in radians: its lower half is looked at first
constexpr double kRounding = 1e-13;     ///< relative: of places in the frame, with room to spare
constexpr double kFlat = 1e-6;  ///< an apex under less is too far away for its place to be known

double angle_of(double x, double y) { return std::atan2(y, x); }

}  // namespace

ApexSearch::Direction ApexSearch::direction_of(double angle) {
  return {angle, std::sin(angle), std::cos(angle)};
}

ApexSearch::ApexSearch(const RegionView& view, ClearZones& zones, const FanGrowth& growth,
                       double smallest_box)
    : view_(view),
      zones_(zones),
      growth_(growth),
      smallest_box_(smallest_box),
      range_(growth.range()),
      minds_ending_(zones.meshes() == Meshes::coupled && range_.least > 0),
      cot_(cot_of(zones.angle())),
      reach_(direction_of(std::numbers::pi - range_.least + kAngleSlack)) {}

ApexSearch::Place ApexSearch::local(std::uint32_t v) const {
  if (v == ends_[0]) return {0, 0, kRounding};
  if (v == ends_[1]) return {1, 0, kRounding};
  const Vector w = view_.point(v) - origin_;
  const double x = dot(w, along_) / length_, y = cross(along_, w) / length_;
  return {x, y, kRounding * (1 + std::abs(x) + std::abs(y))};
}

void ApexSearch::enter(std::uint32_t s) {
  const RegionSide& side = view_.sides()[s];
  ends_ = {side.a, side.b};
  origin_ = view_.point(side.a);
  const Vector v = view_.point(side.b) - origin_;
  length_ = length(v);
  along_ = (1 / length_) * v;
  const RegionCorner &start = view_.corner(side.start), &end = view_.corner(side.end);
  enter_end(a_, start, false);
  enter_end(b_, end, true);
  is_triangle_ = start.last - start.first == 2 && end.last - end.first == 2 &&
                 view_.seen_from(start).back().vertex == view_.seen_from(end).front().vertex;
  const auto apex_of = [this](const RegionSide& of) {
    return apex_range(of, range_, zones_.meshes());
  };
  apex_ = apex_of(side);
  if (zones_.meshes() == Meshes::coupled)
    reach_ = direction_of(std::numbers::pi - apex_.least + kAngleSlack);
  if (minds_ending_) {
    a_.next_side = {apex_of(view_.sides()[start.before])};
    b_.next_side = {apex_of(view_.sides()[side.end])};
  }
  collect_obstacles(side);
  lonely_.clear();
  if (zones_.meshes() == Meshes::coupled) collect_lonely();
}

void ApexSearch::enter_end(End& end, const RegionCorner& corner, bool reversed) {
  const auto seen = view_.seen_from(corner);
  end.corner = corner.angle;
  end.seen.clear();
  end.direction.clear();
  end.distance.clear();
  for (std::size_t k = 1; k < seen.size(); ++k) {
    const Sighted& w = reversed ? seen[seen.size() - 1 - k] : seen[k];
    end.seen.push_back(local(w.vertex));
    end.direction.push_back(reversed ? corner.angle - w.direction : w.direction);
    end.distance.push_back(length(view_.point(w.vertex) - view_.point(corner.vertex)) / length_);
  }
}

void ApexSearch::collect_obstacles(const RegionSide& side) {
  const Triangulation& cdt = view_.cdt();
  vertices_.clear();
  obstacles_.clear();
  visited_.assign(1, side.triangle);
  is_visited_.resize(cdt.triangles.size());
  is_visited_.clear();
  is_visited_.insert(side.triangle);
  for (std::size_t k = 0; k < visited_.size(); ++k) {
    const Triangle& f = cdt.triangles[visited_[k]];
    for (const Corner i : kCorners) {
      const std::uint32_t s = view_.side_at(visited_[k], i);
      if (s == kNone) {
        const std::uint32_t next = f.n[i];
        if (visited_.size() < kTriangles && !is_visited_.contains(next)) {
          is_visited_.insert(next);
          visited_.push_back(next);
          const Triangle& g = cdt.triangles[next];
          const std::uint32_t beyond = g.v[g.edge_to(visited_[k])];
          vertices_.push_back({local(beyond), beyond});
        }
        continue;
      }
      const RegionSide& other = view_.sides()[s];
      const ClearZones::State& zone = zones_.of(s);
      obstacles_.push_back({local(other.a),
                            local(other.b),
                            {},
                            {},
                            zone.cot,
                            zone.clear,
                            zone.cut_at_start,
                            zone.cut_at_end,
                            false,
                            false});
      Obstacle& o = obstacles_.back();
      if (zone.cut_at_start)
        o.before = local(view_.seen_from(view_.corner(other.start)).back().vertex);
      if (zone.cut_at_end) o.after = local(view_.seen_from(view_.corner(other.end)).front().vertex);
      const double ux = o.d.x - o.c.x, uy = o.d.y - o.c.y;
      const double at_a = uy * o.c.x - ux * o.c.y, at_b = at_a - uy;
      const double room = 8 * (o.c.fuzz + o.d.fuzz) * (1 + std::abs(ux) + std::abs(uy));
      o.faces_a = at_a > room;
      o.faces_b = at_b > room;
    }
  }
  const std::uint32_t apex = cdt.triangles[side.triangle].v[side.edge];
  vertices_.push_back({local(apex), apex});
  last_ban_ = Ban::zone;
  last_which_ = 0;
}

/// These vertices are tried as apices by themselves, so that places around them may be forbidden.
void ApexSearch::collect_lonely() {
  for (const Vertex& v : vertices_) {
    const std::uint32_t corner = view_.only_corner_of(v.number);
    const double reach = corner == kNone ? 0 : zones_.around(corner) / length_;
    if (reach > 0) lonely_.push_back({v.place, reach});
  }
}

bool ApexSearch::angles_are_in_range(double x, double y, double z) const {
  return std::min({x, y, z}) >= range_.least - kAngleSlack &&
         std::max({x, y, z}) <= range_.most + kAngleSlack;
}

bool ApexSearch::reaches_next(const End& end, double low, double high, double near,
                              double far) const {
  const double next = end.distance.back();
  return growth_.may_lead(low, high, std::max(next / far, near / next));
}

bool ApexSearch::ear_is_possible(bool at_a) const {
  const End &near = at_a ? a_ : b_, &far = at_a ? b_ : a_;
  if (near.corner >= std::numbers::pi - kAngleSlack) return false;
  const Place& p = near.seen.back();
  if (!(p.y > 0)) return false;
  const double alpha = angle_of(p.x, p.y), beta = angle_of(1 - p.x, p.y);
  if (!angles_are_in_range(alpha, beta, std::numbers::pi - alpha - beta) ||
      !apex_is_allowed(alpha + beta, alpha + beta))
    return false;
  if (is_triangle_) return true;
  // The rest of the other corner.
  const double rest = far.corner - (at_a ? beta : alpha);
  const double edge = std::hypot(p.x - (at_a ? 1 : 0), p.y);
  return reaches_next(far, rest - kAngleSlack, rest + kAngleSlack, edge, edge);
}

/// Whether an input vertex may be the apex. Ears are looked at by themselves.
bool ApexSearch::some_vertex_is_possible(const RegionSide& side) const {
  const std::uint32_t before = view_.sides()[view_.corner(side.start).before].a;
  const std::uint32_t after = view_.sides()[side.end].b;
  return std::any_of(vertices_.begin(), vertices_.end(), [&](const Vertex& v) {
    return v.number != before && v.number != after && vertex_is_possible(v.place);
  });
}

bool ApexSearch::vertex_is_possible(const Place& p) const {
  if (!(p.y > 0)) return false;
  // Few see the side under enough for an apex: a comparison of cotangents.
  const double room = 8 * p.fuzz * (1 + std::abs(p.x) + std::abs(p.y));
  if ((p.x * (p.x - 1) + p.y * p.y) * reach_.sine + reach_.cosine * p.y > room) return false;
  const double alpha = angle_of(p.x, p.y), beta = angle_of(1 - p.x, p.y);
  if (!angles_are_in_range(alpha, beta, std::numbers::pi - alpha - beta) ||
      !apex_is_allowed(alpha + beta, alpha + beta))
    return false;
  const double to_a = std::hypot(p.x, p.y), to_b = std::hypot(1 - p.x, p.y);
  return !end_is_out(a_, alpha, alpha, to_a, to_a) && !end_is_out(b_, beta, beta, to_b, to_b);
}

/// Whether the apex may have an angle that leaves `low` to `high` for the ends of the side.
bool ApexSearch::apex_is_allowed(double low, double high) const {
  return high >= std::numbers::pi - apex_.most - kAngleSlack &&
         low <= std::numbers::pi - apex_.least + kAngleSlack;
}

bool ApexSearch::is_in_wedge(const Place& at, double turn, const Place& w, const Place& p) const {
  // w is beyond the ray from `at` to p, and the angle at w between the two is above most.
  const double ux = at.x - w.x, uy = at.y - w.y, vx = p.x - w.x, vy = p.y - w.y;
  const double c = turn * (ux * vy - uy * vx), d = ux * vx + uy * vy;
  if (!(c > 0) || !(d < cot_ * c)) return false;
  const double room =
      (p.fuzz + w.fuzz) * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy));
  return c > room && d - cot_ * c < -room * (1 + std::abs(cot_));
}

template <ApexSearch::Ban ban>
bool ApexSearch::is_in(std::size_t which, const Place& p) const {
  const auto left_of = [&p](const Place& c, const Place& d, double turn) {
    const double ux = d.x - c.x, uy = d.y - c.y, vx = p.x - c.x, vy = p.y - c.y;
    return turn * (ux * vy - uy * vx) >
           (p.fuzz + c.fuzz + d.fuzz) * (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy));
  };
  if constexpr (ban == Ban::wedge_at_a) {
    return is_in_wedge({0, 0, 0}, 1, a_.seen[which], p);
  } else if constexpr (ban == Ban::wedge_at_b) {
    return is_in_wedge({1, 0, 0}, -1, b_.seen[which], p);
  } else if constexpr (ban == Ban::around) {
    const Lonely& vertex = lonely_[which];
    const double room = vertex.reach - p.fuzz - vertex.place.fuzz;
    const double x = p.x - vertex.place.x, y = p.y - vertex.place.y;
    return room > 0 && x * x + y * y < room * room;
  } else if constexpr (ban == Ban::zone) {
    const Obstacle& o = obstacles_[which];
    if (!o.has_zone) return false;
    const double ux = o.c.x - p.x, uy = o.c.y - p.y, vx = o.d.x - p.x, vy = o.d.y - p.y;
    const double c = ux * vy - uy * vx, d = ux * vx + uy * vy;
    if (!(c > 0) || !(d < o.cot * c)) return false;
    const double room = (p.fuzz + o.c.fuzz + o.d.fuzz) *
                        (std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy));
    return c > room && d - o.cot * c < -room * (1 + std::abs(o.cot)) &&
           (!o.cut_at_start || left_of(o.before, o.c, 1)) &&
           (!o.cut_at_end || left_of(o.d, o.after, 1));
  } else {
    const Obstacle& o = obstacles_[which];
    if (!(ban == Ban::shadow_of_a ? o.faces_a : o.faces_b)) return false;
    const Place from{ban == Ban::shadow_of_a ? 0.0 : 1.0, 0, kRounding};
    return left_of(o.c, o.d, -1) && left_of(from, o.c, 1) && left_of(from, o.d, -1);
  }
}

bool ApexSearch::is_tip_of_zone(std::size_t which, const Place& p) const {
  // A zone is convex and has the ends of its side on its rim. So a triangle that has one of them as
  // corner lies in the zone, but for that, if both other corners do.
  if (p.y != 0 || !obstacles_[which].has_zone) return false;
  const Obstacle& o = obstacles_[which];
  const double end = p.x < 0.5 ? 0 : 1;
  return (o.d.x == end && o.d.y == 0) || (o.c.x == end && o.c.y == 0);
}

template <ApexSearch::Ban ban>
bool ApexSearch::are_in(std::size_t which, std::span<const Place> corners) {
  for (const Place& p : corners) {
    if (is_in<ban>(which, p)) continue;
    if (ban != Ban::zone || !is_tip_of_zone(which, p)) return false;
  }
  last_ban_ = ban;
  last_which_ = which;
  return true;
}

bool ApexSearch::are_in_last(std::span<const Place> corners) {
  switch (last_ban_) {
    case Ban::zone:
      return !obstacles_.empty() && are_in<Ban::zone>(last_which_, corners);
    case Ban::around:
      return are_in<Ban::around>(last_which_, corners);
    case Ban::shadow_of_a:
      return are_in<Ban::shadow_of_a>(last_which_, corners);
    case Ban::shadow_of_b:
      return are_in<Ban::shadow_of_b>(last_which_, corners);
    case Ban::wedge_at_a:
      return are_in<Ban::wedge_at_a>(last_which_, corners);
    case Ban::wedge_at_b:
      return are_in<Ban::wedge_at_b>(last_which_, corners);
  }
  return false;
}

bool ApexSearch::is_banned(std::span<const Place> corners) {
  if (are_in_last(corners)) return true;
  const Place& p = corners.front();
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    // Zones are on the left of their side and shadows on its right: one corner tells which to ask.
    // An end of the side itself is the tip of some.
    const Obstacle& o = obstacles_[k];
    const double ux = o.c.x - p.x, uy = o.c.y - p.y, vx = o.d.x - p.x, vy = o.d.y - p.y;
    const double c = ux * vy - uy * vx;
    if ((p.y == 0 || (c > 0 && ux * vx + uy * vy < o.cot * c)) && are_in<Ban::zone>(k, corners))
      return true;
    if (!(c > 0) && (are_in<Ban::shadow_of_a>(k, corners) || are_in<Ban::shadow_of_b>(k, corners)))
      return true;
  }
  for (std::size_t k = 0; k < lonely_.size(); ++k) {
    if (are_in<Ban::around>(k, corners)) return true;
  }
  for (std::size_t k = 0; k < a_.seen.size(); ++k) {
    if (are_in<Ban::wedge_at_a>(k, corners)) return true;
  }
  for (std::size_t k = 0; k < b_.seen.size(); ++k) {
    if (are_in<Ban::wedge_at_b>(k, corners)) return true;
  }
  return false;
}

bool ApexSearch::contains_vertex(const Box& box) const {
  // All triangles of the box contain that of its two smallest angles.
  for (const Vertex& v : vertices_) {
    const Place& w = v.place;
    if (!(w.y > w.fuzz)) continue;
    if (w.x * box.a[0].sine - w.y * box.a[0].cosine > 4 * w.fuzz &&
        (1 - w.x) * box.b[0].sine - w.y * box.b[0].cosine > 4 * w.fuzz)
      return true;
  }
  return false;
}

bool ApexSearch::end_is_out(const End& end, double low, double high, double near,
                            double far) const {
  // `low` to `high`: the angle at this end; `near` to `far`: the length of the new edge.
  const double rest_low = end.corner - high, rest_high = end.corner - low;
  if (!reaches_next(end, rest_low - kAngleSlack, rest_high + kAngleSlack, near, far)) return true;
  if (range_.least == 0) return false;
  if (minds_ending_ &&
      !growth_.may_end(rest_low - kAngleSlack, rest_high + kAngleSlack, end.distance.back() / far,
                       end.distance.back() / near, end.next_side))
    return true;
  for (std::size_t k = 0; k < end.seen.size(); ++k) {
    const double beyond = end.direction[k] - low;
    if (end.direction[k] < high + kAngleSlack || beyond > std::numbers::pi / 2) continue;
    if (end.distance[k] < near &&
        end.distance[k] < near * growth_.least_reach(beyond) * (1 - kAngleSlack))
      return true;
  }
  return false;
}

/// The apex with these angles, and its distances from the ends of the side.
ApexSearch::Place ApexSearch::place_of(const Direction& a, const Direction& b, double& to_a,
                                       double& to_b) {
  const double inverse = 1 / (a.sine * b.cosine + a.cosine * b.sine);
  to_a = b.sine * inverse;
  to_b = a.sine * inverse;
  if (b.sine == 0 && a.sine > 0) return {0, 0, 0};
  if (a.sine == 0 && b.sine > 0) return {1, 0, 0};
  return {to_a * a.cosine, to_a * a.sine, kRounding * (1 + to_a) * inverse};
}

void ApexSearch::add_corner(Shape& shape, const Direction& a, const Direction& b) {
  double to_a = 0, to_b = 0;
  shape.corners[shape.count++] = place_of(a, b, to_a, to_b);
  shape.near_a = std::min(shape.near_a, to_a);
  shape.far_a = std::max(shape.far_a, to_a);
  shape.near_b = std::min(shape.near_b, to_b);
  shape.far_b = std::max(shape.far_b, to_b);
}

ApexSearch::Shape ApexSearch::shape_of(const Box& box) {
  Shape shape;
  for (std::size_t k = 0; k < 4; ++k) add_corner(shape, box.a[k & 1], box.b[k >> 1]);
  return shape;
}

/// Of a box that reaches beyond where the angle at the apex is the least one: what is on this side,
/// a piece of a disk. Its arc lies within the tangents at both of its ends. Without this, a box
/// would have to be cut along all of the arc. False if the arc is too long for that.
bool ApexSearch::add_corners_within_reach(const Box& box, Shape& shape) const {
  // The other angle, where one is given and their sum is that of the arc.
  const auto rest = [this](const Direction& angle) {
    return Direction{reach_.angle - angle.angle,
                     reach_.sine * angle.cosine - reach_.cosine * angle.sine,
                     reach_.cosine * angle.cosine + reach_.sine * angle.sine};
  };
  const auto& [a, b] = box;
  if (rest(b[0]).angle <= a[0].angle) return false;
  const bool low_a = a[1].angle + b[0].angle <= reach_.angle;
  const bool low_b = a[0].angle + b[1].angle <= reach_.angle;
  add_corner(shape, a[0], b[0]);
  if (low_a) add_corner(shape, a[1], b[0]);
  if (low_b) add_corner(shape, a[0], b[1]);
  // The ends of the arc.
  const Direction first_a = low_a ? a[1] : rest(b[0]), first_b = low_a ? rest(a[1]) : b[0];
  const Direction last_a = low_b ? rest(b[1]) : a[0], last_b = low_b ? b[1] : rest(a[0]);
  if (!(first_b.sine > 0) || !(last_a.sine > 0)) return false;
  add_corner(shape, first_a, first_b);
  add_corner(shape, last_a, last_b);
  const Place p = shape.corners[shape.count - 2], q = shape.corners[shape.count - 1];
  const double height = -reach_.cosine / (2 * reach_.sine), radius = 1 / (2 * reach_.sine);
  const double x = (p.x + q.x) / 2 - 0.5, y = (p.y + q.y) / 2 - height;  // from the centre
  const double squared = x * x + y * y;
  if (!(squared > radius * radius / 4)) return false;
  const double beyond = radius * radius / squared * (1 + kAngleSlack);
  shape.corners[shape.count++] = {0.5 + beyond * x, height + beyond * y, p.fuzz + q.fuzz};
  // Along the arc a distance is largest where the angle opposite is a right one.
  const double right = std::numbers::pi / 2;
  if (first_b.angle < right && last_b.angle > right) shape.far_a = 2 * radius;
  if (last_a.angle < right && first_a.angle > right) shape.far_b = 2 * radius;
  return true;
}

bool ApexSearch::is_out(const Box& box) {
  const double sum_low = box.a[0].angle + box.b[0].angle;
  const double sum_high = box.a[1].angle + box.b[1].angle;
  if (!apex_is_allowed(sum_low, sum_high)) return true;
  if (contains_vertex(box)) return true;
  Shape shape;
  const bool is_within_reach =
      sum_high > reach_.angle && range_.least > 0 && add_corners_within_reach(box, shape);
  if (!is_within_reach && sum_high > std::numbers::pi - kFlat) {
    // From a sum of 90 degrees on, the nearest apex is that of the smallest angles.
    if (sum_low < std::numbers::pi / 2 || sum_low > std::numbers::pi - kFlat / 2)
      return sum_low > std::numbers::pi / 2;
    const double sine = std::sin(sum_low) + kRounding;
    return std::min(box.a[0].sine, box.b[0].sine) > sine * view_.diameter() / length_;
  }
  if (!is_within_reach) shape = shape_of(box);
  if (is_banned(shape.all())) return true;
  // The lengths sin b / sin (a + b) and sin a / sin (a + b) have their extremes at the corners,
  // but for the least ones where a + b passes 90 degrees: there sin (a + b) is 1.
  if (sum_low < std::numbers::pi / 2 && sum_high > std::numbers::pi / 2) {
    shape.near_a = std::min({shape.near_a, box.b[0].sine, box.b[1].sine});
    shape.near_b = std::min({shape.near_b, box.a[0].sine, box.a[1].sine});
  }
  return end_is_out(a_, box.a[0].angle, box.a[1].angle, shape.near_a, shape.far_a) ||
         end_is_out(b_, box.b[0].angle, box.b[1].angle, shape.near_b, shape.far_b);
}

/// As is_out() of a box that is one place, whose four corners are the same.
bool ApexSearch::nothing_forbids(const Direction& at_a, const Direction& at_b) {
  const double sum = at_a.angle + at_b.angle;
  if (sum >= std::numbers::pi - kFlat || !apex_is_allowed(sum, sum) ||
      contains_vertex({{at_a, at_a}, {at_b, at_b}}))
    return false;
  double to_a = 0, to_b = 0;
  const Place place = place_of(at_a, at_b, to_a, to_b);
  return !is_banned({&place, 1}) && !end_is_out(a_, at_a.angle, at_a.angle, to_a, to_a) &&
         !end_is_out(b_, at_b.angle, at_b.angle, to_b, to_b);
}

/// A place in the box, half way on its diagonal through what the range allows at the apex. With the
/// middle, searches would follow the arc where that angle is largest, down to the smallest boxes.
std::array<ApexSearch::Direction, 2> ApexSearch::probed_in(const Box& box) const {
  const double low = box.a[0].angle + box.b[0].angle, high = box.a[1].angle + box.b[1].angle;
  const double from = std::max(low, std::numbers::pi - apex_.most);
  const double to = std::min(high, std::numbers::pi - apex_.least);
  const double share = std::clamp(((from + to) / 2 - low) / (high - low), 0.0, 1.0);
  return {direction_of(box.a[0].angle + share * (box.a[1].angle - box.a[0].angle)),
          direction_of(box.b[0].angle + share * (box.b[1].angle - box.b[0].angle))};
}

bool ApexSearch::has_none(std::uint32_t side, std::uint64_t& budget) {
  enter(side);
  if (ear_is_possible(true) || ear_is_possible(false)) return false;
  if (is_triangle_) return true;
  if (!lonely_.empty() && some_vertex_is_possible(view_.sides()[side])) return false;
  const double least = range_.least;
  const double most_a = std::min({range_.most, std::numbers::pi - 2 * least, a_.corner - least});
  const double most_b = std::min({range_.most, std::numbers::pi - 2 * least, b_.corner - least});
  if (most_a < least - kAngleSlack || most_b < least - kAngleSlack) return true;
  const auto direction = direction_of;
  if (nothing_forbids(direction(std::numbers::pi / 3), direction(std::numbers::pi / 3)))
    return false;
  const double from = std::max(0.0, least - kAngleSlack);
  stack_.assign(1, {{direction(from), direction(most_a + kAngleSlack)},
                    {direction(from), direction(most_b + kAngleSlack)}});
  std::uint32_t looked = 0;
  while (!stack_.empty()) {
    if (budget == 0) return false;
    --budget;
    const Box box = stack_.back();
    stack_.pop_back();
    if (is_out(box)) continue;
    const double wide = box.a[1].angle - box.a[0].angle, high = box.b[1].angle - box.b[0].angle;
    if (std::max(wide, high) < smallest_box_) return false;
    const bool cut_a = wide > high;
    const Direction middle = direction(cut_a ? (box.a[0].angle + box.a[1].angle) / 2
                                             : (box.b[0].angle + box.b[1].angle) / 2);
    // A place that nothing forbids ends the search at once.
    const auto [at_a, at_b] = probed_in(box);
    if (nothing_forbids(at_a, at_b)) return false;
    Box first = box, second = box;
    (cut_a ? first.a : first.b)[1] = middle;
    (cut_a ? second.a : second.b)[0] = middle;
    // Always the lower half first would follow the border of what is forbidden, outside of which
    // the places lie that are probed.
    if (std::max(wide, high) < kLargeBox && (++looked & 2) == 0) std::swap(first, second);
    stack_.push_back(second);
    stack_.push_back(first);
  }
  return true;
}

}  // namespace cover
