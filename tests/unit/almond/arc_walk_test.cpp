#include "almond/arc_walk.hpp"

#include <gtest/gtest.h>

#include "stages.hpp"

namespace cover {
namespace {

using testing::Stages;

TEST(WalkAlmonds, KnowsTheApexByIdentityAndCocircularVertices) {
  // Seen from the long lower side, the three upper vertices lie on one circle (3-4-5 and the top).
  const Stages s(testing::boundary_of({{{-5, 0}, {5, 0}, {4, 3}, {0, 5}, {-4, 3}}}));
  const Reach reach = walk_almonds(s.cdt, s.almonds);
  for (std::uint32_t k = 0; k < s.almonds.size(); ++k) {
    EXPECT_EQ(reach.known_of(k).front().vertex, s.almonds[k].u);
    EXPECT_EQ(reach.known_of(k).back().vertex, s.almonds[k].v);
  }
  // Flatter: all on x^2 + y^2 = 625, from where the lower side is seen under 143 degrees.
  const Stages flat(testing::boundary_of({{{-15, 20}, {15, 20}, {7, 24}, {0, 25}, {-7, 24}}}));
  const Reach on_circle = walk_almonds(flat.cdt, flat.almonds);
  int lower_ones = 0;
  for (std::uint32_t k = 0; k < flat.almonds.size(); ++k) {
    const bool lower = flat.almonds[k].from.y == flat.almonds[k].to.y;
    if (!lower || !flat.almonds[k].passes_apex()) continue;
    EXPECT_EQ(on_circle.known_of(k).size(), 5U);
    ++lower_ones;
  }
  EXPECT_EQ(lower_ones, 1);
}

}  // namespace
}  // namespace cover
