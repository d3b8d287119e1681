// Several files are one geometry: what one file with all of it is.
#include <cover/join_inputs.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <cover/cover_mesh.hpp>

#include "base/numbers.hpp"
#include "io/input/map_words.hpp"

namespace cover {
namespace {

Input square(double x, const char* material, const char* source) {
  Input input;
  input.source = source;
  InputPolygon polygon;
  polygon.material = material;
  polygon.rings = {{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}};
  input.polygons.push_back(polygon);
  return input;
}

TEST(JoinInputs, LaterFilesArePaintedOverEarlierOnes) {
  const Result<Input> joined =
      join_inputs({square(0, "a", "x.geojson"), square(0.5, "b", "y.geojson")});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->source, "x.geojson, y.geojson");
  const Result<Prepared> prepared = prepare(*joined);
  ASSERT_TRUE(prepared);
  ASSERT_EQ(prepared->table.regions.size(), 2U);
  double a = 0, b = 0;
  for (const Region& region : prepared->table.regions)
    (region.material_name == "a" ? a : b) += region.area;
  EXPECT_DOUBLE_EQ(a, 0.5);
  EXPECT_DOUBLE_EQ(b, 1);
}

TEST(JoinInputs, InputsWithoutASourceAreNumbered) {
  Input one = square(0, "a", ""), other = square(2, "b", "y.geojson");
  one.warnings = {"odd"};
  const Result<Input> joined = join_inputs({other, one});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->source, "y.geojson, input 2");
  EXPECT_EQ(joined->warnings, std::vector<std::string>{"input 2: odd"});
  EXPECT_EQ(join_inputs({one})->source, "");
}

TEST(JoinInputs, WhatIsEmptyIsLeftOut) {
  Input full = square(0, "a", "x.geojson"), empty, other;
  full.system = "EPSG:25832";
  full.unit = "m";
  empty.source = "e.geojson";
  other.source = "f.gpkg";
  for (const auto& inputs : {std::vector{full, empty}, std::vector{empty, full}}) {
    const Result<Input> joined = join_inputs(inputs);
    ASSERT_TRUE(joined) << joined.error().message;
    EXPECT_EQ(joined->source, "x.geojson");
    EXPECT_EQ(joined->unit, "m");
    EXPECT_EQ(joined->warnings,
              std::vector<std::string>{"e.geojson: no polygon, line or point in it"});
  }
  const Result<Input> nothing = join_inputs({empty, other});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::syntax);
  EXPECT_EQ(nothing.error().message,
            "e.geojson: no polygon, line or point in it; f.gpkg: no polygon, line or point in it");
}

TEST(JoinInputs, NumbersOfFeaturesThatCollideAreToldOnce) {
  std::vector<Input> inputs;
  for (const char* source : {"x", "y", "z"}) {
    inputs.push_back(square(static_cast<double>(inputs.size()), "a", source));
    inputs.back().polygons[0].feature = 1;
    inputs.back().attributes = {{"fid", false, {}, {7}}, {"use", false, {}, {7}}};
  }
  EXPECT_EQ(join_inputs(inputs)->warnings,
            std::vector<std::string>{
                "'fid' is 7 in y and in a file before it: each file numbers its features anew"});
  for (Input& input : inputs) input.attributes[0].values[0] = input.polygons[0].rings[0][0].x;
  EXPECT_TRUE(join_inputs(inputs)->warnings.empty());
}

TEST(JoinInputs, SegmentsAndCirclesKeepTheirPoints) {
  Input one, other;
  one.points = {{0, 0}, {1, 0}};
  one.segments.push_back({0, 1, 5, 7, 0, "top", 0});
  one.circles.push_back({{9, 9}, 1});
  other.points = {{2, 0}, {3, 0}, {4, 0}};
  other.point_markers = {1, 2, 3};
  other.segments.push_back({1, 2, 6, 8, 0, "low", 1});
  other.circles.push_back({{5, 5}, 2});
  InputLine line{"arc", {{0, 0}, {1, 1}}, 0, {1, 0}};
  other.lines.push_back(line);
  const Result<Input> joined = join_inputs({one, other});
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->points.size(), 5U);
  EXPECT_EQ(joined->point_markers, (std::vector<int>{0, 0, 1, 2, 3}));
  EXPECT_TRUE(joined->point_ids.empty());
  ASSERT_EQ(joined->segments.size(), 2U);
  EXPECT_EQ(joined->segments[1].a, 3U);
  EXPECT_EQ(joined->segments[1].b, 4U);
  EXPECT_EQ(joined->segments[1].circle, 2U);
  EXPECT_EQ(joined->lines[0].circles, (std::vector<std::uint32_t>{2, 0}));
  EXPECT_EQ(joined->circles[1].radius, 2);
}

