#include <cover/read_geo.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <thread>

#include "support/inputs/soups.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

class ReadGeo : public ::testing::Test {
 protected:
  Result<Input> read(const std::string& text) {
    const std::string path = (folder_.path() / "model.geo").string();
    std::ofstream(path) << text << '\n';
    return read_geo(path);
  }
  testing::TemporaryFolder folder_;
};

/// A disk in a square; the disk is a hole of the square and a surface of its own.
const std::string kDisk = R"(
Point(1) = {0, 0, 0, 1}; Point(2) = {4, 0, 0, 1}; Point(3) = {4, 4, 0, 1}; Point(4) = {0, 4, 0, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Point(5) = {2, 2, 0, 1}; Point(6) = {3, 2, 0, 1}; Point(7) = {1, 2, 0, 1};
Circle(5) = {6, 5, 7}; Circle(6) = {7, 5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6};
Plane Surface(1) = {1, 2}; Plane Surface(2) = {2};
Transfinite Curve{1:4} = 3; Transfinite Curve{5, 6} = 9;
)";

TEST_F(ReadGeo, MakesPolygonsOfSurfacesAndContactsOfCurves) {
  const auto input = read(kDisk + R"(
Physical Surface("iron", 7) = {1}; Physical Surface(9) = {2}; Physical Curve("gate", 3) = {3};)");
  ASSERT_TRUE(input) << input.error().message;
  ASSERT_EQ(input->polygons.size(), 2U);
  EXPECT_EQ(input->segments.size(), 2U);
  EXPECT_EQ(input->segments[0].name, "gate");
  EXPECT_EQ(input->segments[0].marker, 3);
  EXPECT_EQ(input->points.size(), 3U);
  const auto out = testing::clean(*input);
  ASSERT_TRUE(out) << out.error().message;
  const double disk = 8 * std::sin(std::numbers::pi / 8);  // sixteen chords
  EXPECT_NEAR(out->area("iron"), 16 - disk, 1e-12);
  EXPECT_NEAR(out->area("material_9"), disk, 1e-12);
  EXPECT_EQ(out->pslg.segments.size(), 8U + 16);
  EXPECT_TRUE(out->report.changes.empty());
}

TEST_F(ReadGeo, RemembersCircles) {
  const auto input = read(kDisk + "Physical Curve(\"rim\") = {5}; Physical Surface(1) = {1, 2};");
  ASSERT_TRUE(input) << input.error().message;
  ASSERT_EQ(input->circles.size(), 2U);  // of two curves
  for (const ArcCircle& circle : input->circles) {
    EXPECT_NEAR(circle.centre.x, 2, 1e-12);
    EXPECT_NEAR(circle.centre.y, 2, 1e-12);
    EXPECT_NEAR(circle.radius, 1, 1e-12);
  }
  for (const InputSegment& s : input->segments) EXPECT_EQ(s.circle, 1U);
  const auto out = testing::clean(*input);
  ASSERT_TRUE(out) << out.error().message;
  std::size_t chords = 0;
  for (const Segment& s : out->pslg.segments) chords += s.circle != 0 ? 1 : 0;
  EXPECT_EQ(chords, 16U);
}

TEST_F(ReadGeo, RemembersCirclesAfterBooleanOperations) {
  const auto input = read(R"(
SetFactory("OpenCASCADE");
Mesh.CharacteristicLengthMax = 0.5;
// the last: an ellipse
Disk(1) = {0, 0, 0, 2}; Disk(2) = {0.3, 0, 0, 1}; Disk(3) = {5, 0, 0, 2, 1};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2, 3}; Delete; })");
  ASSERT_TRUE(input) << input.error().message;
  ASSERT_EQ(input->circles.size(), 2U);
  EXPECT_NEAR(input->circles[0].radius * input->circles[1].radius, 2, 1e-12);
  for (const ArcCircle& circle : input->circles)
    EXPECT_NEAR(circle.centre.x, circle.radius < 1.5 ? 0.3 : 0, 1e-12);
}

TEST_F(ReadGeo, LeavesOutSurfacesThatAreNotPhysicalWhereSomeAre) {
  const auto input = read(kDisk + "Physical Surface(\"iron\") = {1};");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->polygons.size(), 1U);
  EXPECT_EQ(input->polygons[0].material, "iron");
  EXPECT_EQ(read(kDisk)->polygons[1].material, "surface_2");
}

TEST_F(ReadGeo, TakesTheCurvesOfAModelWithoutSurfaces) {
  const auto input = read(kDisk.substr(0, kDisk.find("Plane")));
  ASSERT_TRUE(input) << input.error().message;
  const auto out = testing::clean(*input);
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_EQ(out->table.regions.size(), 2U);  // every enclosed face
}

TEST_F(ReadGeo, SaysWhatGmshSays) {
  EXPECT_EQ(read("Point(1) = {0, 0, 0;").error().code, ErrorCode::syntax);
  EXPECT_NE(read("Point(1) = {0, 0, 0;").error().message.find("model.geo: gmsh: "),
            std::string::npos);
  EXPECT_EQ(read("Line(1) = {1, 2};").error().code, ErrorCode::syntax);
  EXPECT_EQ(read("").error().code, ErrorCode::unsupported_format);
  EXPECT_EQ(read_geo("none.geo").error().code, ErrorCode::cannot_open);
  EXPECT_TRUE(read(kDisk)) << "an error is over with the file that had it";
  const auto bent = read("Point(1) = {0, 0, 0}; Point(2) = {1, 0, 1}; Line(1) = {1, 2};");
  EXPECT_EQ(bent.error().code, ErrorCode::unsupported_format);
}

TEST_F(ReadGeo, CanBeCalledFromSeveralThreads) {
  const std::string path = (folder_.path() / "model.geo").string();
  std::ofstream(path) << kDisk;
  std::vector<std::size_t> polygons(4, 0);
  {
    std::vector<std::jthread> threads;
    for (std::size_t& n : polygons) {
      threads.emplace_back([&n, &path] { n = read_geo(path)->polygons.size(); });
    }
  }
  EXPECT_EQ(polygons, std::vector<std::size_t>(4, 2));
}

}  // namespace
}  // namespace cover
