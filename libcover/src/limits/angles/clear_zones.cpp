// The walk passes from the side's triangle through all edges that come into the disk whose arc is
// the zone's, above the side; a side among them ends it unless it is the one before or after.
// Tested by tests/unit/limits/angles/limit_prover_test.cpp.
#include "limits/angles/clear_zones.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "geom/cotangent.hpp"
#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// Above `most`, so that a vertex or a side just on the arc does not matter.
constexpr double kZoneSlack = 1e-7;
/// Regions that bend inwards by so little, times what that changes in angles, count as convex.
constexpr double kAlmostConvex = 1e-3;
constexpr double kLeastMost = 95 * kDegree;  ///< where they do
constexpr std::size_t kMostTriangles = 64;   ///< that a walk visits before it gives up
constexpr std::size_t kMostAround = 64;      ///< sides that a corner's neighbourhood is asked of

/// By how much more than `most` a side must be seen so that, in a region that is almost convex,
/// some input vertex sees it under more than `most`, if the one in question does not see it:
/// infinite if that cannot be told (docs/limits.md).
double slack_of_bend(double bend, double most) {
  if (bend == 0) return 0;
  const double slack = 2.1 * bend * std::tan(std::numbers::pi - most);
  return most > kLeastMost && slack < kAlmostConvex ? slack : kInfinity;
}

}  // namespace

ClearZones::ClearZones(const RegionView& view, double most, Meshes meshes)
    : view_(view),
      meshes_(meshes),
      slack_of_bend_(slack_of_bend(view.bend(), most)),
      angle_(most + kZoneSlack + (std::isfinite(slack_of_bend_) ? slack_of_bend_ : 0)),
      state_(view.sides().size()) {
  if (meshes == Meshes::coupled) around_.assign(view.sides().size(), -1);
}

const ClearZones::State& ClearZones::of(std::uint32_t side) {
  if (!state_[side].known) state_[side] = find_out(view_.sides()[side]);
  return state_[side];
}

ClearZones::State ClearZones::find_out(const RegionSide& side) {
  const auto whole = [](double angle) { return State{true, true, false, false, cot_of(angle)}; };
  constexpr double kRight = std::numbers::pi / 2 + kZoneSlack;
  if (meshes_ == Meshes::coupled && side.is_free && angle_ > kRight) {
    if (view_.bend() == 0) return whole(kRight);
    const State half_disc = walk(side, kRight);
    if (half_disc.clear) return half_disc;
  }
  return std::isfinite(slack_of_bend_) ? whole(angle_) : walk(side, angle_);
}

ClearZones::State ClearZones::walk(const RegionSide& side, double angle) {
  const Triangulation& cdt = view_.cdt();
  const Point a = view_.point(side.a);
  const Vector along = view_.point(side.b) - a;
  const double cot = cot_of(angle);
  const double l = length(along), radius = l / (2 * std::sin(angle)) * (1 + kAngleSlack);
  const double middle = l / 2, height = l / 2 * cot;  // of the centre of the disk
  const auto local = [&](std::uint32_t v) {
    const Vector w = view_.point(v) - a;
    return Vector{dot(w, along) / l - middle, cross(along, w) / l - height};
  };
  const auto comes_in = [&](std::uint32_t v, std::uint32_t w) {
    const Vector p = local(v), q = local(w), d = q - p;
    const double low = -height + kAngleSlack * l;
    if (p.y < low && q.y < low) return false;
    if (v == side.a || v == side.b) return dot(d, p) < kAngleSlack * length(d) * length(p);
    if (w == side.a || w == side.b) return dot(d, q) > -kAngleSlack * length(d) * length(q);
    const double t = part_on_segment(d, -1 * p);
    return squared_length(p + t * d) < radius * radius;
  };
  State state{true, false, false, false, cot};
  stack_.assign(1, 4 * std::uint64_t{side.triangle} + side.edge);
  for (std::size_t visited = 0; !stack_.empty(); ++visited) {
    if (visited == kMostTriangles) return state;
    const auto t = static_cast<std::uint32_t>(stack_.back() / 4);
    const Corner entry = static_cast<std::uint32_t>(stack_.back() % 4);
    stack_.pop_back();
    const Triangle& f = cdt.triangles[t];
    for (const Corner i : {entry.next(), entry.previous()}) {
      const std::uint32_t v = f.v[i.next()];
      const std::uint32_t w = f.v[i.previous()];
      if (!comes_in(v, w)) continue;
      if (view_.side_at(t, i) != kNone) {
        if (v == side.b) {
          state.cut_at_end = true;
        } else if (w == side.a) {
          state.cut_at_start = true;
        } else {
          return state;
        }
        continue;
      }
      const std::uint32_t beyond = f.n[i];
      stack_.push_back(4 * std::uint64_t{beyond} + cdt.triangles[beyond].edge_to(t));
    }
  }
  state.clear = true;
  return state;
}

double ClearZones::around(std::uint32_t corner) {
  if (around_.empty()) return 0;
  double& known = around_[corner];
  if (known < 0) known = find_around(view_.corner(corner), view_.sides()[corner]);
  return known;
}

/// A place in the corner, within the half angle of one of its sides, lies in the half disc of that
/// if it is no farther than this from the vertex, and sees it: no other side comes so near, or the
/// region is convex. Then what is beyond the corner is outside of the region, too.
double ClearZones::find_around(const RegionCorner& corner, const RegionSide& after) const {
  const RegionSide& before = view_.sides()[corner.before];
  if (!before.is_free || !after.is_free || corner.angle > std::numbers::pi - kZoneSlack) return 0;
  const Point w = view_.point(corner.vertex);
  double reach = std::min(length(view_.point(before.a) - w), length(view_.point(after.b) - w)) *
                 std::cos(corner.angle / 2);
  if (view_.bend() > 0) {
    if (view_.sides().size() > kMostAround) return 0;
    for (const RegionSide& other : view_.sides()) {
      if (&other == &before || &other == &after) continue;
      reach = std::min(reach, distance_to_segment(w, view_.point(other.a), view_.point(other.b)));
    }
  }
  return reach * (1 - kZoneSlack);
}

}  // namespace cover
