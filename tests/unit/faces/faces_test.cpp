// Faces of drawings that can be told by looking.
#include "faces/faces.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace cover {
namespace {

/// Points, and segments between them.
struct Drawing {
  std::vector<Point> points;
  std::vector<IndexPair> segments;

  /// Adds a closed loop of segments, with what is inside on their left.
  void add_square(double low, double high) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {{low, low}, {high, low}, {high, high}, {low, high}});
    for (std::uint32_t k = 0; k < 4; ++k) segments.push_back({first + k, first + (k + 1) % 4});
  }
};

TEST(FindFaces, ARingAndWhatItEnclosesAreTwoFaces) {
  Drawing drawing;
  drawing.add_square(0, 9);
  drawing.add_square(3, 6);
  const Faces faces = find_faces(drawing.points, drawing.segments, false);
  ASSERT_EQ(faces.count, 3U);
  const std::uint32_t ring = faces.of_segment[0][0], core = faces.of_segment[4][0];
  EXPECT_NE(ring, kOutside);
  EXPECT_NE(core, kOutside);
  EXPECT_NE(ring, core);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(faces.of_segment[s][0], ring);
    EXPECT_EQ(faces.of_segment[s][1], kOutside);
    EXPECT_EQ(faces.of_segment[s + 4][0], core);
    EXPECT_EQ(faces.of_segment[s + 4][1], ring);
  }
}

TEST(FindFaces, ASegmentThatEndsInsideHasOneFaceOnBothSides) {
  Drawing drawing;
  drawing.add_square(0, 4);
  drawing.points.push_back({2, 2});
  drawing.segments.push_back({0, 4});
  const Faces faces = find_faces(drawing.points, drawing.segments, false);
  EXPECT_EQ(faces.count, 2U);
  EXPECT_EQ(faces.of_segment[4][0], faces.of_segment[4][1]);
  EXPECT_NE(faces.of_segment[4][0], kOutside);
}

TEST(FindFaces, WhatIsOpenIsOutsideUnlessTheHullIsAskedFor) {
  Drawing drawing;
  drawing.add_square(0, 4);
  drawing.segments.pop_back();  // the left side
  const Faces open = find_faces(drawing.points, drawing.segments, false);
  EXPECT_EQ(open.count, 1U);
  for (const std::uint32_t face : open.of_triangle) EXPECT_EQ(face, kOutside);
  const Faces hull = find_faces(drawing.points, drawing.segments, true);
  ASSERT_EQ(hull.count, 2U);
  EXPECT_TRUE(hull.open[1]);
  for (const std::uint32_t face : hull.of_triangle) EXPECT_EQ(face, 1U);
}

TEST(FindFaces, AClosedFaceIsNotOpenInTheHullEither) {
  Drawing drawing;
  drawing.add_square(0, 4);
  drawing.points.push_back({9, 2});
  const Faces faces = find_faces(drawing.points, drawing.segments, true);
  ASSERT_EQ(faces.count, 3U);
  const std::uint32_t square = faces.of_segment[0][0];
  EXPECT_FALSE(faces.open[square]);
  EXPECT_TRUE(faces.open[3 - square]);
}

TEST(FindFaces, FacesThatMeetInAPointAreTwo) {
  const Drawing drawing{{{0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}},
                        {{0, 2}, {2, 1}, {1, 0}, {0, 3}, {3, 4}, {4, 0}}};
  const Faces faces = find_faces(drawing.points, drawing.segments, false);
  ASSERT_EQ(faces.count, 3U);
  EXPECT_NE(faces.of_segment[0][0], faces.of_segment[3][0]);
}

TEST(FindFaces, SegmentsThatCrossAreRefused) {
  const Drawing drawing{{{0, 0}, {4, 4}, {0, 4}, {4, 0}}, {{0, 1}, {2, 3}}};
  EXPECT_THROW((void)find_faces(drawing.points, drawing.segments, false), std::logic_error);
}

}  // namespace
}  // namespace cover
