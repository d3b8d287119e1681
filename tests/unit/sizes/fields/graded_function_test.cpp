#include "sizes/fields/graded_function.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cover {
namespace {

constexpr double kSlope = 0.3;

RegionBoundary square_of_side(double side) {
  RegionBoundary boundary;
  boundary.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  boundary.sides = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  boundary.size_grid = side / 16;
  return boundary;
}

/// A square with a square hole in its middle.
RegionBoundary frame() {
  RegionBoundary boundary = square_of_side(10);
  for (const Point p : {Point{4, 4}, Point{4, 6}, Point{6, 6}, Point{6, 4}})
    boundary.points.push_back(p);
  for (std::uint32_t k = 0; k < 4; ++k) boundary.sides.push_back({4 + k, 4 + (k + 1) % 4});
  return boundary;
}

SizeFunction graded(const SizeFunction& wish, const RegionBoundary& boundary) {
  Result<GradedFunction> made = graded_function(wish, "wish", boundary, kSlope);
  EXPECT_TRUE(made);
  EXPECT_FALSE(made && made->missed);
  return made ? made->sizes : SizeFunction{};
}

TEST(GradedFunction, ABowlBetweenTheCornersIsFound) {
  const auto bowl = [](Point p) { return 0.2 + (p.x - 2) * (p.x - 2) + (p.y - 7) * (p.y - 7); };
  const SizeFunction sizes = graded(bowl, square_of_side(10));
  EXPECT_NEAR(sizes({2, 7}), 0.2, 1e-6);
  for (const Point corner : square_of_side(10).points) {
    const double far = std::hypot(corner.x - 2, corner.y - 7);
    EXPECT_LT(sizes(corner), 0.2 + 1.3 * kSlope * far + 0.2);
    EXPECT_GT(sizes(corner), 0.2);
  }
}

TEST(GradedFunction, ADipIsFound) {
  const SizeFunction sizes = graded(
      [](Point p) {
        return 1 - 0.95 * std::exp(-10 * std::pow(std::hypot(p.x - 3.3, p.y - 6.1), 2));
      },
      square_of_side(10));
  for (const double beside : {0.3, 1.0, 2.0})
    EXPECT_LT(sizes({3.3 + beside, 6.1}), 0.1 + 1.1 * kSlope * beside) << beside;
}

TEST(GradedFunction, AValleyIsFoundAllAlong) {
  const SizeFunction sizes =
      graded([](Point p) { return 0.05 + 10 * std::abs(p.x - 3.3); }, square_of_side(10));
  for (double y = 0; y <= 10; y += 0.37) {
    EXPECT_NEAR(sizes({3.3, y}), 0.05, 1e-12);
    for (const double beside : {0.1, 0.4, 1.0, 3.0}) {
      EXPECT_LT(sizes({3.3 - beside, y}), 0.25 + 1.1 * kSlope * beside) << beside;
    }
  }
}

TEST(GradedFunction, WhatVertexesCannotMissStaysAsItIs) {
  const auto slow = [](Point p) { return 0.1 + 0.2 * std::hypot(p.x - 3, p.y - 3); };
  const SizeFunction sizes = graded(slow, square_of_side(10));
  std::mt19937_64 random(71);
  std::uniform_real_distribution<double> place(0, 10);
  for (int k = 0; k < 200; ++k) {
    const Point p{place(random), place(random)};
    EXPECT_EQ(sizes(p), slow(p));
  }
}

TEST(GradedFunction, WhatLiesOutsideTheRegionIsNotLookedAt) {
  const auto far = [](Point p) { return 0.9 * std::hypot(p.x - 5, p.y - 5); };
  const SizeFunction sizes = graded(far, frame());
  EXPECT_GT(sizes({4, 5}), 0.8);
  EXPECT_FALSE(graded_function(far, "far", square_of_side(10), kSlope));
}

TEST(GradedFunction, ZeroIsRefusedWithItsPlace) {
  for (const auto& wish : {SizeFunction([](Point p) { return p.x - 5; }),
                           SizeFunction([](Point p) { return std::abs(p.x - 5); }),
                           SizeFunction([](Point p) { return 0.01 * (p.x - 5); })}) {
    const Result<GradedFunction> made = graded_function(wish, "x - 5", square_of_side(10), kSlope);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::bad_option);
    EXPECT_NE(made.error().message.find("'x - 5' falls to zero near (5"), std::string::npos);
    ASSERT_EQ(made.error().where.size(), 1U);
    EXPECT_NEAR(made.error().where[0].x, 5, 1e-5);
  }
}

TEST(GradedFunction, WhatWasRaisedByTooLittleIsTold) {
  const auto wish = [](Point p) { return std::max(std::abs(p.x - 5), 1e-9); };
  const Result<GradedFunction> made =
      graded_function(wish, "abs(x - 5)", square_of_side(10), kSlope, 1e-9);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::bad_option);
  EXPECT_NE(made.error().message.find("--min-size 1e-09 is too short"), std::string::npos);
  EXPECT_NE(made.error().message.find("1.41e-08"), std::string::npos);
}

TEST(GradedFunction, TooManyPlacesAreTold) {
  const auto wish = [](Point p) { return 0.0001 + 10 * std::abs(p.x + 0.37 * p.y - 7); };
  const Result<GradedFunction> made = graded_function(wish, "wish", square_of_side(10), kSlope);
  ASSERT_TRUE(made);
  ASSERT_TRUE(made->missed);
  EXPECT_NEAR(made->missed->x + 0.37 * made->missed->y, 7, 0.2);
}

TEST(GradedFunction, WhereAWishEndsItIsKept) {
  const auto step = [](Point p) { return p.x > 6.1 ? 0.2 : std::nan(""); };
  const SizeFunction sizes = graded(step, square_of_side(10));
  EXPECT_EQ(sizes({8, 5}), 0.2);
  EXPECT_LT(sizes({5, 5}), 0.2 + 1.1 * kSlope * 1.2);
  EXPECT_GT(sizes({1, 5}), 0.2 + 0.9 * kSlope * 5);
}

}  // namespace
}  // namespace cover
