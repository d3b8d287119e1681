#include <cover/units.hpp>

#include <gtest/gtest.h>

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

TEST(ScaleInput, TakesPowersOfTwoAndNothingElse) {
  Input input = everything();
  ASSERT_TRUE(scale_input(input, 0x1p-70));
  EXPECT_EQ(input.points[0].x, 45 * 0x1p-70);
  for (const double factor : {3.0, 0.0, -1.0, 1e-9 * 1.5, 1e40}) {
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

TEST(IsLengthUnit, KnowsFive) {
  for (const char* unit : {"nm", "um", "mm", "cm", "m"}) EXPECT_TRUE(is_length_unit(unit));
  EXPECT_FALSE(is_length_unit("km"));
  EXPECT_FALSE(is_length_unit(""));
}

}  // namespace
}  // namespace cover
