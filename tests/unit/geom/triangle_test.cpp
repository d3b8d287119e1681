#include "geom/triangle.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geom/vector.hpp"

namespace cover {
namespace {

TEST(Triangle, HasTwiceAnAreaWithASign) {
  EXPECT_EQ(doubled_area({1, 1}, {4, 1}, {1, 3}), 6);
  EXPECT_EQ(doubled_area({1, 1}, {1, 3}, {4, 1}), -6);
}

TEST(Triangle, HoldsItsCentroidAndNoPointOfItsEdges) {
  const Point a{0, 0}, b{6, 0}, c{0, 3};
  EXPECT_EQ(centroid(a, b, c), (Point{2, 1}));
  EXPECT_TRUE(is_strictly_inside(a, b, c, {2, 1}));
  EXPECT_FALSE(is_strictly_inside(a, b, c, {2, 0}));
  EXPECT_FALSE(is_strictly_inside(a, b, c, {6, 3}));
  EXPECT_FALSE(is_strictly_inside(a, c, b, {2, 1}));  // clockwise
}

TEST(Triangle, HasACircle) {
  EXPECT_EQ(circumcentre({0, 0}, {4, 0}, {0, 2}), (Point{2, 1}));
  EXPECT_EQ(circumcentre_from({0, 0}, {0, 2}, {4, 0}), (Point{2, 1}));
}

/// From the corner with the largest angle, whichever comes first.
TEST(Triangle, HasTheSameCircleFromAllCorners) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 100; ++k) {
    const Point a{unit(random), unit(random)}, b{unit(random), unit(random)},
        c{unit(random), unit(random)};
    const Point centre = circumcentre(a, b, c);
    EXPECT_EQ(circumcentre(b, c, a), centre);
    EXPECT_EQ(circumcentre(c, a, b), centre);
    EXPECT_NEAR(length(a - centre) / length(b - centre), 1, 1e-9);
  }
}

}  // namespace
}  // namespace cover
