#include "geom/curves/smooth_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "geom/foot.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The border of the pixels whose middles are inside, counter-clockwise; one piece, no pixels that
/// touch at corners only.
PixelChain border_of(const std::function<bool(double, double)>& inside, int size) {
  const auto pixel = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < size && j < size && inside(i + 0.5, j + 0.5);
  };
  std::map<Point, Point> next;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      if (!pixel(i, j)) continue;
      const double x = i, y = j;
      if (!pixel(i, j - 1)) next[{x, y}] = {x + 1, y};
      if (!pixel(i + 1, j)) next[{x + 1, y}] = {x + 1, y + 1};
      if (!pixel(i, j + 1)) next[{x + 1, y + 1}] = {x, y + 1};
      if (!pixel(i - 1, j)) next[{x, y + 1}] = {x, y};
    }
  }
  PixelChain chain{{next.begin()->first}, true};
  do {
    chain.corners.push_back(next.at(chain.corners.back()));
  } while (chain.corners.back() != chain.corners.front());
  EXPECT_EQ(chain.corners.size(), next.size() + 1);
  return chain;
}

double distance_to_curve(Point p, const std::vector<Point>& curve) {
  double nearest = 1e9;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k)
    nearest = std::min(nearest, distance_to_segment(p, curve[k], curve[k + 1]));
  return nearest;
}

/// Of either from the other.
double moved(const std::vector<Point>& a, const std::vector<Point>& b) {
  double most = 0;
  for (const Point& p : a) most = std::max(most, distance_to_curve(p, b));
  for (const Point& p : b) most = std::max(most, distance_to_curve(p, a));
  return most;
}

std::vector<Point> smoothed(const PixelChain& chain) {
  const std::vector<Point> curve = smooth_chain(chain, Smoothing::much);
  EXPECT_LE(moved(curve, chain.corners), kMostMoved);
  EXPECT_EQ(curve.front() == curve.back(), chain.is_loop);
  return curve;
}

double area_in(const std::vector<Point>& curve) {
  double doubled = 0;
  for (std::size_t k = 0; k + 1 < curve.size(); ++k)
    doubled += cross(curve[k] - curve[0], curve[k + 1] - curve[0]);
  return doubled / 2;
}

TEST(SmoothChain, DisksComeOutRound) {
  for (const double radius : {20.0, 50.0, 51.3, 120.0}) {
    for (const double shift : {0.0, 0.25, 0.5}) {
      const Point centre{130 + shift, 130 + 0.3 * shift};
      const PixelChain chain = border_of(
          [&](double x, double y) { return std::hypot(x - centre.x, y - centre.y) < radius; }, 260);
      const std::vector<Point> curve = smoothed(chain);
      const double area = std::numbers::pi * radius * radius;
      EXPECT_NEAR(area_in(curve), area, (radius < 50 ? 0.01 : 0.005) * area) << radius;
      double worst = 0;
      for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
        const Vector side = curve[k + 1] - curve[k],
                     out = midpoint(curve[k], curve[k + 1]) - centre;
        worst = std::max(worst, std::abs(std::atan2(dot(side, out), cross(out, side))));
      }
      const double degrees = worst * 180 / std::numbers::pi;
      EXPECT_LT(degrees, radius < 50 ? 9 : 5) << radius << " " << shift;
    }
  }
}

TEST(SmoothChain, StraightLinesComeOutStraight) {
  for (int k = 0; k <= 60; ++k) {
    const double angle = k * std::numbers::pi / 60, c = std::cos(angle), s = std::sin(angle);
    // From side to side of a picture: the border that is not its frame.
    const auto side = [&](double x, double y) { return (x - 150.3) * s - (y - 150.2) * c; };
    const PixelChain whole = border_of([&](double x, double y) { return side(x, y) > 0; }, 300);
    PixelChain chain;
    const auto on_frame = [](Point p) { return p.x == 0 || p.y == 0 || p.x == 300 || p.y == 300; };
    const std::vector<Point>& corners = whole.corners;
    const std::size_t n = corners.size() - 1;
    std::size_t first = 0;
    while (!(on_frame(corners[first]) && !on_frame(corners[(first + 1) % n]))) ++first;
    chain.corners.push_back(corners[first]);
    do {
      first = (first + 1) % n;
      chain.corners.push_back(corners[first]);
    } while (!on_frame(corners[first]));
    ASSERT_GT(chain.corners.size(), 290U);
    const std::vector<Point> curve = smoothed(chain);
    EXPECT_EQ(curve.front(), chain.corners.front());
    EXPECT_EQ(curve.back(), chain.corners.back());
    double worst = 0;
    for (const Point& p : curve)  // but for the ends, which stay where pixels end
      if (p.x > 20 && p.y > 20 && p.x < 280 && p.y < 280)
        worst = std::max(worst, std::abs(side(p.x, p.y)));
    for (const Point& p : {curve.front(), curve.back()}) EXPECT_LT(std::abs(side(p.x, p.y)), 1);
    EXPECT_LT(worst, 0.25) << k;
    EXPECT_LT(curve.size(), 25U) << k;
  }
}

