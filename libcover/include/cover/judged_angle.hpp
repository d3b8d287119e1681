// How angles are compared with targets.
#pragma once

#include <algorithm>

#include <cover/angle.hpp>
#include <cover/report.hpp>

namespace cover {

/// In radians: an angle that misses a target by less meets it.
inline constexpr double kAngleMet = 1e-9;

/// Whether an angle that is to be at least `wanted` is: the smallest angle, or 180 degrees less the
/// largest one.
constexpr bool meets(Angle reached, Angle wanted) {
  return reached.in_radians() >= wanted.in_radians() - kAngleMet;
}

/// 180 degrees less the largest angle, as targets see it: `largest_nu`, but 90 degrees where angles
/// are above that by no more than rounding of coordinates, so that no triangle is obtuse. So a mesh
/// without obtuse triangles meets a target of 90 degrees. Never less than `largest_nu`.
inline Angle judged_nu(Angle largest_nu, bool any_obtuse) {
  return any_obtuse ? largest_nu : std::max(largest_nu, Angle::degrees(90));
}

/// That of a mesh or of a region.
inline Angle judged_nu(const Quality& quality) {
  return judged_nu(quality.largest_nu, quality.obtuse > 0);
}

}  // namespace cover
