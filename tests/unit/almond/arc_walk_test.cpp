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
  // Flatter: the circle through (-4, 3) and (4, 3) over a chord seen under more than 120 degrees.
  const Stages flat(testing::boundary_of(
      {{{-12, 5}, {12, 5}, {5, 12}, {0, 13}, {-5, 12}}}));  // all on x^2 + y^2 = 169
  const Reach on_circle = walk_almonds(flat.cdt, flat.almonds);
  int lower_ones = 0;
  for (std::uint32_t k = 0; k < flat.almonds.size(); ++k) {
    const bool lower = flat.almonds[k].from.y == 5 && flat.almonds[k].to.y == 5;
    if (!lower || !flat.almonds[k].passes_apex()) continue;
    EXPECT_EQ(on_circle.known_of(k).size(), 5U);
    ++lower_ones;
  }
  EXPECT_EQ(lower_ones, 1);
}

}  // namespace
}  // namespace cover
