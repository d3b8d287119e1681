// How far a refinement goes in the tests of this folder.
#pragma once

#include <cmath>

#include "quality/starts/delaunay_refinement.hpp"

namespace cover::testing {

/// Until angles are so large.
inline RefineLimits limits_of(double degrees) {
  RefineLimits limits;
  limits.smallest_cot = 1 / std::tan(degrees * 3.14159265358979 / 180);
  limits.budget = 100000;
  return limits;
}

}  // namespace cover::testing
