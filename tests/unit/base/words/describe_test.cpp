#include <cover/regions.hpp>
#include <cover/text.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

namespace cover {
namespace {

TEST(Describe, NumbersReadBackAsTheyWere) {
  for (const double x : {0.1, 1.0 / 3, 1e-300, 512001.25, -0.0, 5e22, 9007199254740993.0}) {
    EXPECT_EQ(std::strtod(describe(x).c_str(), nullptr), x) << describe(x);
  }
  EXPECT_EQ(describe(0.1), "0.1");
  EXPECT_EQ(describe(Point{0.5, -2}), "(0.5, -2)");
}

TEST(Describe, RoughlyIsThreeDigits) {
  EXPECT_EQ(describe_roughly(0.123456), "0.123");
  EXPECT_EQ(describe_roughly(2), "2");
}

TEST(Describe, CountsAgreeWithTheirNoun) {
  EXPECT_EQ(counted(0, "segment"), "0 segments");
  EXPECT_EQ(counted(1, "segment"), "1 segment");
  EXPECT_EQ(counted(3, "segment"), "3 segments");
}

TEST(Describe, KindsOfInterfaces) {
  EXPECT_EQ(describe(InterfaceKind::interface), "interface");
  EXPECT_EQ(describe(InterfaceKind::outline), "outline");
  EXPECT_EQ(describe(InterfaceKind::slit), "slit");
  EXPECT_EQ(describe(InterfaceKind::contact), "contact");
}

}  // namespace
}  // namespace cover
