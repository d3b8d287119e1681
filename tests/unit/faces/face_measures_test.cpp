// Figures of faces that are known in closed form, and of faces without room.
#include "faces/face_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace cover {
namespace {

using Loop = std::vector<Point>;

/// The faces of closed loops.
Faces faces_of_loops(const std::vector<Loop>& loops) {
  std::vector<Point> points;
  std::vector<IndexPair> segments;
  for (const Loop& loop : loops) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const auto n = static_cast<std::uint32_t>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (std::uint32_t k = 0; k < n; ++k) segments.push_back({first + k, first + (k + 1) % n});
  }
  return find_faces(points, segments, false);
}

Loop square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

TEST(MeasureFaces, AHoleTakesFromTheArea) {
  const Faces faces = faces_of_loops({square(0, 9), square(3, 6)});
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  ASSERT_EQ(measures.size(), 3U);
  EXPECT_EQ(measures[faces.of_segment[0][0]].area, 72);
  EXPECT_EQ(measures[faces.of_segment[4][0]].area, 9);
}

TEST(MeasureFaces, TheInnerPointOfARingIsNotInItsHole) {
  const Faces faces = faces_of_loops({square(0, 9), square(1, 8)});
  const FaceMeasure ring = measure_faces(faces)[faces.of_segment[0][0]];
  ASSERT_TRUE(ring.inside);
  const auto [x, y] = *ring.inside;
  EXPECT_TRUE(x > 0 && x < 9 && y > 0 && y < 9);
  EXPECT_FALSE(x >= 1 && x <= 8 && y >= 1 && y <= 8);
}

TEST(MeasureFaces, TheSmallestSideHasTheFaceOnItsLeft) {
  const Faces faces = faces_of_loops({square(0, 9), square(3, 6)});
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  using Side = std::pair<Point, Point>;
  EXPECT_EQ(measures[faces.of_segment[0][0]].smallest_side, (Side{{0, 0}, {9, 0}}));
  EXPECT_EQ(measures[faces.of_segment[4][0]].smallest_side, (Side{{3, 3}, {6, 3}}));
}

TEST(MeasureFaces, AFaceBetweenNeighbouringDoublesHasNoPointInside) {
  const double next = 1 + 0x1p-52;
  const Faces faces = faces_of_loops({{{1, 1}, {next, 1}, {next, next}}});
  const std::vector<FaceMeasure> measures = measure_faces(faces);
  ASSERT_EQ(measures.size(), 2U);
  EXPECT_FALSE(measures[1].inside);
  EXPECT_EQ(measures[1].area, 0x1p-105);
}

TEST(MeasureFaces, SmallAreasAreNotLostBesideLargeOnes) {
  // A comb: one large rectangle, and thin teeth on it whose areas are below its rounding.
  constexpr int kTeeth = 64;
  constexpr double kHeight = 0x1p-50;
  Loop comb{{0, -1}, {2 * kTeeth, -1}};
  for (int k = kTeeth; k-- > 0;) {
    const double x = 2 * k;
    comb.insert(comb.end(), {{x + 2, 0}, {x + 1, 0}, {x + 1, kHeight}, {x, kHeight}});
  }
  comb.push_back({0, 0});
  comb.erase(std::unique(comb.begin(), comb.end()), comb.end());
  const std::vector<FaceMeasure> measures = measure_faces(faces_of_loops({comb}));
  EXPECT_EQ(measures[1].area, 2 * kTeeth + kTeeth * kHeight);
}

}  // namespace
}  // namespace cover
