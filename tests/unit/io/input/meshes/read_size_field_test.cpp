#include <cover/read_size_field.hpp>

#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cmath>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::TemporaryFolder;

/// A legacy file of a quadrangle, a triangle and a line.
std::string legacy(std::string_view arrays) {
  return fmt::format(R"(# vtk DataFile Version 3.0
sizes
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 7  1 0 7  1 1 7  0 1 7  2 0 7
CELLS 3 12
4 0 1 2 3
3 1 4 2
2 0 1
CELL_TYPES 3
9 5 3
POINT_DATA 5
{})",
                     arrays);
}

std::string scalars(std::string_view name, std::string_view values) {
  return fmt::format("SCALARS {} double 1\nLOOKUP_TABLE default\n{}\n", name, values);
}

Result<SizeSamples> read_sizes(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  return read_size_field(folder.write(name, text));
}

TEST(ReadSizeField, TheOnlyArrayOfAnyName) {
  const auto field = read_sizes("h.vtk", legacy(scalars("spacing", "1 2 3 4 5")));
  ASSERT_TRUE(field) << field.error().message;
  EXPECT_EQ(field->points.size(), 5U);
  EXPECT_EQ(field->points[4], (Point{2, 0}));
  EXPECT_EQ(field->sizes, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(field->triangles.size(), 3U);
  const SizeFunction size = size_function(*field, 100).value();
  EXPECT_DOUBLE_EQ(size({1.5, 0.25}), (2 + 5) / 2.0 + 0.25 * (3 - 2));
}

TEST(ReadSizeField, ByNameAmongSeveral) {
  const std::string several = scalars("u", "9 9 9 9 9") + scalars("h", "1 2 3 4 5");
  const auto field = read_sizes("h.vtk", legacy(several));
  ASSERT_TRUE(field) << field.error().message;
  EXPECT_EQ(field->sizes[1], 2);
  const auto error =
      read_sizes("h.vtk", legacy(scalars("u", "9 9 9 9 9") + scalars("v", "1 2 3 4 5"))).error();
  EXPECT_EQ(error.code, ErrorCode::syntax);
  EXPECT_NE(error.message.find("u, v"), std::string::npos) << error.message;
}

TEST(ReadSizeField, Images) {
  const auto field = read_sizes("h.vtk", R"(# vtk DataFile Version 3.0
image
ASCII
DATASET STRUCTURED_POINTS
DIMENSIONS 3 2 1
ORIGIN 10 20 0
SPACING 2 1 1
POINT_DATA 6
SCALARS h float 1
LOOKUP_TABLE default
1 2 3 1 2 3
)");
  ASSERT_TRUE(field) << field.error().message;
  EXPECT_EQ(field->triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(size_function(*field, 100).value()({11, 20.5}), 1.5);
}

TEST(ReadSizeField, WhatIsNone) {
  EXPECT_EQ(
      read_sizes("h.vtk", legacy("VECTORS v double\n1 0 0 1 0 0 1 0 0 1 0 0 1 0 0\n")).error().code,
      ErrorCode::syntax);
  EXPECT_EQ(read_sizes("h.vtk", "rubbish").error().code, ErrorCode::syntax);
  EXPECT_EQ(read_sizes("h.txt", "1,2").error().code, ErrorCode::unsupported_format);
  const Error blocks = read_sizes("h.vtm", "").error();
  EXPECT_EQ(blocks.code, ErrorCode::unsupported_format);
  EXPECT_NE(blocks.message.find("cover convert FILE.vtm -o FILE.vtu"), std::string::npos);
  EXPECT_EQ(read_size_field("none.vtu").error().code, ErrorCode::cannot_open);
}

TEST(ReadSizeField, TablesOfPoints) {
  const auto field = read_sizes("h.CSV", "# x y h\n0,0,1\n1, 0, 2\n\n0 1 3\n1,1,4\n1,1,4\n");
  ASSERT_TRUE(field) << field.error().message;
  EXPECT_EQ(field->points.size(), 4U);
  EXPECT_EQ(field->triangles.size(), 2U);
  const SizeFunction size = size_function(*field, 100).value();
  EXPECT_DOUBLE_EQ(size({0.25, 0.5}), 1 + 0.25 + 2 * 0.5);
  EXPECT_DOUBLE_EQ(size({3, 1}), 4);  // nearest
  EXPECT_DOUBLE_EQ(size({0.5, -9}), 1.5);
  const auto named = read_sizes("h.csv", "\"h\",other,y,x\n5,9,1,0\n6,9,1,1\n");
  ASSERT_TRUE(named) << named.error().message;
  EXPECT_EQ(named->points, (std::vector<Point>{{0, 1}, {1, 1}}));
  EXPECT_EQ(named->sizes, (std::vector<double>{5, 6}));
  EXPECT_EQ(size_function(*named, 100).value()({0.9, 7}), 6);
}

TEST(ReadSizeField, TablesThatAreNone) {
  const auto refusal = [](const std::string& text) {
    const auto field = read_sizes("h.csv", text);
    EXPECT_FALSE(field) << text;
    const std::string message = field ? "" : field.error().message;
    return message.substr(message.find("h.csv") + 5);
  };
  EXPECT_EQ(refusal(""), ": no points: expected lines x,y,h");
  EXPECT_EQ(refusal("1,2"), ":1: expected 3 numbers, found 2");
  EXPECT_EQ(refusal("0,0,1\n1,z,2"), ":2: 'z' is no number");
  EXPECT_EQ(refusal("0,0,1\n1,nan,2"), ":2: the coordinates are not finite");
  EXPECT_EQ(refusal("0,0,1\n0,0,2"), ":2: (0, 0) stands there a second time, with 2 instead of 1");
  EXPECT_EQ(refusal("x,y\n0,0"), ":2: expected x, y and a value in each line");
  EXPECT_EQ(refusal("y,h,z\n0,0,1"), ":1: the first two columns are x and y");
  for (const char* text : {"0;0;1\n1;0;1", "x;y;h\n0;0;1", "x; y; h\n0; 0; 1"})
    EXPECT_EQ(refusal(text),
              ":1: columns are separated by ';'? Commas or blanks are read between them");
  for (const char* text :
       {"0,5;0,5;1,5\n1,5;0;1", "x;y;h\n0,5;0;1", "x; y; h\n0,5; 0; 1", "0,5;1;2"})
    EXPECT_EQ(refusal(text),
              ":1: columns are separated by ';', and decimals have a comma? Commas or blanks are "
              "read between columns, and decimals have a point");
}

TEST(ReadSizeField, OfARasterPointsAreWanted) {
  const TemporaryFolder folder;
  const std::string advice =
      "; of a raster, 'gdal_translate -of XYZ FILE OUT.csv' makes points x,y,h that can be read";
  const std::string picture = folder.write("a.tif", std::string("II*\0", 4));
  EXPECT_EQ(read_size_field(picture).error().message,
            picture + ": a picture, which holds no field of sizes" + advice);
  const std::string grid = folder.write("a.asc", "ncols 2\n");
  EXPECT_EQ(read_size_field(grid).error().message,
            grid + ": a field of sizes is read from .csv, .vtu, .vtp, .vti and .vtk" + advice);
}

TEST(ReadSizeField, WhatChangesIsResolved) {
  // 7 x + y beside a steeper triangle, of 14 x + y - 7.
  const TemporaryFolder folder;
  const std::string path = folder.write("f.vtk", legacy(scalars("u", "0 7 8 1 14")));
  const auto field = read_size_field(path, "u", 0.5);
  ASSERT_TRUE(field) << field.error().message;
  const double slope = std::hypot(7.0, 1.0);
  EXPECT_DOUBLE_EQ(field->sizes[0], 0.5 / slope / 1.5);
  EXPECT_DOUBLE_EQ(field->sizes[4], 0.5 / slope / 1.5);
  const auto twice = read_size_field(path, "2*u + x", 0.5);
  ASSERT_TRUE(twice) << twice.error().message;
  EXPECT_DOUBLE_EQ(twice->sizes[0], 0.5 / std::hypot(15.0, 2.0) / 1.5);
  // Constant: nothing finer than the whole.
  const auto constant = read_size_field(path, "3", 0.5);
  ASSERT_TRUE(constant) << constant.error().message;
  for (const double size : constant->sizes) EXPECT_DOUBLE_EQ(size, std::hypot(2.0, 1.0));
  for (const char* of : {"sqrt(-1 - abs(u))", "u/0"}) {
    const auto nothing = read_size_field(path, of, 0.5);
    ASSERT_FALSE(nothing) << of;
    EXPECT_EQ(nothing.error().code, ErrorCode::bad_option);
    EXPECT_EQ(nothing.error().message,
              fmt::format("size-of '{}' is a number at no point of {}", of, path));
  }
  const auto alone = read_size_field(path, "asinh", 0.5);
  ASSERT_TRUE(alone) << alone.error().message;
  const double of_asinh =
      std::hypot(std::asinh(14.0) - std::asinh(7.0), std::asinh(8.0) - std::asinh(7.0));
  EXPECT_NEAR(alone->sizes[4], 0.5 / of_asinh / 1.5, 1e-12);
  EXPECT_EQ(read_size_field(path, "asinh(v)", 1).error().code, ErrorCode::bad_option);
  EXPECT_NE(read_size_field(path, "asinh(v)", 1)
                .error()
                .message.find("'asinh(v)', column 7: there is no 'v'; there are u, x, y, pi"),
            std::string::npos);
  const auto several = read_size_field(
      folder.write("s.vtk", legacy(scalars("u", "1 2 3 4 5") + scalars("v", "1 2 3 4 5"))), "asinh",
      1);
  ASSERT_FALSE(several);
  EXPECT_NE(several.error().message.find("asinh of which point array? Of u, v, as asinh(u)"),
            std::string::npos)
      << several.error().message;
}

TEST(LoadSizeField, TellsWhatIsTakenForLengths) {
  const TemporaryFolder folder;
  for (const char* name : {"n", "h", "size"}) {
    Options options;
    options.size_field_name = folder.write("n.vtk", legacy(scalars(name, "1 2 3 4 5")));
    Input input;
    ASSERT_TRUE(load_size_field(options, input));
    ASSERT_EQ(input.warnings.size(), name == std::string("n") ? 1U : 0U) << name;
    if (input.warnings.empty()) continue;
    EXPECT_NE(input.warnings[0].find("n.vtk: the only array, 'n', is taken for edge lengths"),
              std::string::npos);
  }
}

/// Where the file itself has no number, there is nothing to tell.
TEST(LoadSizeField, TellsWhereThereIsNoNumber) {
  const TemporaryFolder folder;
  const auto warnings = [&](const char* values, const char* of) {
    Options options;
    options.size_field_name = folder.write("n.vtk", legacy(scalars("n", values)));
    options.size_of = of;
    Input input;
    const Status status = load_size_field(options, input);
    EXPECT_TRUE(status) << status.error().message;
    return input.warnings;
  };
  const auto told = warnings("1 2 -3 4 0", "log(n)");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0],
            fmt::format("size-of 'log(n)' is no number at 2 of 5 points of {}, first at (1, 1): "
                        "triangles there ask for no size",
                        (folder.path() / "n.vtk").string()));
  EXPECT_TRUE(warnings("1 2 3 4 nan", "log(n)").empty());
  EXPECT_TRUE(warnings("1 2 -3 4 0", "asinh(n)").empty());
}

/// Such a growth once kept sizes from ever being spread.
TEST(LoadSizeField, RefusesOptionsThatAreNotLegal) {
  const TemporaryFolder folder;
  const std::string path = folder.write("h.vtk", legacy(scalars("h", "1 2 3 4 5")));
  const auto refusal = [&](auto change) {
    Options options;
    options.size_field_name = path;
    change(options);
    const Status status = load_size_field(options);
    if (status) return std::string();
    EXPECT_EQ(status.error().code, ErrorCode::bad_option);
    return status.error().message;
  };
  EXPECT_EQ(refusal([](Options&) {}), "");
  for (const double value : {1.0, 0.5, -1.0, std::nan("")}) {
    EXPECT_NE(refusal([&](Options& o) { o.growth = value; }).find("growth is"), std::string::npos);
    EXPECT_FALSE(size_function(SizeSamples{{{0, 0}}, {}, {1}}, value));
  }
  for (const double value : {0.0, -1.0, std::nan("")})
    EXPECT_NE(refusal([&](Options& o) { o.size_field_scale = value; }).find("size_field_scale is"),
              std::string::npos);
}

}  // namespace
}  // namespace cover
