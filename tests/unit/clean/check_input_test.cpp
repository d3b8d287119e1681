// What a program fills in by hand may contradict itself: that is an error.
#include "clean/check_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <cover/cover_mesh.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A unit square with a seed in its middle.
Input seeded_square() {
  Input input = testing::input_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  input.source = "square";
  RegionSeed seed;
  seed.at = {0.5, 0.25};
  seed.material = "Si";
  seed.id = 7;
  input.seeds = {seed};
  return input;
}

/// A painted unit square.
Input painted_square() {
  Input input;
  InputPolygon polygon;
  polygon.material = "Si";
  polygon.id = 9;
  polygon.rings = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  input.polygons = {polygon};
  return input;
}

/// A field on the unit square.
PlaneField doping() {
  PlaneField field;
  field.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  field.triangles = {{0, 1, 2}, {0, 2, 3}};
  field.arrays = {{"doping", {1, 2, 3, kNaN}}};
  return field;
}

/// Meshing `input` fails with `code` and says `words`.
void expect_error(const Input& input, ErrorCode code, const std::string& words) {
  const Result<Output> output = cover_mesh(input);
  ASSERT_FALSE(output) << words;
  EXPECT_EQ(output.error().code, code) << output.error().message;
  EXPECT_NE(output.error().message.find(words), std::string::npos) << output.error().message;
}

TEST(CheckInput, SizesOfRegionsAreLengths) {
  for (const double size : {kNaN, kInfinite, 0.0, -1.0}) {
    Input seeded = seeded_square(), painted = painted_square();
    seeded.seeds[0].size = painted.polygons[0].size = size;
    expect_error(seeded, ErrorCode::bad_option, "square: the size of region seed 7 at (0.5, 0.25)");
    expect_error(seeded, ErrorCode::bad_option, "but must be above 0");
    expect_error(painted, ErrorCode::bad_option, "the size of polygon 9 is");
    const Error error = cover_mesh(seeded).error();
    ASSERT_EQ(error.inputs.size(), 1U);
    EXPECT_EQ(error.inputs[0].kind, InputKind::region_seed);
    EXPECT_EQ(error.inputs[0].id, 7);
    EXPECT_EQ(error.where, (std::vector<Point>{{0.5, 0.25}}));
  }
  Input seeded = seeded_square();
  seeded.seeds[0].size = 0.5;
  EXPECT_TRUE(cover_mesh(seeded));
}

TEST(CheckInput, PrioritiesAreInAnOrder) {
  Input painted = painted_square();
  painted.polygons[0].priority = kNaN;
  expect_error(painted, ErrorCode::bad_option, "the priority of polygon 9 is no number");
  painted.polygons[0].priority = -kInfinite;
  EXPECT_TRUE(cover_mesh(painted));
}

TEST(CheckInput, ArraysByPointAreAsLongAsThePoints) {
  for (const int which : {0, 1, 2}) {
    Input input = seeded_square();
    if (which == 0) input.point_ids = {1, 2, 3};
    if (which == 1) input.point_lines = {1};
    if (which == 2) input.point_markers = {1, 2, 3, 4, 5};
    expect_error(input, ErrorCode::id_out_of_range, "for 4 points");
  }
}

TEST(CheckInput, NamesAreThoseOfPoints) {
  Input input = seeded_square();
  input.point_names = {{3, "corner"}, {4, "well"}};
  expect_error(input, ErrorCode::id_out_of_range, "the name 'well' is of point 4, which is not");
  input.point_names.pop_back();
  EXPECT_TRUE(cover_mesh(input));
}

TEST(CheckInput, FeaturesHaveTheirAttributes) {
  Input input = seeded_square(), painted = painted_square();
  input.seeds[0].feature = painted.polygons[0].feature = 9;
  expect_error(input, ErrorCode::id_out_of_range, "region seed 7 has the feature 9, but");
  expect_error(painted, ErrorCode::id_out_of_range, "polygon 9 has the feature 9, but");
  input.seeds[0].feature = 2;
  input.attributes = {{"year", false, {}, {1, 2}}, {"owner", true, {"a"}, {1}}};
  expect_error(input, ErrorCode::id_out_of_range, "has the feature 2, but");
  input.attributes[1].values = {0, 1};
  EXPECT_TRUE(cover_mesh(input));
}

TEST(CheckInput, TextIsAWordThatThereIs) {
  for (const double value : {kNaN, -1.0, 0.5, 3.0, kInfinite}) {
    Input input = seeded_square();
    input.seeds[0].feature = 1;
    input.attributes = {{"owner", true, {"a", "b"}, {value}}};
    expect_error(input, ErrorCode::id_out_of_range, "the attribute 'owner' of feature 1 is");
  }
}

TEST(CheckInput, FieldsAreWholeAndFinite) {
  const auto expect = [](const PlaneField& field, ErrorCode code, const std::string& words) {
    Input input = seeded_square();
    input.field = std::make_shared<const PlaneField>(field);
    expect_error(input, code, words);
  };
  PlaneField field = doping();
  field.arrays[0].values.pop_back();
  expect(field, ErrorCode::id_out_of_range, "3 values of the field 'doping' for 4 points");
  field = doping();
  field.triangles[1][2] = 4;
  expect(field, ErrorCode::id_out_of_range, "triangle 1 of the field has the point 4");
  field = doping();
  field.points[2].y = kNaN;
  expect(field, ErrorCode::non_finite_coordinate, "point 2 of the field is not finite");
  field = doping();
  field.material = {"Si"};
  expect(field, ErrorCode::id_out_of_range, "1 materials of the field for 2 triangles");
  Input input = seeded_square();
  input.field = std::make_shared<const PlaneField>(doping());
  EXPECT_TRUE(cover_mesh(input)) << "a value may be missing";
  field = doping();
  field.triangles.clear();
  input.field = std::make_shared<const PlaneField>(field);
  EXPECT_TRUE(cover_mesh(input)) << "the nearest point counts";
}

TEST(CheckInput, MessagesBeginWithTheSourceIfThereIsOne) {
  EXPECT_TRUE(cover_mesh(Input()).error().message.starts_with("the input: there are no segments"));
}

TEST(CheckInput, ScalesAndUnitsMeanSomething) {
  for (const double scale : {kNaN, kInfinite, 0.0, -1.0}) {
    Input input = seeded_square();
    input.scale = scale;
    expect_error(input, ErrorCode::bad_option, "square: the scale is ");
    expect_error(input, ErrorCode::bad_option, ", but must be a number above 0");
  }
  Input input = seeded_square();
  input.unit = "furlong";
  expect_error(input, ErrorCode::bad_option,
               "square: the unit is 'furlong', but must be nm, um, mm, cm or m, or empty");
  input.unit = "um";
  input.scale = 1e-3;
  EXPECT_TRUE(cover_mesh(input));
}

}  // namespace
}  // namespace cover