TEST(JoinInputs, MadeUpMaterialsStayApart) {
  Input named = square(2, "feature_0", "y.geojson");
  named.polygons[0].region = "lake";
  const Result<Input> joined =
      join_inputs({square(0, "feature_0", "x.geojson"), square(1, "feature_0", "y.geojson"), named,
                   square(3, "feature_x", "z.geojson")});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->polygons[0].material, "feature_0");
  EXPECT_EQ(joined->polygons[1].material, "2:feature_0");
  EXPECT_EQ(joined->polygons[2].material, "feature_0");
  EXPECT_EQ(joined->polygons[3].material, "feature_x");
  EXPECT_EQ(joined->source, "x.geojson, y.geojson, y.geojson and 1 more");
}

TEST(JoinInputs, NamesOfPointsStayWithThem) {
  Input one = square(0, "a", "x"), other = square(1, "b", "y");
  one.points = {{0.5, 0.5}};
  other.points = {{1.25, 0.5}, {1.5, 0.5}};
  one.point_names = {{0, "well"}};
  other.point_names = {{1, "spring"}};
  other.seeds_may_miss = true;
  const Result<Input> joined = join_inputs({one, other});
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->point_names.size(), 2U);
  EXPECT_EQ(joined->points[joined->point_names[0].point], (Point{0.5, 0.5}));
  EXPECT_EQ(joined->point_names[1].name, "spring");
  EXPECT_EQ(joined->points[joined->point_names[1].point], (Point{1.5, 0.5}));
  EXPECT_TRUE(joined->seeds_may_miss);
}

TEST(JoinInputs, RefusesWhatDoesNotGoTogether) {
  Input metres = square(0, "a", "x"), other = square(1, "b", "y");
  other.unit = "nm";
  const Result<Input> units = join_inputs({metres, other});
  ASSERT_FALSE(units);
  EXPECT_NE(units.error().message.find("x and y"), std::string::npos);
  other = square(1, "b", "y");
  other.void_rule = VoidRule::unseeded_faces;
  EXPECT_TRUE(join_inputs({metres, other}));
  metres.points = other.points = {{0, 0}, {1, 0}};
  metres.segments.push_back({0, 1, 0, 0, 0, "", 0});
  other.segments = metres.segments;
  EXPECT_FALSE(join_inputs({metres, other}));
}

TEST(JoinInputs, UnitsThatDifferAreToldWithWhatMakesThemOne) {
  Input one = square(0, "a", "x"), other = square(1, "b", "y");
  const auto message = [&](const char* unit, const char* of_drawing) {
    one.unit = "mm";
    other.unit = unit;
    other.other_unit = of_drawing;
    const Result<Input> joined = join_inputs({one, other});
    return joined ? std::string() : joined.error().message;
  };
  const std::string head =
      "x and y cannot be taken together: their units of length are not the same, ";
  EXPECT_EQ(message("", "inches"), head +
                                       "mm and inches: multiply the coordinates of y by 25.4 "
                                       "first, which makes them mm; the option unit takes all "
                                       "numbers as they are");
  EXPECT_NE(message("m", "").find("of y by 1000 first, which makes them mm;"), std::string::npos);
  const std::string advice = "the option unit (--unit mm) gives all of them one";
  EXPECT_EQ(message("", ""), head + "mm and none: " + advice);
  one.system = "EPSG:25832";
  EXPECT_EQ(message("", ""),
            head + "mm and none: y says no coordinate system, as a .prj or 'crs' does; " + advice);
  one.system.clear();
  other.unit = "";
  other.other_unit = "feet";
  const Result<Input> joined = join_inputs({other, one});
  ASSERT_FALSE(joined);
  EXPECT_NE(joined.error().message.find("feet and mm: multiply the coordinates of y by 304.8 "),
            std::string::npos);
}

