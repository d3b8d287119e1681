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

/// A rectangle with sides 5 long. On one wall each is followed by one of 0.009, as where the wall
/// opposite has feet of its own.
RegionBoundary rectangle_with_feet_on_a_wall(int sides, double height) {
  std::vector<Point> loop;
  for (int k = 0; k < sides; ++k) loop.push_back({5.0 * k, 0});
  for (double y = 0; y < height; y += 5) loop.push_back({5.0 * sides, y});
  for (int k = sides; k > 0; --k) {
    if (k < sides) loop.push_back({5.0 * k + 0.009, height});
    loop.push_back({5.0 * k, height});
  }
  for (double y = height; y > 0; y -= 5) loop.push_back({0, y});
  return boundary_of({loop});
}

TEST(MissedSizes, SmallAnglesArePaidBeforeSizes) {
  for (const Effort effort : {Effort::fast, Effort::normal, Effort::thorough}) {
    for (const Prefer prefer : {Prefer::balanced, Prefer::largest}) {
      Options options;
      options.effort = effort;
      options.prefer = prefer;
      RegionBoundary rectangle = rectangle_with_feet_on_a_wall(8, 20);
      rectangle.size = 4;
      const RegionMesh mesh = quality_region(rectangle, options, {}).mesh;
      EXPECT_TRUE(mesh.report.method.starts_with("refined")) << mesh.report.method;
      EXPECT_FALSE(missed_sizes(rectangle, mesh));
    }
  }
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
