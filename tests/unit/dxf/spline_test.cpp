#include "dxf/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/vector.hpp"

namespace cover {
namespace {

/// A quarter of the unit circle, exactly, as a rational spline of degree 2.
DxfSpline quarter() {
  DxfSpline s;
  s.degree = 2;
  s.knots = {0, 0, 0, 1, 1, 1};
  s.controls = {{1, 0}, {1, 1}, {0, 1}};
  s.weights = {1, std::sqrt(0.5), 1};
  return s;
}

TEST(SplinePoints, LieOnTheCurveAndTurnByNoMore) {
  for (const double step : {30.0, 5.0, 1.0}) {
    const auto points = spline_points(quarter(), step, std::nullopt);
    ASSERT_TRUE(points);
    EXPECT_EQ(points->front(), (Point{1, 0}));
    EXPECT_EQ(points->back(), (Point{0, 1}));
    for (const Point p : *points) EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-14);
    for (std::size_t k = 1; k < points->size(); ++k) {
      const double turned = angle_at((*points)[k - 1], {0, 0}, (*points)[k]) * 180 / M_PI;
      EXPECT_LE(turned, step * 1.01);
      EXPECT_GE(turned, step * 0.3);
    }
  }
}

TEST(SplinePoints, KeepToTheChordError) {
  const auto points = spline_points(quarter(), 90, 1e-4);
  ASSERT_TRUE(points);
  for (std::size_t k = 1; k < points->size(); ++k) {
    const Point m = midpoint((*points)[k - 1], (*points)[k]);
    EXPECT_LE(1 - std::hypot(m.x, m.y), 1.01e-4);
  }
  EXPECT_LT(points->size(), 100U);
}

TEST(SplinePoints, FindsBendsBetweenStraightEnds) {
  DxfSpline s;  // an S: its middle lies on the line between its ends
  s.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  s.controls = {{0, 0}, {1, 1}, {2, -1}, {3, 0}};
  s.weights = {1, 1, 1, 1};
  EXPECT_GT(spline_points(s, 5, std::nullopt)->size(), 20U);
  s.controls = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_EQ(spline_points(s, 5, std::nullopt)->size(), 2U);
  s.degree = 1;
  s.knots = {0, 0, 1, 2, 3, 3};
  s.controls = {{0, 0}, {1, 1}, {2, -1}, {3, 0}};
  EXPECT_EQ(*spline_points(s, 5, std::nullopt), s.controls);
}

TEST(SplinePoints, WhatDoesNotFitIsNoSpline) {
  DxfSpline s = quarter();
  s.knots.pop_back();
  EXPECT_FALSE(spline_points(s, 5, std::nullopt));
  s = quarter();
  s.knots = {0, 0, 1, 0, 1, 1};
  EXPECT_FALSE(spline_points(s, 5, std::nullopt));
  s = quarter();
  s.degree = 1000000000;
  EXPECT_FALSE(spline_points(s, 5, std::nullopt));
  s = quarter();
  s.knots.assign(6, 1);
  EXPECT_FALSE(spline_points(s, 5, std::nullopt));
  s.degree = 0;
  EXPECT_FALSE(spline_points(s, 5, std::nullopt));
  DxfSpline fits;
  fits.fits = {{0, 0}, {1, 0}, {1, 1}};
  fits.closed = true;
  EXPECT_EQ(spline_points(fits, 5, std::nullopt)->size(), 4U);
}

}  // namespace
}  // namespace cover
