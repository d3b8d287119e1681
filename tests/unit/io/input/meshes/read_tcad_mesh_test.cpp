#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "io/input/formats.hpp"

namespace cover {
namespace {

/// Oxide over silicon, of two triangles each, the silicon cut into two regions; contacts above and
/// below. A value per node and material jumps at the interface.
const std::string kTif = R"(h TIF V1.2.1 test
cd GEN blnk blnk blnk cart2D 1.0 0.0
cg 3.0E+02
c 1 0. -1. 0.
c 2 1. -1. 0.
c 3 0. 0. 0.
c 4 1. 0. 0.
c 5 0. 2. 0.
c 6 1. 2. 0.
e 1 1 2 0
e 2 5 6 0
e 7 4 5 0
r 1 Ox 1
 b 1
r 2 Si 2
r 3 Si 5
i 1 Elec gate 0
 j 1
i 2 Elec bulk 0
 j 2
t 1 1 1 2 3 -1024 2 -1024
t 2 1 2 4 3 -1024 -1024 1
t 3 2 3 4 5 4 -1024 -1024
t 4 3 4 6 5 -1024 -1024 3
simpur 1 N-type
s 2 Net Total
n 1 Ox 0. 0.
n 2 Ox 0. 0.
n 3 Ox 0. 0.
n 4 Ox 0. 0.
n 3 Si 1e15 2e15
n 4 Si 3e15 4e15
n 5 Si -5e15 6e15
mo blank gen 1
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ReadTif, RegionsContactsAndValues) {
  const Result<Input> input = parse_tif(kTif, "a.tif");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->unit, "um");
  EXPECT_EQ(input->warnings.size(), 1U);  // node 6 has no values
  ASSERT_EQ(input->seeds.size(), 3U);     // two regions of silicon stay two
  EXPECT_EQ(input->seeds[0].material, "Ox");
  EXPECT_EQ(input->seeds[1].material, "Si");
  EXPECT_EQ(input->seeds[2].material, "Si");
  EXPECT_EQ(input->points.size(), 6U);
  EXPECT_EQ(input->points[0], (Point{0, -1}));
  EXPECT_EQ(input->segments.size(), 8U);
  std::set<std::string> names;
  for (const InputSegment& s : input->segments)
    if (!s.name.empty()) names.insert(s.name);
  EXPECT_EQ(names, (std::set<std::string>{"gate", "bulk"}));
  ASSERT_TRUE(input->field);
  const PlaneField& field = *input->field;
  EXPECT_EQ(field.triangles.size(), 4U);
  EXPECT_EQ(field.material, (std::vector<std::string>{"Ox", "Ox", "Si", "Si"}));
  EXPECT_EQ(field.points.size(), 8U);  // nodes 3 and 4 twice
  ASSERT_EQ(field.arrays.size(), 2U);
  EXPECT_EQ(field.arrays[0].name, "Net");
  const auto value = [&](std::size_t triangle, std::size_t corner) {
    return field.arrays[0].values[field.triangles[triangle][corner]];
  };
  EXPECT_EQ(value(1, 1), 0);     // node 4 in oxide
  EXPECT_EQ(value(2, 1), 3e15);  // and in silicon
  EXPECT_EQ(value(2, 2), -5e15);
  EXPECT_TRUE(std::isnan(value(3, 1)));  // node 6 has none
}

TEST(ReadTif, MistakesHaveLines) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    const Result<Input> input = parse_tif(replaced(kTif, from, to), "a.tif");
    EXPECT_FALSE(input) << to;
    return input ? "" : input.error().message;
  };
  EXPECT_EQ(refusal("c 2 1. -1. 0.", "c 2 x -1."), "a.tif:5: x: 'x' is no number");
  EXPECT_EQ(refusal("c 2 1. -1. 0.", "c 2"), "a.tif:5: x is missing");
  EXPECT_EQ(refusal("c 2 1. -1. 0.", "c 2 inf 0"), "a.tif:5: the coordinate is not finite");
  EXPECT_EQ(refusal("c 2 1. -1. 0.", "c 1 0 0"), "a.tif:5: there is a coordinate 1 already");
  EXPECT_EQ(refusal("r 2 Si 2", "r 1 Si 2"), "a.tif:15: there is a region 1 already");
  EXPECT_EQ(refusal("t 1 1 1 2 3", "t 1 1 1 2 9"), "a.tif:21: there is no coordinate 9");
  EXPECT_EQ(refusal("t 1 1 1 2 3", "t 1 7 1 2 3"), "a.tif:21: there is no region 7");
  EXPECT_EQ(refusal(" j 2", " j 5"), "a.tif:20: there is no edge 5");
  EXPECT_EQ(refusal("s 2 Net Total", "s 3 Net Total"), "a.tif:26: 3 values are announced, 2 named");
  EXPECT_EQ(refusal("s 2 Net Total", "s 999999999999 Net"),
            "a.tif:26: 999999999999 values are announced, 1 named");
  EXPECT_EQ(refusal("n 3 Si 1e15 2e15", "n 3 Si 1e15"), "a.tif:31: the value of Total is missing");
  // Which were read as none, and looked for as two.
  EXPECT_EQ(refusal("s 2 Net Total\nn 1 Ox 0. 0.\n", "n 1 Ox 0. 0.\ns 2 Net Total\n"),
            "a.tif:27: values before the list of their names");
  EXPECT_EQ(parse_tif("h TIF\n", "a.tif").error().message, "a.tif: no triangles in it");
  EXPECT_EQ(parse_tif("", "a.tif").error().message, "a.tif: no triangles in it");
}

