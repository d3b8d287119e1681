// Abaqus decks as other programs write them.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "io/read_mesh/mesh_formats.hpp"

namespace cover {
namespace {

Result<MeshFile> inp_mesh(const std::string& text) { return parse_inp(text, "x.inp"); }

ErrorCode refusal_of_inp(const std::string& text) {
  const Result<MeshFile> mesh = inp_mesh(text);
  return mesh ? ErrorCode::internal : mesh.error().code;
}

const std::string kInpNodes = "*NODE\n10, 0, 0\n20, 1, 0\n30, 0, 1\n40, 1, 1\n";

TEST(ParseInp, NodesAreKnownByTheirNumbers) {
  const auto mesh = inp_mesh(kInpNodes + "*ELEMENT, TYPE=S3\n1, 20, 40, 30\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.points[3], (Point{1, 1}));
  ASSERT_EQ(mesh->soup.triangles.size(), 1U);
  EXPECT_EQ(mesh->soup.triangles[0], (std::array<std::uint32_t, 3>{1, 3, 2}));
}

TEST(ParseInp, TrianglesComeByTheirNumbersWhateverTheirSets) {
  const auto mesh = inp_mesh(kInpNodes + "*ELEMENT, TYPE=CPS3, ELSET=SI\n7, 20, 40, 30\n" +
                             "*ELEMENT, TYPE=CPS3, ELSET=OX\n3, 10, 20, 30\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(mesh->group, (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(mesh->region_names, (std::map<std::int64_t, std::string>{{1, "SI"}, {2, "OX"}}));
}

TEST(ParseInp, OtherElementsAndBlocksAreLeftOut) {
  const auto mesh =
      inp_mesh(kInpNodes + "*ELEMENT, TYPE=T2D2\n1, 10, 20\n*STEP\nwords, and more\n" +
               "** a comment\n*Element, type=s3\n2, 10, 20, 30\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 1U);
}

TEST(ParseInp, OfSixNodesTheCornersAreTaken) {
  const auto mesh = inp_mesh(
      "*NODE\n1,0,0\n2,2,0\n3,0,2\n4,1,0\n5,1,1\n6,0,1\n"
      "*ELEMENT, TYPE=CPE6\n1, 1, 2, 3, 4, 5, 6\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_TRUE(mesh->second_order);
  EXPECT_EQ(mesh->soup.points.size(), 3U);
}

TEST(ParseInp, SurfacesAreLines) {
  const auto mesh = inp_mesh(kInpNodes +
                             "*ELEMENT, TYPE=CPS3, ELSET=ALL\n1, 10, 20, 30\n2, 20, 40, 30\n"
                             "*Elset, elset=both, generate\n1, 2\n"
                             "*SURFACE, NAME=Edge\nboth, S2\n1, S1\nnone, S3\n"
                             "*SURFACE, NAME=Nodes, TYPE=NODE\n10\n"
                             "*SURFACE, TYPE=ELEMENT, NAME=Shell\n1, SPOS\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->lines.size(), 3U);
  const std::array<std::array<std::uint32_t, 2>, 3> ends{{{1, 2}, {3, 2}, {0, 1}}};
  for (std::size_t l = 0; l < 3; ++l) {
    EXPECT_EQ((std::array{mesh->lines[l].a, mesh->lines[l].b}), ends[l]);
    EXPECT_EQ(mesh->line_names.at(mesh->lines[l].group), "EDGE");
  }
}

TEST(ParseInp, SurfacesThatNameTheSameEdgesAgainAndAgainAreRefused) {
  std::string text = kInpNodes +
                     "*ELEMENT, TYPE=CPS3\n1, 10, 20, 30\n2, 20, 40, 30\n"
                     "*ELSET, ELSET=ALL\n1, 2\n*SURFACE, NAME=A\n";
  EXPECT_TRUE(inp_mesh(text + "ALL, S1\nALL, S2\nALL, S3\n"));
  for (int k = 0; k < 100; ++k) text += "ALL, S1\n";
  EXPECT_EQ(refusal_of_inp(text), ErrorCode::syntax);
}

TEST(ParseInp, ANodeThatIsNotGivenIsRefused) {
  EXPECT_EQ(refusal_of_inp(kInpNodes + "*ELEMENT, TYPE=S3\n1, 10, 20, 50\n"),
            ErrorCode::id_out_of_range);
}

TEST(ParseInp, ANodeThatIsGivenTwiceIsRefused) {
  EXPECT_EQ(refusal_of_inp(kInpNodes + "10, 5, 5\n"), ErrorCode::syntax);
}

TEST(ParseInp, AMeshThatLeavesThePlaneIsRefused) {
  EXPECT_EQ(refusal_of_inp("*NODE\n1, 0, 0, 2\n"), ErrorCode::unsupported_format);
}

TEST(ParseInp, AWordInPlaceOfANumberIsNamedWithItsLine) {
  const auto mesh = inp_mesh("*NODE\n1, x, 0\n");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::syntax);
  EXPECT_NE(mesh.error().message.find("x.inp:2"), std::string::npos) << mesh.error().message;
}

}  // namespace
}  // namespace cover
