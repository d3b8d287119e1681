#include "quality/fault/missed_sizes.hpp"

#include <gtest/gtest.h>

#include "../mesh_checks.hpp"
#include "quality/quality_region.hpp"

namespace cover {
namespace {

using namespace testing;

/// A square 100 wide with a point in the middle that has a size.
RegionBoundary square_with_size(double size) {
  RegionBoundary square = boundary_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
  square.points.push_back({50, 50});
  square.vertices.push_back(VertexId(4));
  square.size_at = {0, 0, 0, 0, size};
  return square;
}

TEST(MissedSizes, APointInTheMiddleOfLongSidesIsTold) {
  const RegionMesh mesh = quality_region(square_with_size(1), Options{}, {}).mesh;
  ASSERT_EQ(mesh.report.notes.size(), 1U);
  const Note& note = mesh.report.notes[0];
  EXPECT_EQ(note.kind, Note::Kind::warning);
  EXPECT_TRUE(note.message.starts_with(
      "region 1: edges at 1 point with a size of its own are longer than asked, on average up to "
      "70.71 in place of 1 at (50, 50): beside long segments"))
      << note.message;
  EXPECT_EQ(note.where, (std::vector<Point>{{50, 50}}));
}

TEST(MissedSizes, SizesThatAreKeptAndThoseOfLongSidesAreNot) {
  EXPECT_TRUE(quality_region(square_with_size(60), Options{}, {}).mesh.report.notes.empty());
  RegionBoundary square = square_with_size(0);
  square.size_at[0] = 1;
  EXPECT_TRUE(quality_region(square, Options{}, {}).mesh.report.notes.empty());
}

TEST(MissedSizes, MeshesOfTheAlmondMethodAreTold) {
  RegionMesh mesh = quality_region(square_with_size(60), Options{}, {}).mesh;
  EXPECT_FALSE(missed_sizes(square_with_size(60), mesh));
  mesh.report.method = "almond, improved";
  const std::optional<Note> note = missed_sizes(square_with_size(60), mesh);
  ASSERT_TRUE(note);
  EXPECT_TRUE(note->message.starts_with("region 1: the sizes asked for do not count here"));
}

}  // namespace
}  // namespace cover
