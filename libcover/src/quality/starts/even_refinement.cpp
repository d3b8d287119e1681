// See even_refinement.hpp. Tested by tests/unit/quality/starts/even_refinement_test.cpp.
#include "quality/starts/even_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "geom/vector.hpp"
#include "quality/starts/delaunay_refinement.hpp"

namespace cover {
namespace {

constexpr double kMostArea = 8;  ///< per vertex, in h^2: some 7 triangles per vertex

}  // namespace

bool refine_evenly(MutableMesh& mesh) {
  double shortest2 = kInverted, longest_side2 = 0, twice_area = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Corner i : kCorners) {
      const double l = squared_length(mesh.corner(t, i.previous()) - mesh.corner(t, i.next()));
      shortest2 = std::min(shortest2, l);
      if (is_side(mesh.triangles[t].n[i])) longest_side2 = std::max(longest_side2, l);
    }
    twice_area += Corners(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)).cross;
  }
  const auto vertices = static_cast<double>(mesh.points.size());
  if (longest_side2 > 3 * shortest2 || twice_area > 2 * kMostArea * vertices * shortest2)
    return false;
  RefineLimits limits;
  limits.smallest_cot = kInverted;
  limits.largest_radius = std::sqrt(shortest2);
  limits.apex_cot = -kInverted;
  limits.budget = kNone;
  refine(mesh, limits);
  return true;
}

}  // namespace cover
