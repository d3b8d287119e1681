// Angle statistics against angles known in closed form.
#include "target/report/measure_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "target/report/measure_boxes.hpp"

namespace cover {
namespace {

TEST(MeasureAngles, EquilateralTriangleInEveryRotation) {
  const double h = std::sqrt(3.0) / 2;
  const std::vector<Point> points{{0, 0}, {1, 0}, {0.5, h}};
  for (const IndexTriple t : {IndexTriple{0, 1, 2}, IndexTriple{1, 2, 0}, IndexTriple{2, 0, 1}}) {
    const Quality q = measure_angles(points, std::vector{t});
    EXPECT_NEAR(q.largest_nu.in_degrees(), 120, 1e-12);
    EXPECT_NEAR(q.smallest.in_degrees(), 60, 1e-12);
    EXPECT_EQ(q.obtuse, 0U);
    EXPECT_NEAR(q.area, h / 2, 1e-15);
    EXPECT_EQ(std::accumulate(q.histogram.begin(), q.histogram.end(), 0U), 3U);
  }
}

TEST(MeasureAngles, FlatTriangleKeepsItsDigits) {
  const double height = 0x1p-40;
  const std::vector<Point> points{{-1, 0}, {1, 0}, {0, height}};
  const Quality q = measure_angles(points, std::vector{IndexTriple{0, 1, 2}});
  EXPECT_NEAR(q.largest_nu.in_radians() / (2 * height), 1, 1e-15);
  EXPECT_NEAR(q.smallest.in_radians() / height, 1, 1e-15);
  EXPECT_EQ(q.obtuse, 1U);
  EXPECT_EQ(q.above_120, 1U);
  EXPECT_EQ(q.above_150, 1U);
}

TEST(MeasureAngles, EveryAngleHasItsBin) {
  for (int degrees = 15; degrees < 80; degrees += 10) {  // and what is left, at a right angle
    const double slope = std::tan(Angle::degrees(degrees).in_radians());
    const std::vector<Point> points{{0, 0}, {1, 0}, {1, slope}};
    const Quality q = measure_angles(points, std::vector<IndexTriple>{{0, 1, 2}});
    const auto bin = static_cast<std::size_t>(degrees / 10);
    EXPECT_EQ(q.histogram[bin], bin == 4 ? 2U : 1U);
    EXPECT_EQ(q.histogram[8 - bin], bin == 4 ? 2U : 1U);
  }
  const std::vector<Point> line{{0, 0}, {1, 0}, {2, 0}};
  const Quality flat = measure_angles(line, std::vector<IndexTriple>{{0, 1, 2}});
  EXPECT_EQ(flat.histogram[17], 1U);
  EXPECT_EQ(flat.histogram[0], 2U);
}

TEST(MeasureAngles, RightAngleIsNotObtuse) {
  const std::vector<Point> points{{0.1, 0.1}, {0.3, 0.1}, {0.1, 0.7}};
  const Quality q = measure_angles(points, std::vector{IndexTriple{0, 1, 2}});
  EXPECT_EQ(q.obtuse, 0U);
  EXPECT_EQ(q.histogram[8] + q.histogram[9], 1U);
}

TEST(MeasureAngles, RightAnglesThatRoundingMissesAreNotObtuse) {
  std::vector<Point> points{{0, 0}, {0, 0}, {0, 0}};
  for (int k = 1; k < 200; ++k) {
    const double c = std::cos(0.031 * k), s = std::sin(0.031 * k);
    points[1] = {3 * c, 3 * s};
    points[2] = {-s, c};
    EXPECT_EQ(measure_angles(points, std::vector{IndexTriple{0, 1, 2}}).obtuse, 0U) << k;
    points[2] = {-s - 1e-8 * c, c - 1e-8 * s};
    EXPECT_EQ(measure_angles(points, std::vector{IndexTriple{0, 1, 2}}).obtuse, 1U) << k;
    const std::vector<IndexPair> sides{{0, 1}, {1, 2}, {2, 0}};
    EXPECT_EQ(measure_boxes(points, std::vector{IndexTriple{0, 1, 2}}, sides).obtuse_sides, 1U);
  }
}

/// A foot on a slanted segment is rounded: angles there are right up to that only.
TEST(MeasureAngles, WhatRoundingMakesIsNotObtuse) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> share(0.3, 0.7);
  const Point a{1234.1, 871.3}, b{1235.7, 872.9};
  const Vector along = b - a;
  std::size_t exactly = 0, by_more_than_before = 0, by_rounding = 0;
  for (int k = 0; k < 200; ++k) {
    const Point foot = a + share(random) * along;
    const Point p = foot + 1e-6 * left_normal(along);
    const std::vector<Point> points{a, foot, p, b};
    const std::vector<IndexTriple> triangles{{0, 1, 2}, {1, 3, 2}};
    for (const Point end : {a, b}) {
      exactly += compare_with_90_degrees(end, foot, p) == Sign::positive ? 1 : 0;
      by_more_than_before += angle_at(end, foot, p) > std::numbers::pi / 2 + 1e-9 ? 1 : 0;
    }
    EXPECT_EQ(measure_angles(points, triangles).obtuse, 0u);
    by_rounding += measure_angles(points, triangles).obtuse_by_rounding;
    const std::vector<Point> moved{a, foot + -1e-8 * along, p, b};
    EXPECT_EQ(measure_angles(moved, triangles).obtuse, 2u);  // at the foot, and opposite
  }
  EXPECT_GT(exactly, 50u);
  EXPECT_EQ(by_rounding, exactly);
  EXPECT_GT(by_more_than_before, 50u);
}

TEST(MeasureAngles, MergeAddsUp) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {3, -0.5}};
  const std::vector<IndexTriple> triangles{{0, 1, 2}, {0, 3, 1}};
  Quality sum = measure_angles(points, std::span(triangles).first(1));
  merge(sum, measure_angles(points, std::span(triangles).last(1)));
  const Quality whole = measure_angles(points, triangles);
  EXPECT_EQ(sum.triangles, whole.triangles);
  EXPECT_EQ(sum.largest_nu, whole.largest_nu);
  EXPECT_EQ(sum.smallest, whole.smallest);
  EXPECT_EQ(sum.histogram, whole.histogram);
  EXPECT_EQ(sum.area, whole.area);
}

}  // namespace
}  // namespace cover
