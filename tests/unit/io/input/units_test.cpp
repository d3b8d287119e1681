#include <cover/units.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cover {
namespace {

Input everything() {
  Input input;
  input.source = "a.json";
  input.points = {{45, -3}};
  input.holes.push_back({{1, 2}, 0, 0});
  input.seeds.push_back({{3, 4}, "", "", 5.0, 0, 0});
  input.polygons.push_back({{{{6, 7}}}, "", "", 9.0, 0, 10.0});
  input.field = std::make_shared<const PlaneField>(PlaneField{{{11, 12}}, {}, {}, {{"u", {13}}}});
  input.lines.push_back({"", {{8, 9}}, 0});
  return input;
}

TEST(ScaleInput, RoundsPowersOfTenOnce) {
  Input input = everything();
  ASSERT_TRUE(scale_input(input, 1e-9));
  EXPECT_EQ(input.scale, 1e-9);
  EXPECT_EQ(input.points[0], (Point{45e-9, -3e-9}));
  EXPECT_EQ(input.holes[0].at, (Point{1e-9, 2e-9}));
  EXPECT_EQ(input.seeds[0].at, (Point{3e-9, 4e-9}));
  EXPECT_EQ(input.seeds[0].size, 5e-9);
  EXPECT_EQ(input.polygons[0].rings[0][0], (Point{6e-9, 7e-9}));
  EXPECT_EQ(input.polygons[0].priority, 9.0);
  EXPECT_EQ(input.polygons[0].size, 10e-9);
  EXPECT_EQ(input.field->points[0], (Point{11e-9, 12e-9}));
  EXPECT_EQ(input.field->arrays[0].values[0], 13);
  EXPECT_EQ(input.lines[0].points[0], (Point{8e-9, 9e-9}));
}

TEST(ScaleInput, TakesPowersOfTwoExactly) {
  Input input = everything();
  ASSERT_TRUE(scale_input(input, 0x1p-70));
  EXPECT_EQ(input.points[0].x, 45 * 0x1p-70);
  EXPECT_TRUE(input.warnings.empty());
}

/// Such a size stands for none; a check of the input would refuse an infinite one.
TEST(ScaleInput, SizesStayFinite) {
  Input input = everything();
  input.seeds[0].size = 1e308;
  input.polygons[0].size = 1e308;
  ASSERT_TRUE(scale_input(input, 1000));
  EXPECT_EQ(input.seeds[0].size, std::numeric_limits<double>::max());
  EXPECT_EQ(input.polygons[0].size, std::numeric_limits<double>::max());
}

TEST(ScaleInput, TellsHowManyCoordinatesOtherFactorsRound) {
  Input inches = everything();
  ASSERT_TRUE(scale_input(inches, 25.4));
  EXPECT_EQ(inches.scale, 25.4);
  EXPECT_EQ(inches.points[0], (Point{45 * 25.4, -3 * 25.4}));
  EXPECT_EQ(inches.seeds[0].size, 5 * 25.4);
  ASSERT_EQ(inches.warnings.size(), 1U);
  // 10 coordinates, of which 1, 2, 4 and 8 need no more digits than the factor has.
  EXPECT_EQ(inches.warnings[0].substr(0, 43), "6 of 10 coordinates times 25.4 are rounded ");

  Input exact = everything();
  ASSERT_TRUE(scale_input(exact, 3));
  EXPECT_EQ(exact.points[0], (Point{135, -9}));
  EXPECT_TRUE(exact.warnings.empty());
}

TEST(ScaleInput, RefusesWhatIsNoFactor) {
  Input input = everything();
  for (const double factor : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const Status status = scale_input(input, factor);
    ASSERT_FALSE(status.has_value()) << factor;
    EXPECT_EQ(status.error().code, ErrorCode::bad_option);
  }
}

TEST(ScaleInput, SaysWhereNumbersBecomeTooLarge) {
  Input input = everything();
  const Status status = scale_input(input, 0x1p1020);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::non_finite_coordinate);
}