TEST(ReadTif, AFileThatWasCutShortIsNoSmallerDevice) {
  const std::string whole(kTif);
  const std::size_t first = whole.find("\nt 1 "), behind = whole.find('\n', first + 1);
  ASSERT_NE(first, std::string::npos);
  const Result<Input> cut = parse_tif(whole.substr(0, behind + 1), "a.tif");
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, ErrorCode::truncated);
  EXPECT_NE(cut.error().message.find("but coordinate"), std::string::npos) << cut.error().message;
  const std::string square = "h TIF\nc 1 0 0\nc 2 1 0\nc 3 1 1\nr 1 Si\nt 1 1 1 2 3 0 0 0";
  EXPECT_TRUE(parse_tif(square + "\n", "a.tif"));
  EXPECT_EQ(parse_tif(square, "a.tif").error().message,
            "a.tif:6: the file ends in the middle of its triangles");
}

TEST(ReadTif, UnknownRecordsAreNamed) {
  const Result<Input> input = parse_tif(kTif + "zz 1\nzz 2\nyy\n", "a.tif");
  ASSERT_TRUE(input) << input.error().message;
  ASSERT_FALSE(input->warnings.empty());
  EXPECT_EQ(input->warnings.back(), "3 lines of unknown kinds left out: yy, zz");
}

TEST(ReadTif, ValuesThatAreMissingAreTold) {
  const std::string whole = replaced(kTif, "mo blank gen 1\n", "n 6 Si 1 1\n");
  EXPECT_TRUE(parse_tif(whole, "a.tif")->warnings.empty());
  const std::string cut = whole.substr(0, whole.find("n 5 Si"));
  EXPECT_EQ(parse_tif(cut, "a.tif")->warnings,
            std::vector<std::string>{"2 coordinates in materials that have values have none: the "
                                     "file may have been cut short"});
}

const std::string kStr = R"(v SUPREM-IV.GS test
D 2 3 3
c 1 0 -1 0
c 2 1 -1 0
c 3 0 0 0
c 4 1 0 0
c 5 0 2 0
r 1 1
r 2 3
r 3 0
r 4 42
t 1 1 1 2 3 -1024 2 -1024
t 2 4 2 4 3 -1024 -1024 1
t 3 2 3 4 5 4 -1024 -1024
t 4 3 1 2 5 0 0 0
M 1 2 3
s 2 5 99
n 1 3 0 0
n 2 3 1e15 7
n 3 3 2e15 8
n 4 3 3e15 9
)";

TEST(ReadSuprem, MaterialsAndValuesByNumber) {
  // Here values count coordinates from 1; node 5 has none.
  const Result<Input> input = parse_suprem(kStr, "a.str");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->unit, "um");
  ASSERT_EQ(input->seeds.size(), 3U);  // gas is no region
  EXPECT_EQ(input->seeds[0].material, "SiO2");
  EXPECT_EQ(input->seeds[1].material, "material_42");
  EXPECT_EQ(input->seeds[2].material, "Si");
  ASSERT_TRUE(input->field);
  EXPECT_EQ(input->field->arrays[0].name, "boron");
  EXPECT_EQ(input->field->arrays[1].name, "value_99");
  const auto& corners = input->field->triangles[2];
  EXPECT_EQ(input->field->arrays[0].values[corners[1]], 3e15);
  EXPECT_TRUE(std::isnan(input->field->arrays[0].values[corners[2]]));
}

TEST(ReadSuprem, ValuesMayCountFromZero) {
  const Result<Input> input = parse_suprem(replaced(kStr, "n 1 3 0 0\n", "n 0 3 0 0\n"), "a.str");
  ASSERT_TRUE(input) << input.error().message;
  const auto& corners = input->field->triangles[2];
  EXPECT_EQ(input->field->arrays[0].values[corners[1]], 2e15);  // that of node 3
  // Nothing is behind the largest number.
  const std::string largest =
      replaced(replaced(kStr, "n 1 3 0 0\n", "n 0 3 0 0\n"), "n 2 3", "n 9223372036854775807 3");
  EXPECT_TRUE(parse_suprem(largest, "a.str"));
}

}  // namespace
}  // namespace cover
