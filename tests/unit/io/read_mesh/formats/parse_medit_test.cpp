// Medit's .mesh as other programs write it.
#include <gtest/gtest.h>

#include <string>

#include "io/read_mesh/mesh_formats.hpp"

namespace cover {
namespace {

const std::string kMeditHead = "MeshVersionFormatted 2\nDimension 2\n";
const std::string kMeditVertices = "Vertices 4\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

Result<MeshFile> medit_mesh(const std::string& text) { return parse_medit(text, "x.mesh"); }

ErrorCode refusal_of_medit(const std::string& text) {
  const Result<MeshFile> mesh = medit_mesh(text);
  return mesh ? ErrorCode::internal : mesh.error().code;
}

TEST(ParseMedit, ReferencesAreMaterialsAndGroupsOfLines) {
  const auto mesh = medit_mesh(kMeditHead + kMeditVertices +
                               "Triangles 2\n1 2 3 7\n2 4 3 5\nEdges 1\n1 2 9\nEnd\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.material, (std::vector<std::int64_t>{7, 5}));
  ASSERT_EQ(mesh->lines.size(), 1U);
  EXPECT_EQ(mesh->lines[0].b, 1U);
  EXPECT_EQ(mesh->lines[0].group, 9);
}

TEST(ParseMedit, SectionsThatAreNotKnownArePassedOver) {
  const auto mesh =
      medit_mesh(kMeditHead + kMeditVertices + "Corners 2\n1 2\nTriangles 1\n1 2 3 7\nEnd\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 1U);
}

TEST(ParseMedit, WhatFollowsTheEndIsNotRead) {
  const auto mesh =
      medit_mesh(kMeditHead + kMeditVertices + "Triangles 1\n1 2 3 7\nEnd\nTriangles 1\n9 9 9 9\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 1U);
}

TEST(ParseMedit, AThirdCoordinateMustBeZero) {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  const std::string rest = "Triangles 1\n1 2 3 1\nEnd\n";
  EXPECT_TRUE(medit_mesh(head + "Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n" + rest));
  EXPECT_EQ(refusal_of_medit(head + "Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 1 0\n" + rest),
            ErrorCode::unsupported_format);
}

TEST(ParseMedit, AVertexWithoutAReferenceIsRefused) {
  EXPECT_EQ(refusal_of_medit(kMeditHead + "Vertices 1\n0 0\nEnd"), ErrorCode::syntax);
}

TEST(ParseMedit, ACornerThatIsNoVertexIsRefused) {
  EXPECT_EQ(refusal_of_medit(kMeditHead + kMeditVertices + "Triangles 1\n1 2 5 1\nEnd"),
            ErrorCode::id_out_of_range);
  EXPECT_EQ(refusal_of_medit(kMeditHead + kMeditVertices + "Triangles 1\n0 1 2 1\nEnd"),
            ErrorCode::id_out_of_range);
}

TEST(ParseMedit, FewerRowsThanAnnouncedAreRefused) {
  EXPECT_EQ(refusal_of_medit(kMeditHead + "Vertices 9"), ErrorCode::truncated);
}

TEST(ParseMedit, AFileThatDoesNotBeginAsOneIsRefused) {
  EXPECT_EQ(refusal_of_medit("Dimension 2\n"), ErrorCode::syntax);
}

}  // namespace
}  // namespace cover
