// One number per triangle: how far its angles are from what is wanted, and possible.
//
// Everything is kept in cotangents, cot(angle) = (u.v) / (u x v): no square root, no arc tangent,
// and u x v is twice the area at all three corners. With c the least and C the largest cotangent,
//     excess = max(-c - large,  weight (C - small)),
// <= 0 where the triangle meets both targets. `weight` = min / (180 - max) makes a small angle
// x count like the large angle 180 - x / weight does far from the targets, as q in
// "max(largest, 180 - f smallest)" with f = 1 / weight.
//
// With couplings, a negative coupling of the box method is an excess as well: that of a side
// whose angle opposite is above 90 degrees, cot < 0, and on request that of an inner edge that is
// not locally Delaunay, cot a + cot b < 0.
//
// What the input forces does not count: the angle under which a side is seen at least (Lemma 1),
// the smallest angle that a triangle on a side can have where another side is close
// (side_limit.hpp), and a corner between two sides, which is the input's own.
#pragma once

#include <algorithm>
#include <array>

#include <cover/angle.hpp>
#include <cover/point.hpp>

#include "base/numbers.hpp"
#include "geom/topology/corner.hpp"

namespace cover {

/// How much worse than the goal the triangle on a side may be without blame, in cotangents.
struct Allowance {
  double large = 0;  ///< at the corner opposite to the side
  double small = 0;  ///< at any corner
  /// The least cotangent at the corner opposite to the side that is no fault of couplings.
  double least_cot = -kInfinity;
  /// Below this the triangle counts as inverted.
  double lowest_cot = -kInfinity;

  bool operator==(const Allowance&) const = default;
};

/// What the sides of a triangle allow, by the corner opposite to them; null: that edge is none.
using SideAllowances = std::array<const Allowance*, 3>;

/// Whether corner i lies between two sides: its angle is the input's own, and never too small.
inline bool is_between_sides(const SideAllowances& sides, Corner i) {
  return sides[i.next()] != nullptr && sides[i.previous()] != nullptr;
}

/// By how much the angle opposite to this edge may exceed the goal; null: it is no side.
inline double allowed_large(const Allowance* side) { return side != nullptr ? side->large : 0; }
/// By how much the smallest angle beside this edge may miss the goal, whichever corner it is at.
inline double allowed_small(const Allowance* side) { return side != nullptr ? side->small : 0; }
/// The same of a triangle: what the side that leaves the least room allows.
inline double allowed_small(const SideAllowances& sides) {
  return std::max({allowed_small(sides[0]), allowed_small(sides[1]), allowed_small(sides[2])});
}

/// What negative couplings count for, beside angles.
struct CouplingGoal {
  double weight = 0;    ///< of what a sum of cotangents lacks; 0: couplings do not count
  bool inside = false;  ///< inner edges count too, not only sides
  bool strict = false;  ///< a negative one on an inner edge counts like an inverted triangle
  /// -cot of an angle. Larger ones weigh more than any coupling.
  double bound = kInfinity;
  /// Where strict, a star replaces all that is in the way of its vertex. (Not beside layers, whose
  /// couplings with the rest of the region are not those of its sides.)
  bool takes_whole_cavities = true;
  bool operator==(const CouplingGoal&) const = default;
};

/// The targets for all triangles.
struct Goal {
  double large = 0;   ///< -cot of the largest angle wanted
  double small = 0;   ///< cot of the smallest angle wanted
  double weight = 0;  ///< of the smallest angle; 0: it does not count
  CouplingGoal coupling{};

  /// REQUIRES: max in (60, 180) degrees, min in [0, 60)
  static Goal of(Angle max, Angle min);
  /// Other angles, the same couplings.
  [[nodiscard]] Goal with(double new_large, double new_small, double new_weight) const {
    return {new_large, new_small, new_weight, coupling};
  }
  /// Whether the targets are the same, whatever couplings count for.
  [[nodiscard]] bool has_same_angles(const Goal& other) const {
    return large == other.large && small == other.small && weight == other.weight;
  }
  bool operator==(const Goal&) const = default;
};

/// What is wanted of the corner opposite to this edge: the goal, raised by what the side allows.
inline double wanted_large(const Goal& goal, const Allowance* side) {
  return goal.large + allowed_large(side);
}
/// What is wanted of the smallest angle of a triangle with these sides.
inline double wanted_small(const Goal& goal, const SideAllowances& sides) {
  return goal.small + allowed_small(sides);
}

/// Sums of cotangents below this count as negative couplings while a mesh is made, so that none is
/// negative after rounding: 0.03 degrees.
inline constexpr double kLeastCoupling = 5e-4;
/// Weights that put couplings before all targets, and the bound before couplings: sums below zero
/// count for more than any angle up to 153 degrees.
inline constexpr double kCouplingFirst = 4e3, kBoundFirst = 2e5;

/// Times the weight of small angles where large ones come first: then they decide only between
/// equals.
inline constexpr double kLightWeight = 1e-4;
/// How far below the goal a trial aims, in cotangents (0.3 degrees): ties between large and small
/// angles would end just above it.
inline constexpr double kAimBelow = 0.005;
/// Cotangents closer than this, relative to 1 or to their size, are equal: rounding.
inline constexpr double kSameCot = 1e-9;

/// Whether the angle with this cotangent is below the one whose cotangent is `small`.
inline bool is_sharper(double cot, double small) { return cot > small * (1 + kSameCot); }

/// Excess of a triangle without area, or clockwise.
inline constexpr double kInverted = kInfinity;

/// Dot products at the corners and twice the area.
struct Corners {
  double dot[3];
  double cross;
  Corners(Point a, Point b, Point c) {
    const double ux = b.x - a.x, uy = b.y - a.y;
    const double vx = c.x - b.x, vy = c.y - b.y;
    const double wx = a.x - c.x, wy = a.y - c.y;
    dot[0] = -(ux * wx + uy * wy);
    dot[1] = -(ux * vx + uy * vy);
    dot[2] = -(vx * wx + vy * wy);
    cross = ux * vy - uy * vx;
  }
};

/// The excess of a triangle none of whose edges is a side.
inline double excess(const Goal& goal, const Corners& k) {
  if (!(k.cross > 0)) return kInverted;
  const double least = std::min({k.dot[0], k.dot[1], k.dot[2]});
  const double most = std::max({k.dot[0], k.dot[1], k.dot[2]});
  return std::max(-least - goal.large * k.cross, goal.weight * (most - goal.small * k.cross)) /
         k.cross;
}
inline double excess(const Goal& goal, Point a, Point b, Point c) {
  return excess(goal, Corners(a, b, c));
}

/// The excess of a triangle with sides. `sides[i]` belongs to the edge opposite to corner i, null
/// where that edge is no side.
double excess(const Goal& goal, const Corners& k, const SideAllowances& sides);
inline double excess(const Goal& goal, Point a, Point b, Point c, const SideAllowances& sides) {
  return excess(goal, Corners(a, b, c), sides);
}

}  // namespace cover
