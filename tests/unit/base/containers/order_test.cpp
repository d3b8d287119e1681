#include "base/containers/order.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cover {
namespace {

TEST(Order, OfEqualOnesTheLowerNumberComesFirst) {
  const std::vector<int> keys{5, 1, 5, 0, 1};
  const auto order = sorted_numbers(keys.size(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  EXPECT_EQ(order, (std::vector<std::uint32_t>{3, 1, 4, 0, 2}));
  EXPECT_EQ(in_order(keys, order), (std::vector<int>{0, 1, 1, 5, 5}));
}

TEST(Order, PlacesUndoIt) {
  const std::vector<std::uint32_t> order{3, 1, 4, 0, 2};
  EXPECT_EQ(in_order(order, places_in(order)), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(Order, AListMayBePutInPartOfAnOrder) {
  const std::vector<std::string> words{"a", "b", "c"};
  EXPECT_EQ(in_order(words, std::vector<std::size_t>{2, 0}), (std::vector<std::string>{"c", "a"}));
  EXPECT_TRUE(sorted_numbers(0, [](auto, auto) { return false; }).empty());
}

}  // namespace
}  // namespace cover
