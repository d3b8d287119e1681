// By how much a triangle misses a goal.
#pragma once

#include <cstddef>
#include <cstdint>

#include "quality/fault/fault.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// -cot of 120 degrees: beyond that, triangles count apart.
inline constexpr double kFarAbove = 0.5773502691896258;
/// -cot of 140 degrees: beyond that, each degree is a large part of what is left to 180.
inline constexpr double kVeryFarAbove = 1.1917535925942100;

/// What a triangle has beyond the goal and what its sides allow; all in cotangents. Angles between
/// two sides are the input's own, and none of them counts as small.
struct Shortfall {
  double largest = -kInverted;  ///< -cot of the largest angle
  double large = -kInverted;    ///< that beyond the goal, at the corner where it is most
  double small = -kInverted;    ///< cot of the smallest angle beyond the goal
  bool is_far = false;          ///< an angle above 120 degrees that is not allowed
  Fault fault;                  ///< the same on one scale
  std::size_t negative = 0;     ///< negative couplings that count, those of inner edges once

  [[nodiscard]] bool is_above() const { return large > kSameCot; }
  [[nodiscard]] bool is_below(const Goal& goal) const {
    return goal.weight > 0 && small > kSameCot * goal.small;
  }
};

/// By `goal`, whatever goal the mesh has set.
///
/// REQUIRES: `t` is no hole
Shortfall shortfall_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal);
/// The same without its fault, which needs angles and takes most of the time.
Shortfall cots_short_of(const MutableMesh& mesh, std::uint32_t t, const Goal& goal);

}  // namespace cover
