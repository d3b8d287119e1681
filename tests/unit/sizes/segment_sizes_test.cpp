#include "sizes/segment_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geom/vector.hpp"

namespace cover {
namespace {

/// A region of which only the side from `a` to `b` matters.
RegionBoundary side(Point a, Point b, double size, std::vector<double> size_at = {}) {
  RegionBoundary boundary;
  boundary.points = {a, b};
  boundary.sides = {{0, 1}};
  boundary.segments = {SegmentId{0}};
  boundary.size = size;
  boundary.size_at = std::move(size_at);
  return boundary;
}

const Point kA{1, 2}, kB{4, 6};  // 5 apart

SegmentSizes sizes_of(const RegionBoundary& boundary, const Options& options) {
  SegmentSizes sizes(kA, kB, options);
  sizes.add(boundary, 0);
  return sizes;
}

/// Lengths of the pieces from kA to kB.
std::vector<double> pieces(const SegmentSizes& sizes) {
  std::vector<Point> points = sizes.cuts();
  points.insert(points.begin(), kA);
  points.push_back(kB);
  std::vector<double> lengths;
  for (std::size_t k = 1; k < points.size(); ++k) {
    lengths.push_back(length(points[k] - points[k - 1]));
    EXPECT_NEAR(cross(points[k] - kA, kB - kA), 0, 1e-14);
  }
  return lengths;
}

TEST(SegmentSizes, WithoutAWishNothingIsLong) {
  const Options options;
  const SegmentSizes sizes = sizes_of(side(kA, kB, 0), options);
  EXPECT_FALSE(sizes.is_long());
  EXPECT_TRUE(sizes.cuts().empty());
}

TEST(SegmentSizes, EqualPiecesOfAboutTheSize) {
  const Options options;
  EXPECT_FALSE(sizes_of(side(kA, kB, 3.4), options).is_long());
  EXPECT_TRUE(sizes_of(side(kA, kB, 3.3), options).is_long());
  for (const double size : {3.3, 1.0, 0.9, 0.03}) {
    const std::vector<double> lengths = pieces(sizes_of(side(kA, kB, size), options));
    EXPECT_EQ(lengths.size(), static_cast<std::size_t>(std::round(5 / size)));
    for (const double l : lengths) EXPECT_NEAR(l, 5.0 / double(lengths.size()), 1e-12);
  }
}

TEST(SegmentSizes, TheSmallestOfBothRegionsCounts) {
  const Options options;
  SegmentSizes sizes(kA, kB, options);
  sizes.add(side(kA, kB, 2.5), 0);
  sizes.add(side(kB, kA, 1), 0);
  EXPECT_EQ(pieces(sizes).size(), 5U);
}

TEST(SegmentSizes, GrowFromAnEnd) {
  Options options;
  options.growth = 1.2;
  const std::vector<double> lengths = pieces(sizes_of(side(kA, kB, 0, {0.1, 0}), options));
  EXPECT_NEAR(lengths.front(), 0.1, 0.02);
  for (std::size_t k = 1; k < lengths.size(); ++k) {
    EXPECT_GT(lengths[k], lengths[k - 1]);
    EXPECT_LT(lengths[k], 1.3 * lengths[k - 1]);
  }
  // As many as the integral of 1 / (0.1 + 0.2 s).
  EXPECT_NEAR(double(lengths.size()), std::log((0.1 + 0.2 * 5) / 0.1) / 0.2, 1);
}

TEST(SegmentSizes, FollowTheBackground) {
  Options options;
  options.size_field = [](Point p) { return 0.05 + 0.1 * (p.x - 1); };
  const std::vector<double> lengths = pieces(sizes_of(side(kA, kB, 0), options));
  EXPECT_NEAR(lengths.front(), 0.05, 0.01);
  EXPECT_NEAR(lengths.back(), 0.35, 0.04);
  EXPECT_NEAR(double(lengths.size()), std::log(0.35 / 0.05) / 0.06, 1);
  options.size_field = [](Point) { return std::nan(""); };  // no wish
  EXPECT_FALSE(sizes_of(side(kA, kB, 0), options).is_long());
}

TEST(SegmentSizes, TheSamePointsFromBothEndsAndInAnyUnit) {
  Options options;
  const std::vector<Point> plain = sizes_of(side(kA, kB, 1, {0.01, 0.1}), options).cuts();
  SegmentSizes turned(kB, kA, options);
  turned.add(side(kA, kB, 1, {0.01, 0.1}), 0);
  std::vector<Point> back = turned.cuts();
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(back, plain);
  const double factor = 0x1p-30;
  const Point a{kA.x * factor, kA.y * factor}, b{kB.x * factor, kB.y * factor};
  SegmentSizes small(a, b, options);
  small.add(side(a, b, factor, {0.01 * factor, 0.1 * factor}), 0);
  const std::vector<Point> scaled = small.cuts();
  ASSERT_EQ(scaled.size(), plain.size());
  for (std::size_t k = 0; k < plain.size(); ++k) {
    EXPECT_EQ(scaled[k], (Point{plain[k].x * factor, plain[k].y * factor}));
  }
}

}  // namespace
}  // namespace cover
