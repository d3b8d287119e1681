// Reports of regions of one triangle, and of none.
#include "target/report/fill_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

TEST(FillReport, NamesTheWorstTriangle) {
  const RegionBoundary boundary = testing::boundary_of({{{0, 0}, {4, 0}, {2, 0.5}}});
  RegionMesh mesh;
  mesh.triangles = {{0, 2, 1}};
  mesh.report.id = boundary.id;
  mesh.report.nu_bound = Angle::degrees(20);
  fill_report(boundary, mesh);
  EXPECT_TRUE(mesh.report.bound_held);
  EXPECT_TRUE(mesh.report.notes.empty());
  EXPECT_EQ(mesh.report.quality.triangles, 1U);
  EXPECT_EQ(mesh.report.input_vertices, 3U);
  EXPECT_NEAR(mesh.report.quality.largest_nu.in_radians(), 2 * std::atan(0.25), 1e-15);

  mesh.report.nu_bound = Angle::degrees(30);
  fill_report(boundary, mesh);
  EXPECT_FALSE(mesh.report.bound_held);
  ASSERT_EQ(mesh.report.notes.size(), 1U);
  EXPECT_EQ(mesh.report.notes[0].kind, Note::Kind::bound_missed);
  EXPECT_NE(mesh.report.notes[0].message.find("(2, 0.5)"), std::string::npos);
  EXPECT_EQ(mesh.report.notes[0].where.size(), 3U);
}

TEST(FillReport, NoTriangleHoldsNoBound) {
  const RegionBoundary boundary = testing::boundary_of({testing::regular_polygon(5)});
  RegionMesh mesh;
  fill_report(boundary, mesh);
  EXPECT_FALSE(mesh.report.bound_held);
  EXPECT_NEAR(mesh.report.quality.largest_nu.in_radians(), std::numbers::pi, 0);
}

}  // namespace
}  // namespace cover
