#include <cover/text.hpp>

#include <gtest/gtest.h>

#include <vector>

#include "base/words/meant_or_there.hpp"

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

TEST(Closest, TellsNamesThatDifferInHowAccentsAreWritten) {
  const std::string composed = "M\xc3\xbcller", marks = "Mu\xcc\x88ller";
  const std::string alike =
      "It looks alike, but one of both has accents as letters of their own, the other as marks "
      "after a letter (NFC and NFD of Unicode)";
  const auto advice = [](const std::string& word, const std::string& known) {
    return did_you_mean(word, std::vector<std::string>{known});
  };
  EXPECT_EQ(advice(marks, composed), "; did you mean '" + composed + "'? " + alike);
  EXPECT_EQ(advice(composed, marks), "; did you mean '" + marks + "'? " + alike);
  const std::string short_name = "\xc3\x96l", short_marks = "O\xcc\x88l";
  EXPECT_EQ(advice(short_marks, short_name), "; did you mean '" + short_name + "'? " + alike);
  EXPECT_EQ(advice("M\xc3\xbclles", composed), "; did you mean '" + composed + "'?");
  EXPECT_EQ(advice("mater", "material"), "; did you mean 'material'?");
}

TEST(Closest, LeavesVeryLongWordsAlone) {
  EXPECT_EQ(closest(std::string(100000, 'x'), kKeys), std::nullopt);
}

TEST(MeantOrThere, NamesTheFewWhereNoneIsClose) {
  EXPECT_EQ(meant_or_there("regoin", kKeys), "; did you mean 'region'?");
  EXPECT_EQ(meant_or_there("colour", kKeys),
            "; there are 'material', 'region', 'rings', 'priority', 'x'");
  EXPECT_EQ(meant_or_there("colour", std::vector<std::string>{"", "Si", "Si"}), "; there is 'Si'");
  EXPECT_EQ(meant_or_there("colour", std::vector<std::string>{""}), "");
  std::vector<std::string> many;
  for (int k = 0; k < 10; ++k) many.push_back(std::string(1, static_cast<char>('a' + k)));
  EXPECT_EQ(meant_or_there("colour", many),
            "; there are 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h' and 2 more");
}

}  // namespace
}  // namespace cover
