// Which of two triangulations of a region is better.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cover/options.hpp>

#include "base/team.hpp"
#include "quality/fault/fault.hpp"
#include "quality/fault/shortfall.hpp"
#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// What a triangulation has reached. Angles are cotangents; smaller is better. Order compares them.
struct Merit {
  double target = 0;          ///< -cot of the region's own target: the goal's, or what is forced
  double large = 0;           ///< -cot of the largest angle, no lower than that
  std::size_t above = 0;      ///< triangles with a larger angle than the goal and their sides allow
  std::size_t far_above = 0;  ///< those of them above 120 degrees
  double small = 0;           ///< cot of the smallest angle, no lower than the goal
  std::size_t triangles = 0;

  /// Whether both targets are met by every triangle.
  bool complete = false;

  Fault fault{};           ///< the worst of all triangles
  double sum = 0;          ///< of their faults
  std::size_t missed = 0;  ///< triangles that have one

  std::size_t negative = 0;  ///< couplings that count and are negative

  /// Adds what is wrong with more triangles, which `triangles` and `target` know of already.
  void add(const Merit& more);
};

/// Cost: O(triangles)
Merit merit_of(const MutableMesh& mesh, const Goal& goal, const Team& team = {});

/// Whether triangle `t` has a larger angle than the goal and its sides allow.
bool is_above(const MutableMesh& mesh, std::uint32_t t, const Goal& goal);

/// Whether `a` is smaller than `b`, by more than rounding.
bool is_smaller_cot(double a, double b);

/// Whether `a` is better by Prefer::largest: smaller largest angle, then fewer triangles above 120
/// degrees, then fewer above the goal, then larger smallest angle, then fewer triangles.
///
/// Largest angles are alike, so that the counts decide: those that miss the target by 3 degrees at
/// most, from 120 to 130 degrees, from there to 140, and above where cotangents differ by 2 % at
/// most. For at the optimum two or three triangles share the largest angle, and short of it there
/// may be many.
///
/// REQUIRES: the same targets
bool is_better_by_largest(const Merit& a, const Merit& b);

/// How triangulations of one region are compared.
struct Order {
  Prefer prefer = Prefer::largest;
  /// Faults beyond this count before all else: no number of angles above 120 degrees is worth them.
  /// 5.6 degrees beside a target of 20, or 157.6 beside 100.
  double degenerate = 0.72;
  double bound = kInverted;  ///< -cot of the largest angle that is promised: beyond is worse

  /// Within the bound; with fewer negative couplings, where they count. Then, by Prefer::largest,
  /// is_better_by_largest().
  ///
  /// By Prefer::balanced: the smaller fault if one of them is degenerate; then fewer triangles
  /// above 120 degrees, the smaller fault, fewer triangles that have one, the smaller sum of
  /// faults, fewer triangles. A strict weak ordering.
  ///
  /// REQUIRES: both merits are by the same goal
  [[nodiscard]] bool is_better(const Merit& a, const Merit& b) const;
  [[nodiscard]] bool is_within_bound(const Merit& merit) const { return merit.large <= bound; }
};

}  // namespace cover
