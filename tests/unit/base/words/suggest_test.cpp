#include <cover/text.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace cover {
namespace {

const std::vector<std::string> kKeys{"material", "region", "rings", "priority", "x"};

TEST(Closest, ForgivesOneSlipInThreeLetters) {
  EXPECT_EQ(closest("materail", kKeys), "material");
  EXPECT_EQ(closest("Material", kKeys), "material");
  EXPECT_EQ(closest("regions", kKeys), "region");
  EXPECT_EQ(closest("mater", kKeys), "material");
  EXPECT_EQ(closest("colour", kKeys), std::nullopt);
}

TEST(Closest, ForgivesCapitalsInShortWords) {
  EXPECT_EQ(closest("ID", std::vector<std::string>{"x", "id", "ad"}), "id");
  EXPECT_EQ(closest("ID", std::vector<std::string>{"x", "ad"}), std::nullopt);
}

TEST(Closest, KnowsALineByItsRegionsTheOtherWayRound) {
  const std::vector<std::string> lines{"gate_oxide", "thin_oxide_p_well", "outline"};
  EXPECT_EQ(closest("oxide_gate", lines), "gate_oxide");
  EXPECT_EQ(closest("p_well_thin_oxide", lines), "thin_oxide_p_well");
  EXPECT_EQ(closest("gate_ledge", lines), std::nullopt);
}

TEST(Closest, LeavesVeryLongWordsAlone) {
  EXPECT_EQ(closest(std::string(100000, 'x'), kKeys), std::nullopt);
}

}  // namespace
}  // namespace cover