TEST(JoinInputs, AttributesStayWithTheirFeatures) {
  Input one = square(0, "a", "x"), plain = square(1, "b", "y"), other = square(2, "c", "z");
  one.polygons[0].feature = other.polygons[0].feature = 1;
  one.attributes = {{"use", true, {"road"}, {1}}, {"height", false, {}, {3}}};
  other.attributes = {{"use", true, {"wood", "road"}, {1, 2}}, {"height", true, {"low"}, {1, 0}}};
  const Result<Input> joined = join_inputs({one, plain, other});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->polygons[0].feature, 1U);
  EXPECT_EQ(joined->polygons[1].feature, 0U);
  EXPECT_EQ(joined->polygons[2].feature, 2U);
  ASSERT_EQ(joined->attributes.size(), 2U);
  using Words = std::vector<std::string>;
  using Values = std::vector<double>;
  EXPECT_EQ(joined->attributes[0].words, (Words{"road", "wood"}));
  EXPECT_EQ(joined->attributes[0].values, (Values{1, 2, 1}));
  EXPECT_EQ(joined->attributes[1].words, (Words{"3", "low"}));
  EXPECT_EQ(joined->attributes[1].values, (Values{1, 2, 0}));
  const Result<Input> later = join_inputs({plain, other});
  ASSERT_TRUE(later);
  EXPECT_EQ(later->polygons[1].feature, 1U);
  EXPECT_EQ(later->attributes[0].values, (Values{1, 2}));
}

TEST(JoinInputs, TextsThatSpellNumbersAreNumbersAmongNumbers) {
  Input one = square(0, "a", "x"), other = square(1, "b", "y");
  one.polygons[0].feature = other.polygons[0].feature = 1;
  one.attributes = {{"K", true, {"1e-4"}, {1, 0}}};
  other.attributes = {{"K", false, {}, {1e-5}}};
  const auto joined = [&] {
    const Result<Input> both = join_inputs({one, other});
    return both ? *both : Input();
  };
  const Input numbers = joined();
  ASSERT_EQ(numbers.attributes.size(), 1U);
  EXPECT_FALSE(numbers.attributes[0].is_text);
  EXPECT_EQ(numbers.attributes[0].values[0], 1e-4);
  EXPECT_TRUE(std::isnan(numbers.attributes[0].values[1]));
  EXPECT_EQ(numbers.attributes[0].values[2], 1e-5);
  EXPECT_TRUE(numbers.warnings.empty());

  one.attributes[0].words = {"low"};
  EXPECT_EQ(joined().warnings,
            std::vector<std::string>{"the attribute 'K' of y has numbers, and that of files before "
                                     "it words: its array numbers the different values 1, 2, ..."});
  one.attributes[0].words = {"9007199254740993"};
  EXPECT_EQ(joined().warnings,
            std::vector<std::string>{
                "the attribute 'K' of y has numbers, and that of files before it whole numbers "
                "that no double holds, as 9007199254740993: its array numbers the different values "
                "1, 2, ..."});
  one.attributes[0].words = {"low"};
  other.attributes = {{"K", false, {}, {kNoNumber}}};
  EXPECT_TRUE(joined().warnings.empty()) << "nothing is no number";
  one.attributes[0].words = {"1e-4"};
  other.attributes = {{"K", true, {"2"}, {1}}};
  EXPECT_EQ(joined().warnings,
            std::vector<std::string>{
                "the attribute 'K' is text wherever it is, as '1e-4', though it spells numbers: "
                "its array numbers the different texts 1, 2, ..."});
}

