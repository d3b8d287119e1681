#include "layers/front/guards.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/inputs/shapes.hpp"

namespace cover::layers {
namespace {

TEST(Guards, ThatOnlyTouchDoNotOverlap) {
  const Guard cell{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_FALSE(overlap(cell, {{2, 0}, {3, 0}, {3, 1}, {2, 1}}));  // an edge
  EXPECT_FALSE(overlap(cell, {{2, 1}, {3, 1}, {3, 2}}));          // a corner
  EXPECT_FALSE(overlap(cell, {{0, 0}, {2, 0}}));                  // its own edge
  EXPECT_FALSE(overlap(cell, {{0, 0}, {-1, 5}}));                 // a side from its corner
  EXPECT_FALSE(overlap(cell, {{2, 0}, {2, 7}}));                  // a wall beside it
  EXPECT_FALSE(overlap(cell, {{2, 1}}));                          // a point
}

TEST(Guards, ThatOverlapAreFound) {
  const Guard cell{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  EXPECT_TRUE(overlap(cell, {{1.5, 0.5}, {3, 0}, {3, 1}}));
  EXPECT_TRUE(overlap(cell, {{-1, -1}, {3, 2}}));
  EXPECT_TRUE(overlap(cell, {{0, 0}, {1, 1}}));
  EXPECT_TRUE(overlap(cell, {{1, 0.5}}));
  EXPECT_TRUE(overlap(cell, cell));
  // Thin cells, as layers are.
  const Guard thin{{0, 0}, {1, 0}, {1, 1e-6}, {0, 1e-6}};
  EXPECT_TRUE(overlap(thin, {{0.5, 9e-7}, {0.5, 1}}));
  EXPECT_FALSE(overlap(thin, {{0.5, 1.1e-6}, {0.5, 1}}));
}

TEST(BoxTree, FindsWhatASearchThroughAllFinds) {
  const std::uint64_t seed = testing::test_seed(7);
  SCOPED_TRACE(testing::seed_trace(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(0, 1), size(0, 0.1);
  const auto random_box = [&] {
    Box box;
    box.add({place(random), place(random)});
    box.add({box.low.x + size(random), box.low.y + size(random)});
    return box;
  };
  std::vector<Box> boxes(300);
  for (Box& box : boxes) box = random_box();
  const BoxTree tree(boxes);
  for (int k = 0; k < 100; ++k) {
    const Box asked = random_box();
    std::vector<std::uint32_t> found, expected;
    tree.visit(asked, [&](std::uint32_t i) { found.push_back(i); });
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].meets(asked)) expected.push_back(i);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace cover::layers