TEST(SmoothChain, CornersAndSmallThingsStayNear) {
  for (const int size : {1, 2, 3, 5, 12, 40, 100, 200}) {
    const PixelChain square = border_of(
        [&](double x, double y) { return x > 20 && y > 20 && x < 20 + size && y < 20 + size; },
        230);
    const std::vector<Point> curve = smoothed(square);
    EXPECT_GT(area_in(curve), 0.49 * size * size) << size;
    if (size >= 100) {
      EXPECT_NEAR(area_in(curve), size * size, 0.01 * size * size);
    }
  }
  const PixelChain cross_shape = border_of(
      [](double x, double y) { return std::abs(x - 50) < 5 || std::abs(y - 50) < 5; }, 100);
  smoothed(cross_shape);
}

// From the middle of a side on, and from a corner on.
TEST(SmoothChain, RectanglesAndTheirCornersStay) {
  for (const int side : {4, 6, 20, 22, 100}) {
    for (const int first : {0, side / 2}) {
      std::vector<Point> around;
      for (int k = 0; k < side; ++k) around.push_back({1.0 * k, 0});
      for (int k = 0; k < 7; ++k) around.push_back({1.0 * side, 1.0 * k});
      for (int k = side; k > 0; --k) around.push_back({1.0 * k, 7});
      for (int k = 7; k > 0; --k) around.push_back({0, 1.0 * k});
      std::rotate(around.begin(), around.begin() + first, around.end());
      around.push_back(around.front());
      std::vector<Point> curve = smooth_chain({around, true}, Smoothing::much);
      ASSERT_EQ(curve.size(), 5U);
      EXPECT_EQ(curve.front(), curve.back());
      curve.pop_back();
      std::sort(curve.begin(), curve.end());
      const double s = side;
      EXPECT_EQ(curve, (std::vector<Point>{{0, 0}, {0, 7}, {s, 0}, {s, 7}}));
    }
  }
}

// A step of four pixels is a corner, a step of one is what a line is drawn with.
TEST(SmoothChain, HighStepsStayAndLowOnesDoNot) {
  const auto with_step = [](int height) {
    std::vector<Point> way;
    for (int k = 0; k <= 30; ++k) way.push_back({1.0 * k, 0});
    for (int k = 1; k <= height; ++k) way.push_back({30, 1.0 * k});
    for (int k = 31; k <= 60; ++k) way.push_back({1.0 * k, 1.0 * height});
    return smooth_chain({way, false}, Smoothing::much);
  };
  EXPECT_EQ(with_step(5), (std::vector<Point>{{0, 0}, {30, 0}, {30, 5}, {60, 5}}));
  for (const Point& p : with_step(1)) EXPECT_TRUE(p.x != 30 || (p.y > 0 && p.y < 1));
}

TEST(SmoothChain, WithoutSmoothingTurnsStay) {
  const PixelChain square =
      border_of([](double x, double y) { return x > 2 && y > 3 && x < 7 && y < 9; }, 10);
  for (std::size_t k = 0; k + 1 < square.corners.size(); ++k) {
    PixelChain turned{{}, true};  // wherever it begins
    for (std::size_t i = 0; i < square.corners.size(); ++i)
      turned.corners.push_back(square.corners[(k + i) % (square.corners.size() - 1)]);
    const std::vector<Point> stairs = smooth_chain(turned, Smoothing::none);
    EXPECT_EQ(area_in(stairs), 30);
    EXPECT_EQ(stairs.size(), 5U);
    EXPECT_EQ(stairs.front(), stairs.back());
  }
  const PixelChain open{{{0, 0}, {1, 0}, {2, 0}, {2, 1}}, false};
  EXPECT_EQ(smooth_chain(open, Smoothing::none), (std::vector<Point>{{0, 0}, {2, 0}, {2, 1}}));
  EXPECT_EQ(smooth_chain(open, Smoothing::least),
            (std::vector<Point>{{0, 0}, {1.5, 0}, {2, 0.5}, {2, 1}}));
}

}  // namespace
}  // namespace cover
