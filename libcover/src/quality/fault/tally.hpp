// What an excerpt has reached, for deciding whether a change to it is one for the better.
#pragma once

#include <cstddef>

#include "quality/mutable/mutable_mesh.hpp"

namespace cover {

/// What an excerpt has reached.
struct Tally {
  double largest = 0;         ///< -cot of the largest angle, if that is obtuse
  double large = 0;           ///< the largest excess of a large angle, by what sides allow
  std::size_t above = 0;      ///< triangles where that is positive
  std::size_t far_above = 0;  ///< those of them above 120 degrees
  double small = 0;           ///< the largest excess of a small angle, by what sides allow
  std::size_t below = 0;      ///< triangles where that is positive
  std::size_t negative = 0;   ///< couplings that count and are negative
};

/// Measured by `goal`, whatever goal the excerpt has set.
Tally tally_of(const MutableMesh& mesh, const Goal& goal);

}  // namespace cover
