// Numbers of materials that inputs spell in every way.
#include "faces/materials.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cover {
namespace {

struct Numbered : Materials {
  std::vector<Note> notes;
};

/// The numbers of seeds of these materials.
Numbered number(const std::vector<std::string>& spelled) {
  std::vector<RegionSeed> seeds(spelled.size());
  for (std::size_t k = 0; k < spelled.size(); ++k) seeds[k].material = spelled[k];
  Numbered out;
  static_cast<Materials&>(out) = number_materials(seeds, out.notes);
  return out;
}

using Numbers = std::vector<std::int32_t>;
using Names = std::vector<std::string>;

TEST(NumberMaterials, PositiveNumbersAreKept) {
  const Numbered out = number({"7", "2", "7", "+3", "2147483647"});
  EXPECT_EQ(out.numbers, (Numbers{7, 2, 7, 3, 2147483647}));
  EXPECT_EQ(out.names[0], "material_7");
  EXPECT_TRUE(out.notes.empty());
}

TEST(NumberMaterials, NamesGetTheSmallestFreeNumbersAsTheyComeUp) {
  const Numbered out = number({"oxide", "1", "silicon", "oxide", "3"});
  EXPECT_EQ(out.numbers, (Numbers{2, 1, 4, 2, 3}));
  EXPECT_EQ(out.names, (Names{"oxide", "material_1", "silicon", "oxide", "material_3"}));
  EXPECT_TRUE(out.notes.empty());
}

TEST(NumberMaterials, SeedsWithoutMaterialAreOfDifferentOnes) {
  EXPECT_EQ(number({"", "1", ""}).numbers, (Numbers{2, 1, 3}));
}

TEST(NumberMaterials, WhatIsNoPositiveIntegerIsRenumberedAndTold) {
  const Numbered out = number({"-3", "2.5", "99999999999", "-3"});
  EXPECT_EQ(out.numbers, (Numbers{1, 2, 3, 1}));
  EXPECT_EQ(out.names[0], "material_-3");
  ASSERT_EQ(out.notes.size(), 3U);
  EXPECT_EQ(out.notes[0].message, "material -3 is no positive integer: it becomes number 1");
  EXPECT_EQ(out.notes[1].message, "material 2.5 is no positive integer: it becomes number 2");
  EXPECT_EQ(out.notes[2].message,
            "material 99999999999 is larger than 2147483647: it becomes number 3");
}

TEST(NumberMaterials, FacesWithoutASeedComeAfterAllOthers) {
  EXPECT_EQ(number({}).unnamed, 1);
  EXPECT_EQ(number({"7", "oxide"}).unnamed, 8);
  EXPECT_EQ(number({"1", "2147483647"}).unnamed, 2) << "there is no larger number";
}

}  // namespace
}  // namespace cover