TEST(JoinInputs, ChangesNameTheFilesOfSegmentsAndPolygons) {
  Input one = square(0, "a", "x.dxf"), other = square(1, "b", "y.dxf");
  other.polygons[0].rings[0].push_back({1, 1});
  for (Input* input : {&one, &other}) {
    input->points = {{0, 3}, {1, 3}};
    input->segments.resize(1);
    input->segments[0].b = 1;
  }
  one.changes = {{Change::Kind::welded, "moved", {}, {}}};
  const Result<Input> joined = join_inputs({one, other, square(9, "c", "z.dxf")});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->files, (std::vector<std::string>{"x.dxf", "y.dxf", "z.dxf"}));
  const Result<Prepared> prepared = prepare(*joined);
  ASSERT_TRUE(prepared);
  std::string told;
  for (const Change& change : prepared->report.changes) told += change.message + '\n';
  EXPECT_NE(told.find("x.dxf: moved\n"), std::string::npos) << told;
  EXPECT_NE(told.find(" of y.dxf is the same as segment 0 of x.dxf\n"), std::string::npos) << told;
  const Result<Input> again = join_inputs({square(8, "d", "w.dxf"), *joined});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->files, (std::vector<std::string>{"w.dxf", "x.dxf", "y.dxf", "z.dxf"}));
  EXPECT_EQ(again->segments[1].file, 2U);
  EXPECT_EQ(again->polygons[3].file, 3U);
  EXPECT_EQ(again->changes[0].message, "x.dxf: moved");
  EXPECT_TRUE(join_inputs({one})->files.empty());
}

TEST(JoinInputs, ChangesOfArcsNameTheirFile) {
  Input arc = square(0, "a", "x.dxf"), line = square(5, "b", "y.dxf");
  arc.points = {{0, 3}, {1, 4}};  // a quarter around (1, 3)
  arc.segments.resize(1);
  arc.segments[0].b = arc.segments[0].circle = 1;
  arc.circles = {{{1, 3}, 1}};
  line.lines = {{"probe", {{1, 3}, {0.4, 3.8}}}};
  const Result<Input> joined = join_inputs({arc, line});
  ASSERT_TRUE(joined);
  const Result<Prepared> prepared = prepare(*joined);
  ASSERT_TRUE(prepared) << prepared.error().message;
  std::string told;
  for (const Change& change : prepared->report.changes) told += change.message + '\n';
  EXPECT_NE(told.find("the arc of segment 0 of x.dxf from (0, 3) to (1, 4) was split"),
            std::string::npos)
      << told;
}

TEST(JoinInputs, WarningsNameTheirFile) {
  Input one = square(0, "a", "x"), other = square(1, "b", "y");
  other.warnings = {"1 geometry is a surface in space: left out"};
  const Result<Input> joined = join_inputs({one, other});
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->warnings.size(), 1U);
  EXPECT_EQ(joined->warnings[0], "y: 1 geometry is a surface in space: left out");
}

TEST(JoinInputs, DegreesAreToldOnce) {
  Input one = square(0, "a", "x"), other = square(1, "b", "y"), third = square(2, "c", "z");
  other.warnings = third.warnings = {kInDegrees};
  const Result<Input> joined = join_inputs({one, other, third});
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->warnings, std::vector<std::string>{std::string("y: ") + kInDegrees});
}

TEST(JoinInputs, WhatNoInputHasIsRefused) {
  Input rivers = square(0, "a", "rivers.shp"), parcels = square(1, "b", "parcels.shp");
  rivers.asked = {{"material_field", "use", false, "the layer 'rivers' has no attribute 'use'"},
                  {"name_field", "nr", false, "the layer 'rivers' has no attribute 'nr'"}};
  parcels.asked = {{"material_field", "use", true, ""}, {"name_field", "nr", true, ""}};
  EXPECT_TRUE(join_inputs({rivers, parcels}));
  EXPECT_TRUE(join_inputs({parcels, rivers}));
  parcels.asked[0] = {"material_field", "use", false, "the layer 'p' has no attribute 'use'"};
  const Result<Input> joined = join_inputs({rivers, parcels, square(2, "c", "z.poly")});
  ASSERT_FALSE(joined);
  EXPECT_EQ(joined.error().code, ErrorCode::bad_option);
  EXPECT_EQ(joined.error().message,
            "material_field: rivers.shp: the layer 'rivers' has no attribute 'use'; parcels.shp: "
            "the layer 'p' has no attribute 'use'");
}

TEST(JoinInputs, NothingIsNoGeometry) {
  const Result<Input> joined = join_inputs({});
  ASSERT_FALSE(joined);
  EXPECT_EQ(joined.error().code, ErrorCode::bad_option);
}

}  // namespace
}  // namespace cover
