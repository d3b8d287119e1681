// Tested by tests/unit/quality/plan/candidates_test.cpp.
#include "quality/fault/extreme_angles.hpp"

#include <algorithm>
#include <vector>

#include "geom/cotangent.hpp"

namespace cover {

AngleRange extreme_angles(const MutableMesh& mesh, const Team& team) {
  struct Cotangents {
    double least = kInverted, most = -kInverted;
  };
  std::vector<Cotangents> parts(Team::ranges(mesh.triangles.size(), kManyAtATime));
  team.each_range(mesh.triangles.size(), kManyAtATime, [&](std::size_t first, std::size_t last) {
    Cotangents& own = parts[first / kManyAtATime];
    for (std::size_t s = first; s < last; ++s) {
      const auto t = static_cast<std::uint32_t>(s);
      if (mesh.is_hole(t)) continue;
      const Corners k(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
      own.least = std::min(own.least, std::min({k.dot[0], k.dot[1], k.dot[2]}) / k.cross);
      own.most = std::max(own.most, std::max({k.dot[0], k.dot[1], k.dot[2]}) / k.cross);
    }
  });
  double least = kInverted, most = -kInverted;
  for (const Cotangents& part : parts) {
    least = std::min(least, part.least);
    most = std::max(most, part.most);
  }
  return {angle_of_cot(least), angle_of_cot(most)};
}

}  // namespace cover
