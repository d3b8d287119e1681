#include <cover/size_function.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sizes/spread_sizes.hpp"

namespace cover {
namespace {

TEST(SpreadSizes, GrowAlongTheShortestWay) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {0, 3}};
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> edges{{1, 0}, {1, 2}, {3, 0}, {3, 2}};
  std::vector<double> sizes{0.5, 9, 9, 0.75};
  spread_sizes(points, edges, 0.25, sizes);
  EXPECT_EQ(sizes, (std::vector{0.5, 0.75, 1.0, 0.75}));
}

/// A unit square of two triangles, one of them clockwise, with the sizes 1 + x + 2 y.
SizeSamples square_of_sizes() {
  return {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 3, 2}}, {1, 2, 4, 3}};
}

constexpr double kSteep = 100;  ///< a growth that changes nothing

TEST(SizeFunction, IsLinearInTriangles) {
  const SizeFunction size = size_function(square_of_sizes(), kSteep).value();
  for (const Point p : {Point{0, 0}, Point{0.25, 0.125}, Point{0.125, 0.5}, Point{0.5, 0.5},
                        Point{1, 1}, Point{0.75, 1}}) {
    EXPECT_DOUBLE_EQ(size(p), 1 + p.x + 2 * p.y);
  }
}

TEST(SizeFunction, OutsideTheNearestPlaceCounts) {
  const SizeFunction size = size_function(square_of_sizes(), kSteep).value();
  EXPECT_DOUBLE_EQ(size({0.25, -7}), 1.25);
  EXPECT_DOUBLE_EQ(size({3, 0.5}), 3);
  EXPECT_DOUBLE_EQ(size({-1, -1}), 1);
  EXPECT_DOUBLE_EQ(size({5, 9}), 4);
}

TEST(SizeFunction, PointsWithoutTriangles) {
  SizeSamples samples = square_of_sizes();
  samples.triangles.clear();
  const SizeFunction size = size_function(samples, kSteep).value();
  EXPECT_EQ(size({0.25, 0.125}), 1);
  EXPECT_EQ(size({0.75, 0.9}), 4);
}

TEST(SizeFunction, FlatTrianglesDoNoHarm) {
  SizeSamples samples = square_of_sizes();
  samples.triangles.insert(samples.triangles.begin(), {{0, 2, 2}, {0, 0, 0}});
  const SizeFunction size = size_function(samples, kSteep).value();
  EXPECT_DOUBLE_EQ(size({0.5, 0.5}), 2.5);
}

TEST(SizeFunction, GrowsNoFasterThanAsked) {
  SizeSamples samples = square_of_sizes();
  samples.sizes = {0.25, 8, 8, 8};
  const SizeFunction size = size_function(samples, 1.5).value();
  EXPECT_DOUBLE_EQ(size({1, 0}), 0.75);
  EXPECT_DOUBLE_EQ(size({0.5, 0}), 0.5);
  EXPECT_DOUBLE_EQ(size({1, 1}), 0.25 + 0.5 * std::sqrt(2.0));
}

TEST(SizeFunction, IsTheSameInAnyUnitAndForAnyOrderOfTriangles) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr std::uint32_t kSide = 9;
  SizeSamples plain;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    plain.points.push_back({double(i % kSide), double(i / kSide)});
    plain.sizes.push_back(0.1 + uniform(random));
  }
  for (std::uint32_t i = 0; i + kSide < kSide * kSide; ++i) {
    if (i % kSide + 1 == kSide) continue;
    plain.triangles.push_back({i, i + 1, i + kSide});
    plain.triangles.push_back({i + 1, i + kSide + 1, i + kSide});
  }
  SizeSamples small = plain;
  const double factor = 0x1p-40;
  for (Point& p : small.points) p = {p.x * factor, p.y * factor};
  for (double& size : small.sizes) size *= factor;
  const SizeFunction of_plain = size_function(plain, 1.3).value();
  const SizeFunction of_small = size_function(small, 1.3).value();
  for (int k = 0; k < 2000; ++k) {
    Point p{10 * uniform(random) - 1, 10 * uniform(random) - 1};
    if (k % 4 == 0) p = {std::round(p.x * 2) / 2, std::round(p.y * 2) / 2};  // on edges and corners
    EXPECT_EQ(of_small({p.x * factor, p.y * factor}), of_plain(p) * factor);
    EXPECT_GT(of_plain(p), 0);
  }
}

TEST(SizeFunction, RefusesWhatIsNoField) {
  const auto code = [](auto change) {
    SizeSamples samples = square_of_sizes();
    change(samples);
    const Result<SizeFunction> size = size_function(samples, 1.3);
    return size ? ErrorCode::internal : size.error().code;
  };
  EXPECT_EQ(code([](SizeSamples& s) { s = {}; }), ErrorCode::syntax);
  EXPECT_EQ(code([](SizeSamples& s) { s.sizes.pop_back(); }), ErrorCode::syntax);
  EXPECT_EQ(code([](SizeSamples& s) { s.sizes[2] = 0; }), ErrorCode::syntax);
  EXPECT_EQ(code([](SizeSamples& s) { s.sizes[2] = std::nan(""); }), ErrorCode::syntax);
  EXPECT_EQ(code([](SizeSamples& s) { s.points[1].x = INFINITY; }),
            ErrorCode::non_finite_coordinate);
  EXPECT_EQ(code([](SizeSamples& s) { s.triangles[1][0] = 4; }), ErrorCode::id_out_of_range);
  SizeSamples samples = square_of_sizes();
  samples.sizes[3] = -2;
  const Error error = size_function(samples, 1.3).error();
  EXPECT_NE(error.message.find("(0, 1)"), std::string::npos) << error.message;
  EXPECT_EQ(error.where, std::vector<Point>{(Point{0, 1})});
}

}  // namespace
}  // namespace cover
