#include "target/local_frame.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cover {
namespace {

TEST(LocalFrame, ShiftsOnlyWhereThatIsExact) {
  const std::vector<Point> exact{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 0.5}};
  const LocalFrame shifted(exact);
  EXPECT_TRUE(shifted.is_shifted());
  EXPECT_EQ(shifted.points()[1], (Point{1, 0}));
  EXPECT_EQ(shifted.restore(shifted.points()[2]), exact[2]);
  const std::vector<Point> inexact{{1, 0}, {1e-20, 0}, {0, 1}};
  const LocalFrame same(inexact);
  EXPECT_FALSE(same.is_shifted());
  EXPECT_EQ(same.points(), inexact);
}

}  // namespace
}  // namespace cover
