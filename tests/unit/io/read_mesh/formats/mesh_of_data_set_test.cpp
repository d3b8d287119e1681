// What of VTK's data sets is a mesh, by legacy files, which are the easiest to read.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include <cover/read_mesh.hpp>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

const std::string kGridHead = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const std::string kGridPoints = "POINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n";
/// A square of two triangles, and one of its sides.
const std::string kGridCells = "CELLS 3 11\n3 0 1 2\n3 0 2 3\n2 0 1\nCELL_TYPES 3\n5\n5\n3\n";

std::string scalars(const std::string& name, const std::string& values) {
  return "SCALARS " + name + " int 1\nLOOKUP_TABLE default\n" + values + "\n";
}

class MeshOfDataSet : public ::testing::Test {
 protected:
  [[nodiscard]] Result<MeshFile> read(const std::string& text) const {
    return read_mesh(folder_.write("x.vtk", text));
  }
  [[nodiscard]] ErrorCode refusal(const std::string& text) const {
    const Result<MeshFile> mesh = read(text);
    return mesh ? ErrorCode::internal : mesh.error().code;
  }

  testing::TemporaryFolder folder_;
};

TEST_F(MeshOfDataSet, NumbersOfLinesAreNoneOfTriangles) {
  const auto mesh = read(kGridHead + kGridPoints + kGridCells + "CELL_DATA 3\n" +
                         scalars("RegionId", "1 2 0") + scalars("LineID", "0 0 9"));
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 2U);
  EXPECT_EQ(mesh->soup.region, (std::vector<std::int64_t>{1, 2}));
  ASSERT_EQ(mesh->lines.size(), 1U);
  EXPECT_EQ(mesh->lines[0].group, 9);
}

TEST_F(MeshOfDataSet, LinesWithoutANumberAreLeftOut) {
  const auto mesh = read(kGridHead + kGridPoints + kGridCells);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_TRUE(mesh->lines.empty());
}

TEST_F(MeshOfDataSet, TheMaterialIsTheFirstArrayThatIsCalledSo) {
  const std::string file = kGridHead + kGridPoints + kGridCells + "CELL_DATA 3\n";
  const auto other = read(file + scalars("medit:ref", "3 4 0"));
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->soup.material, (std::vector<std::int64_t>{3, 4}));
  const auto both = read(file + scalars("medit:ref", "3 4 0") + scalars("material", "7 8 0"));
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_EQ(both->soup.material, (std::vector<std::int64_t>{7, 8}));
}

TEST_F(MeshOfDataSet, NumbersAtPointsAreKept) {
  const auto mesh =
      read(kGridHead + kGridPoints + kGridCells + "POINT_DATA 4\n" + scalars("doping", "5 6 7 8"));
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->point_arrays.size(), 1U);
  EXPECT_EQ(mesh->point_arrays[0].name, "doping");
}

TEST_F(MeshOfDataSet, WhatHasNoTrianglesIsRefused) {
  EXPECT_EQ(refusal(kGridHead + kGridPoints + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n"),
            ErrorCode::syntax);
}

TEST_F(MeshOfDataSet, WhatIsNotPlaneIsRefused) {
  EXPECT_EQ(refusal(kGridHead + "POINTS 4 double\n0 0 0 1 0 0 1 1 5 0 1 0\n" + kGridCells),
            ErrorCode::unsupported_format);
}

}  // namespace
}  // namespace cover
