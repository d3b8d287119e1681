// What is said of a region that misses its targets.
#include "quality/fault/missed_targets.hpp"

#include <algorithm>

#include "../mesh_checks.hpp"
#include "quality/measure_again.hpp"
#include "quality/quality_region.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(MissedTargets, SmallAnglesThatSidesForceAreToldApart) {
  // On a wall ten times as long as the layer is thick, no triangle has all angles above 11.3.
  const RegionBoundary layer = boundary_of({{{0, 0}, {10, 0}, {10, 1}, {0, 1}}});
  RegionMesh mesh;
  const auto at = [&](Point p) {
    return static_cast<std::uint32_t>(std::ranges::find(layer.points, p) - layer.points.begin());
  };
  mesh.triangles = {{at({0, 0}), at({10, 0}), at({10, 1})}, {at({0, 0}), at({10, 1}), at({0, 1})}};
  report_again(layer, Options{}, Unreached::unknown, mesh);
  ASSERT_EQ(mesh.report.notes.size(), 1U);
  EXPECT_EQ(mesh.report.notes[0].message,
            "region 1: sides near each other force 2 angles below 20 degrees");
  EXPECT_EQ(mesh.report.notes[0].where.size(), 2U);
}

TEST(MissedTargets, SegmentsThatForceAreNamedByTheirEndsWorstFirst) {
  // The notch sees the lower side flat.
  const RegionBoundary boundary = boundary_of({{{0, 0}, {8, 0}, {8, 1}, {4, 0.75}, {0, 1}}});
  RegionMesh mesh = quality_region(boundary, Options{}, {}).mesh;
  report_again(boundary, Options{}, Unreached::unknown, mesh);
  ASSERT_FALSE(mesh.report.notes.empty());
  EXPECT_NE(mesh.report.notes[0].message.find("from (0, 0) to (8, 0)"), std::string::npos)
      << mesh.report.notes[0].message;
}

}  // namespace
}  // namespace cover
