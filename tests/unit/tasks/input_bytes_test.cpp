// Geometry and what readers are told, there and back as bytes.
#include <cover/read_elsewhere.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace cover {
namespace {

/// With something in every member.
Input everything() {
  Input in;
  in.source = "a file";
  in.unit = "nm";
  in.scale = 1e-9;
  in.warnings = {"a warning", ""};
  in.points = {{0, 0}, {1, 0.1}, {-0.0, 1e300}};
  in.point_ids = {7, 8, -9};
  in.point_lines = {1, 2, 3};
  in.point_markers = {0, 1, 0};
  in.segments = {{0, 1, 3, 12, 5, "gate", 1, 1}, {1, 2, 0, 13, 6, "", 0}};
  in.holes = {{{0.5, 0.5}, 4, 11, "labels"}};
  in.seeds = {{{0.25, 0.5}, "oxide", "left", 0.1, 5, 12, 1},
              {{0.5, 0.25}, "", "", {}, 6, 13, 0, "notes"}};
  in.void_rule = VoidRule::unseeded_faces;
  in.polygons = {
      {{{{0, 0}, {1, 0}, {0, 1}}, {}}, "silicon", "well", 2.5, 9, {}, {{1, 0, 0}}, 2, 1}};
  in.lines = {{"contact", {{0, 0}, {1, 1}}, 3, {1, 0}, 1}};
  in.field = std::make_shared<PlaneField>(PlaneField{
      {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {"silicon"}, {{"doping", {1e15, 2e15, -1e18}}}});
  in.attributes = {{"people", false, {}, {1, std::numeric_limits<double>::infinity()}},
                   {"name", true, {"here", "there"}, {1, 2}}};
  in.circles = {{{0.5, 0.5}, 0.25}};
  in.periodic = {{"left", "right", PeriodicRule::Map::rotation, {1, 2}, Angle::degrees(30)}};
  in.layers = {{"wall", "air", 0.01, 1.2, 4}};
  in.changes = {{Change::Kind::welded, "moved", {{1, 2}}, {{InputKind::segment, 3}}}};
  in.system = "EPSG:25832";
  in.asked = {{"material_field", "use", true, "none has it"}};
  in.point_names = {{2, "well"}};
  in.seeds_may_miss = true;
  in.other_unit = "inches";
  in.is_picture = true;
  in.fields = {"use"};
  in.files = {"a", "file"};
  return in;
}

TEST(InputBytes, AllThatAnInputHasComesBack) {
  const Bytes bytes = bytes_of_input(everything());
  const Result<Input> back = input_of_bytes(bytes);
  ASSERT_TRUE(back) << back.error().message;
  const Input in = everything();
  EXPECT_EQ(back->points, in.points);
  EXPECT_TRUE(std::signbit(back->points[2].x));
  EXPECT_EQ(back->segments[0].name, "gate");
  EXPECT_EQ(back->segments[1].id, 13);
  EXPECT_EQ(back->segments[0].file, 1U);
  EXPECT_EQ(back->polygons[0].file, 1U);
  EXPECT_EQ(back->lines[0].file, 1U);
  EXPECT_EQ(back->files, in.files);
  EXPECT_EQ(back->seeds[0].size, in.seeds[0].size);
  EXPECT_EQ(back->seeds[1].size, std::nullopt);
  EXPECT_EQ(back->polygons[0].rings, in.polygons[0].rings);
  EXPECT_EQ(back->polygons[0].priority, 2.5);
  EXPECT_EQ(back->attributes[1].words, in.attributes[1].words);
  ASSERT_NE(back->field, nullptr);
  EXPECT_EQ(back->field->arrays[0].values, in.field->arrays[0].values);
  EXPECT_EQ(back->changes[0].where, in.changes[0].where);
  EXPECT_EQ(back->system, in.system);
  ASSERT_EQ(back->point_names.size(), 1U);
  EXPECT_EQ(back->point_names[0].point, 2U);
  EXPECT_EQ(back->point_names[0].name, "well");
  EXPECT_TRUE(back->seeds_may_miss);
  ASSERT_EQ(back->holes.size(), 1U);
  EXPECT_EQ(back->holes[0].label_layer, "labels");
  EXPECT_EQ(back->seeds[1].label_layer, "notes");
  EXPECT_EQ(back->other_unit, "inches");
  EXPECT_EQ(back->asked[0].missing, "none has it");
  // All other members, too: what is made of it has the same bytes.
  EXPECT_EQ(bytes_of_input(*back), bytes);
}

TEST(InputBytes, AnErrorComesBackAsItself) {
  const Error error{ErrorCode::syntax, "line 3: no number", {{1, 2}}, {{InputKind::point, 4}}};
  const Result<Input> back = input_of_bytes(bytes_of_input(error));
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, error.code);
  EXPECT_EQ(back.error().message, error.message);
  EXPECT_EQ(back.error().where, error.where);
}

TEST(InputBytes, FilesComeBackWithHowTheyAreRead) {
  FilesToRead files{{"a.geojson", "b.geojson"}, {}};
  files.options.layers = {"68/20"};
  files.options.window = Window{{0, 0}, {1, 2}};
  files.options.smooth = false;
  files.options.speckle = 5;
  files.options.crs = "EPSG:25832";
  files.options.is_one_of_several = true;
  const Result<FilesToRead> back = files_of_bytes(bytes_of_files(files));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->paths, files.paths);
  EXPECT_EQ(back->options.layers, files.options.layers);
  EXPECT_EQ(back->options.window->high, files.options.window->high);
  EXPECT_FALSE(back->options.smooth);
  EXPECT_EQ(back->options.speckle, 5);
  EXPECT_EQ(back->options.crs, files.options.crs);
  EXPECT_TRUE(back->options.is_one_of_several);
}

TEST(InputBytes, APartIsAnError) {
  const Bytes bytes = bytes_of_input(everything());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(input_of_bytes(std::span(bytes).first(size))) << size;
}

}  // namespace
}  // namespace cover
