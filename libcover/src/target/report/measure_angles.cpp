// All angles of a triangle share one cross product, so each costs one division: its cotangent,
// which orders angles as well as the angles do and keeps the digits of flat triangles. Arc tangents
// are taken of the extremes only.
#include "target/report/measure_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/numbers.hpp"
#include "geom/angle_rounding.hpp"
#include "geom/cotangent.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "target/report/sorted_corners.hpp"

namespace cover {
namespace {

constexpr double kCotangentOf150 = -std::numbers::sqrt3;
constexpr std::size_t kUpToRight = 8;  ///< the bin of 80 to 90 degrees

/// Cotangents of 10, 20, ..., 170 degrees, made up to a whole tree of binary search.
using BinLimits = std::array<double, 31>;

BinLimits bin_limits() {
  BinLimits limits;
  limits.fill(kNoNumber);  // none of them is reached
  for (std::size_t k = 0; k < 17; ++k) {
    limits[k] = cot_of(Angle::degrees(10.0 * static_cast<double>(k + 1)).in_radians());
  }
  // A right angle is not above 90 degrees: the upper bins hold the obtuse ones.
  limits[kUpToRight] = -std::numeric_limits<double>::min();
  return limits;
}

/// The bin of an angle with this cotangent: how many limits are no smaller. By additions, because
/// nobody can predict a branch.
std::size_t bin_of(double cotangent, const BinLimits& limits) {
  std::size_t bin = 0;
  for (std::size_t step = 16; step > 0; step /= 2) {
    bin += step * static_cast<std::size_t>(cotangent <= limits[bin + step - 1]);
  }
  return bin;
}

Quality measure_some(std::span<const Point> points, std::span<const IndexTriple> triangles,
                     const BinLimits& limits) {
  Quality quality;
  quality.triangles = triangles.size();
  double lowest = kInfinity, highest = -lowest;
  SortedCorners flattest, sharpest;
  for (const auto& [i, j, k] : triangles) {
    const SortedCorners s = sort_corners(points[i], points[j], points[k]);
    const double doubled_area = cross(s.p - s.apex, s.q - s.apex), area = std::abs(doubled_area);
    const double largest = cotangent(s.p, s.apex, s.q, area);
    const double smallest = cotangent(s.apex, s.sharp, s.blunt, area);
    if (largest < lowest) lowest = largest, flattest = s;
    if (smallest > highest) highest = smallest, sharpest = s;
    const Blunt blunt = largest < kNearRight ? bluntness(s.p, s.apex, s.q) : Blunt::no;
    quality.obtuse += blunt == Blunt::yes ? 1 : 0;
    quality.obtuse_by_rounding += blunt == Blunt::by_rounding ? 1 : 0;
    if (largest < -kNearRight) {
      if (compare_with_120_degrees(s.p, s.apex, s.q) == Sign::positive) ++quality.above_120;
      if (largest < kCotangentOf150) ++quality.above_150;
    }
    const std::size_t bin = bin_of(largest, limits);
    ++quality.histogram[blunt == Blunt::yes ? bin : std::min(bin, kUpToRight)];
    ++quality.histogram[bin_of(cotangent(s.apex, s.blunt, s.sharp, area), limits)];
    ++quality.histogram[bin_of(smallest, limits)];
    quality.area += doubled_area / 2;
  }
  if (!triangles.empty()) {
    quality.largest_nu = Angle::radians(accurate_nu_at(flattest.p, flattest.apex, flattest.q));
    quality.smallest = Angle::radians(angle_at(sharpest.apex, sharpest.sharp, sharpest.blunt));
  }
  return quality;
}

}  // namespace

Quality measure_angles(std::span<const Point> points, std::span<const IndexTriple> triangles,
                       const Team& team) {
  static const BinLimits limits = bin_limits();  // small regions come by the thousand
  if (triangles.size() <= kMeasuredAtATime) return measure_some(points, triangles, limits);
  std::vector<Quality> parts(Team::ranges(triangles.size(), kMeasuredAtATime));
  team.each_range(triangles.size(), kMeasuredAtATime, [&](std::size_t first, std::size_t last) {
    parts[first / kMeasuredAtATime] =
        measure_some(points, triangles.subspan(first, last - first), limits);
  });
  Quality sum = parts[0];
  for (std::size_t k = 1; k < parts.size(); ++k) merge(sum, parts[k]);
  return sum;
}

void merge(Quality& sum, const Quality& part) {
  sum.triangles += part.triangles;
  sum.largest_nu = std::min(sum.largest_nu, part.largest_nu);
  sum.smallest = std::min(sum.smallest, part.smallest);
  sum.obtuse += part.obtuse;
  sum.obtuse_by_rounding += part.obtuse_by_rounding;
  sum.above_120 += part.above_120;
  sum.above_150 += part.above_150;
  for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
  sum.area += part.area;
}

}  // namespace cover
