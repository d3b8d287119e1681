// What targets for the largest angle are compared with.
#pragma once

#include <algorithm>

#include <cover/angle.hpp>
#include <cover/report.hpp>

namespace cover {

/// 180 degrees less the largest angle, as targets see it: Quality::largest_nu, but 90 degrees where
/// angles are above that by no more than rounding of coordinates (Quality::obtuse). So a mesh
/// without obtuse triangles meets a target of 90 degrees. Never less than `quality.largest_nu`.
inline Angle judged_nu(const Quality& quality) {
  return quality.obtuse == 0 ? std::max(quality.largest_nu, Angle::degrees(90))
                             : quality.largest_nu;
}

}  // namespace cover
