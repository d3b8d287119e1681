#include <cover/read_size_field.hpp>

#include <gtest/gtest.h>

#include <fmt/format.h>

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

Result<SizeSamples> read(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  return read_size_field(folder.write(name, text));
}

TEST(ReadSizeField, TheOnlyArrayOfAnyName) {
  const auto field = read("h.vtk", legacy(scalars("spacing", "1 2 3 4 5")));
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
  const auto field = read("h.vtk", legacy(several));
  ASSERT_TRUE(field) << field.error().message;
  EXPECT_EQ(field->sizes[1], 2);
  const auto error =
      read("h.vtk", legacy(scalars("u", "9 9 9 9 9") + scalars("v", "1 2 3 4 5"))).error();
  EXPECT_EQ(error.code, ErrorCode::syntax);
  EXPECT_NE(error.message.find("u, v"), std::string::npos) << error.message;
}

TEST(ReadSizeField, Images) {
  const auto field = read("h.vtk", R"(# vtk DataFile Version 3.0
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
  EXPECT_EQ(read("h.vtk", legacy("VECTORS v double\n1 0 0 1 0 0 1 0 0 1 0 0 1 0 0\n")).error().code,
            ErrorCode::syntax);
  EXPECT_EQ(read("h.vtk", "rubbish").error().code, ErrorCode::syntax);
  EXPECT_EQ(read("h.csv", "1,2").error().code, ErrorCode::unsupported_format);
  EXPECT_EQ(read_size_field("none.vtu").error().code, ErrorCode::cannot_open);
}

}  // namespace
}  // namespace cover
