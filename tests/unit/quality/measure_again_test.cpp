// What is said of a region after its mesh was changed once more.
#include "quality/measure_again.hpp"

#include "mesh_checks.hpp"

namespace cover {
namespace {

using namespace testing;

TEST(ReportAgain, TellsMissedTargetsAgainAndOtherNotesStay) {
  // A square cut in four by a vertex next to its lower side: two angles above 100 degrees, 4 below
  // 20, at places of the plane.
  const RegionBoundary boundary = boundary_of({{{10, 10}, {12, 10}, {12, 12}, {10, 12}}});
  RegionMesh mesh;
  mesh.steiner = {{11, 10.25}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  mesh.report.notes = {{Note::Kind::fallback, boundary.id, "another method was used", {}},
                       {Note::Kind::target_missed, boundary.id, "before", {}}};
  report_again(boundary, Options{}, Unreached::budget, mesh);
  const std::vector<Note>& notes = mesh.report.notes;
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].message, "another method was used");
  EXPECT_NE(notes[1].message.find("1 angle above 100 degrees"), std::string::npos)
      << notes[1].message;
  EXPECT_NE(notes[1].message.find("budget"), std::string::npos) << notes[1].message;
  ASSERT_EQ(notes[1].where.size(), 1U);
  EXPECT_EQ(notes[1].where[0], (Point{11, 10.25}));
  EXPECT_NE(notes[2].message.find("below 20 degrees"), std::string::npos) << notes[2].message;
}

TEST(MeasureAgain, FiguresAreThoseOfTheMeshAsItIsNow) {
  const RegionBoundary boundary = boundary_of({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
  RegionMesh mesh;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  measure_again(boundary, Options{}, Unreached::unknown, mesh);
  EXPECT_EQ(mesh.report.quality.triangles, 2U);
  EXPECT_NEAR(mesh.report.quality.smallest.in_degrees(), 45, 1e-9);
  EXPECT_TRUE(mesh.report.notes.empty());
  // A vertex near the lower side: obtuse there, and told so.
  mesh.steiner = {{1, 0.25}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  measure_again(boundary, Options{}, Unreached::unknown, mesh);
  EXPECT_EQ(mesh.report.quality.triangles, 4U);
  EXPECT_EQ(mesh.report.steiner_vertices, 1U);
  EXPECT_GT(mesh.report.quality.largest_nu.supplement().in_degrees(), 150);
  EXPECT_FALSE(mesh.report.notes.empty());
}

}  // namespace
}  // namespace cover
