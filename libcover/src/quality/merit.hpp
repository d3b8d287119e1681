// Which of two triangulations of a region is better.
#pragma once

#include <cstddef>
#include <cstdint>

#include "quality/mutable_mesh.hpp"

namespace cover {

/// What a triangulation has reached, in the order of merit; all in cotangents, smaller is better.
struct Merit {
  double large = 0;       ///< -cot of the largest angle, no lower than the region's target
  std::size_t above = 0;  ///< triangles with a larger angle than the goal and their sides allow
  double small = 0;       ///< cot of the smallest angle, no lower than the goal
  std::size_t triangles = 0;

  /// Whether both targets are met by every triangle.
  bool complete = false;
};

/// Cost: O(triangles)
Merit merit_of(const MutableMesh& mesh, const Goal& goal);

/// Whether triangle `t` has a larger angle than the goal and its sides allow.
bool is_above(const MutableMesh& mesh, std::uint32_t t, const Goal& goal);

/// Whether `a` is better: smaller largest angle, then fewer triangles above the goal, then larger
/// smallest angle, then fewer triangles.
bool is_better(const Merit& a, const Merit& b);

}  // namespace cover
