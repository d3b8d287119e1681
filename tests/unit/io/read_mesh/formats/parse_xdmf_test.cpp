// XDMF by hand. That numbers in HDF5 beside it are read is tested with what writes them.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "io/read_mesh/mesh_formats.hpp"

namespace cover {
namespace {

std::string xml_item(std::string_view numbers) {
  return "<DataItem Format=\"XML\">" + std::string(numbers) + "</DataItem>";
}

std::string xdmf_array(std::string_view name, std::string_view center, std::string_view numbers) {
  return "<Attribute Name=\"" + std::string(name) + "\" Center=\"" + std::string(center) + "\">" +
         xml_item(numbers) + "</Attribute>";
}

/// Two triangles that are a square, and what else their grid holds.
std::string xdmf_square(const std::string& more, std::string_view cells = "0 1 2 0 2 3") {
  return "<Xdmf><Domain><Grid Name=\"mesh\"><Topology NodesPerElement=\"3\">" + xml_item(cells) +
         "</Topology><Geometry>" + xml_item("0 0 1 0 1 1 0 1") + "</Geometry>" + more +
         "</Grid></Domain></Xdmf>";
}

Result<MeshFile> xdmf_mesh(const std::string& text) { return parse_xdmf(text, "x.xdmf"); }

ErrorCode refusal_of_xdmf(const std::string& text) {
  const Result<MeshFile> mesh = xdmf_mesh(text);
  return mesh ? ErrorCode::internal : mesh.error().code;
}

TEST(ParseXdmf, TheArraysOfOurOwnSayWhereTrianglesBelong) {
  const auto mesh = xdmf_mesh(xdmf_square(xdmf_array("MaterialID", "Cell", "7 5") +
                                          xdmf_array("RegionId", "Cell", "1 2") +
                                          xdmf_array("GroupID", "Cell", "3 4")));
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 2U);
  EXPECT_EQ(mesh->soup.material, (std::vector<std::int64_t>{7, 5}));
  EXPECT_EQ(mesh->soup.region, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(mesh->group, (std::vector<std::int64_t>{3, 4}));
  EXPECT_TRUE(mesh->arrays.empty());
}

TEST(ParseXdmf, OtherArraysAreKeptByTheirCentre) {
  const auto mesh = xdmf_mesh(xdmf_square(xdmf_array("doping", "Node", "1 2 3 4") +
                                          xdmf_array("landuse", "Cell", "0.5 1.5")));
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->point_arrays.size(), 1U);
  EXPECT_EQ(mesh->point_arrays[0].name, "doping");
  ASSERT_EQ(mesh->arrays.size(), 1U);
  EXPECT_EQ(mesh->arrays[0].values, (std::vector<double>{0.5, 1.5}));
}

TEST(ParseXdmf, AnArrayOfAnotherLengthIsRefused) {
  EXPECT_EQ(refusal_of_xdmf(xdmf_square(xdmf_array("RegionId", "Cell", "1"))), ErrorCode::syntax);
  EXPECT_EQ(refusal_of_xdmf(xdmf_square(xdmf_array("doping", "Node", "1 2"))), ErrorCode::syntax);
}

TEST(ParseXdmf, ACornerThatIsNoPointIsRefused) {
  EXPECT_EQ(refusal_of_xdmf(xdmf_square("", "0 1 4")), ErrorCode::id_out_of_range);
  EXPECT_EQ(refusal_of_xdmf(xdmf_square("", "0 1 -1")), ErrorCode::id_out_of_range);
}

TEST(ParseXdmf, NumbersInAFileElsewhereAreRefused) {
  const std::string far =
      "<Attribute Name=\"RegionId\" Center=\"Cell\"><DataItem Format=\"HDF\">"
      "../secret.h5:/x</DataItem></Attribute>";
  EXPECT_EQ(refusal_of_xdmf(xdmf_square(far)), ErrorCode::unsupported_format);
}

TEST(ParseXdmf, WhatHasNoGridCalledMeshIsRefused) {
  EXPECT_EQ(refusal_of_xdmf("<Xdmf><Domain/></Xdmf>"), ErrorCode::syntax);
  EXPECT_EQ(refusal_of_xdmf("no XML"), ErrorCode::syntax);
}

}  // namespace
}  // namespace cover