/// The unit and the warnings of an input in `unit` that is read with these options.
std::pair<std::string, std::vector<std::string>> units(const char* unit, double scale,
                                                       const char* option) {
  Input input;
  input.unit = unit;
  ReadOptions options;
  options.scale = scale;
  options.unit = option;
  EXPECT_TRUE(apply_units(input, options));
  return {input.unit, input.warnings};
}

TEST(ApplyUnits, TheUnitFollowsTheScale) {
  using Found = std::pair<std::string, std::vector<std::string>>;
  EXPECT_EQ(units("um", 1000, ""), Found("nm", {}));
  EXPECT_EQ(units("mm", 1e-3, ""), Found("m", {}));
  EXPECT_EQ(units("cm", 10, ""), Found("mm", {}));
  EXPECT_EQ(units("mm", 1, ""), Found("mm", {}));
  EXPECT_EQ(units("", 1000, ""), Found("", {}));
  EXPECT_EQ(units("um", 1000, "nm"), Found("nm", {}));
  EXPECT_EQ(units("mm", 25.4, "um"), Found("um", {}));
  for (const double scale : {25.4, 10.0, 1e3 + 1})
    EXPECT_EQ(units("um", scale, "").second.size(), 1U) << scale;
  EXPECT_EQ(units("um", 25.4, ""),
            Found("", {"lengths in um times 25.4 are in no unit with a name: the option unit may "
                       "give them one"}));
}

TEST(ApplyUnits, AUnitThatIsNotTheInputsIsTold) {
  const auto [unit, warnings] = units("um", 1, "mm");
  EXPECT_EQ(unit, "mm");
  EXPECT_EQ(warnings,
            std::vector<std::string>{"the option unit says mm, and the input um: mm is taken"});
  EXPECT_EQ(units("um", 1000, "um").second,
            std::vector<std::string>{
                "the option unit says um, and the input um, which times 1000 is nm: um is taken"});
  EXPECT_EQ(units("m", 0.001, "m").second,
            std::vector<std::string>{"the option unit says m, and lengths in m times 0.001 are not "
                                     "in it: m is taken"});
}

TEST(IsLengthUnit, KnowsFive) {
  for (const char* unit : {"nm", "um", "mm", "cm", "m"}) EXPECT_TRUE(is_length_unit(unit));
  EXPECT_FALSE(is_length_unit("km"));
  EXPECT_FALSE(is_length_unit(""));
}

/// What an input in such a unit is warned of with these options, and its unit.
std::pair<std::string, std::vector<std::string>> other_units(const char* other, double scale,
                                                             const char* option) {
  Input input;
  input.other_unit = other;
  ReadOptions options;
  options.scale = scale;
  options.unit = option;
  EXPECT_TRUE(apply_units(input, options));
  return {input.unit, input.warnings};
}

TEST(ApplyUnits, TellsWhatMakesUnitsOfDrawingsOurs) {
  using Found = std::pair<std::string, std::vector<std::string>>;
  EXPECT_EQ(other_units("inches", 1, ""),
            Found("", {"the drawing is in inches: --scale 25.4 --unit mm makes it mm"}));
  EXPECT_EQ(other_units("feet", 1, ""),
            Found("", {"the drawing is in feet: --scale 0.3048 --unit m makes it m"}));
  EXPECT_EQ(other_units("inches", 1, "cm"),
            Found("cm", {"the option unit says cm, and the drawing is in inches: --scale 2.54 "
                         "makes it cm"}));
  EXPECT_EQ(other_units("mils", 1, "mm"),
            Found("mm", {"the option unit says mm, and the drawing is in mils: --scale 0.0254 "
                         "makes it mm"}));
  EXPECT_EQ(other_units("inches", 25.4, "mm"), Found("mm", {}));
}

}  // namespace
}  // namespace cover
