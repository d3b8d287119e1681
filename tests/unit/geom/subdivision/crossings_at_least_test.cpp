#include "geom/subdivision/crossings_at_least.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace cover {
namespace {

/// Lines across, and as many upright ones: each crosses each of the others.
std::vector<PlainSegment> crossing_lines(int n) {
  std::vector<PlainSegment> out;
  for (int k = 0; k < n; ++k) {
    out.push_back({{0, k + 0.5}, {static_cast<double>(n), k + 0.5}});
    out.push_back({{k + 0.5, 0}, {k + 0.5, static_cast<double>(n)}});
  }
  return out;
}

TEST(CrossingsAtLeast, OfAGridNearlyAll) {
  for (const int n : {100, 3000}) {
    const double all = static_cast<double>(n) * n, found = crossings_at_least(crossing_lines(n));
    EXPECT_LE(found, all);
    EXPECT_GE(found, 0.8 * all);
  }
}

TEST(CrossingsAtLeast, OfLinesThroughOnePointNone) {
  std::vector<PlainSegment> star;
  for (int k = 0; k < 2000; ++k) {
    const double a = k * std::numbers::pi / 2000;
    const Point p{std::round(1e6 * std::cos(a)), std::round(1e6 * std::sin(a))};
    star.push_back({p, {-p.x, -p.y}});
  }
  EXPECT_EQ(crossings_at_least(star), 0);
}

TEST(CrossingsAtLeast, EndsThatTouchAreNone) {
  std::vector<PlainSegment> saw;
  for (int k = 0; k < 5000; ++k) saw.push_back({{0, 0.0 + k}, {1, 1.0 + k}});
  for (int k = 0; k < 5000; ++k) saw.push_back({{1, 0.0 + k}, {2, 0.5 + k}});
  EXPECT_EQ(crossings_at_least(saw), 0);
  EXPECT_EQ(crossings_at_least({}), 0);
}

}  // namespace
}  // namespace cover
