#include "geom/topology/corner.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(Corner, GoesRoundBothWays) {
  constexpr std::array<std::uint32_t, 3> kNext{1, 2, 0};
  std::vector<std::uint32_t> seen;
  for (const Corner i : kCorners) {
    seen.push_back(i);
    EXPECT_EQ(i.next(), kNext[i]);
    EXPECT_EQ(i.next().previous(), i);
    EXPECT_EQ(i.previous(), i.next().next());
  }
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(Corner(), 0U);
}

}  // namespace
}  // namespace cover
