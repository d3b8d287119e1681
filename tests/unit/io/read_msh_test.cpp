#include <gtest/gtest.h>

#include "io/formats.hpp"

namespace cover {
namespace {

// Two squares of two triangles each; the line between them and the left side are named.
constexpr std::string_view kMesh22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
whatever 1 2 3
$EndComments
$PhysicalNames
3
1 11 "left contact"
2 1 "Si"
2 2 "SiO2"
$EndPhysicalNames
$Nodes
7
1 0 0 3
2 1 0 3
30 2 0 3
4 0 1 3
5 1 1 3
6 2 1 3
7 9 9 0
$EndNodes
$Elements
8
1 1 2 11 4 4 1
2 1 2 21 5 2 5
3 1 2 0 6 1 2
4 2 2 1 1 1 2 5
5 2 2 1 1 1 5 4
6 2 2 2 2 2 30 6
7 2 2 2 2 2 6 5
8 15 2 3 1 1
$EndElements
)";

constexpr std::string_view kMesh41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 11 "left contact"
2 1 "Si"
2 2 "SiO2"
$EndPhysicalNames
$Entities
1 2 2 0
1 0 0 3 0
4 0 0 3 0 1 3 1 11 2 1 -2
5 1 0 3 1 1 3 1 21 0
1 0 0 3 1 1 3 1 1 4 1 2 3 4
2 1 0 3 2 1 3 1 2 4 1 2 3 4
$EndEntities
$Nodes
2 6 1 30
2 1 0 4
1
2
4
5
0 0 3
1 0 3
0 1 3
1 1 3
2 2 1 2
30
6
2 0 3 0.5 0.5
2 1 3 0.5 0.5
$EndNodes
$Elements
4 6 1 7
1 4 1 1
1 4 1
1 5 1 1
2 2 5
2 1 2 2
4 1 2 5
5 1 5 4
2 2 2 2
6 2 30 6
7 2 6 5
$EndElements
)";

class ReadMsh : public ::testing::TestWithParam<std::string_view> {};

TEST_P(ReadMsh, TakesTheBordersOfPhysicalGroups) {
  const Result<Input> input = parse_msh(GetParam(), "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->points.size(), 6u);
  EXPECT_EQ(input->segments.size(), 7u);
  ASSERT_EQ(input->seeds.size(), 2u);
  EXPECT_EQ(input->seeds[0].material, "Si");
  EXPECT_EQ(input->seeds[1].material, "SiO2");
  int contact = 0, unnamed_group = 0;
  for (const InputSegment& s : input->segments) {
    contact += s.name == "left contact" && s.marker == 11 && s.id == 1;
    unnamed_group += s.name == "21" && s.marker == 21;
  }
  EXPECT_EQ(contact, 1);
  EXPECT_EQ(unnamed_group, 1);
}

INSTANTIATE_TEST_SUITE_P(Versions, ReadMsh, ::testing::Values(kMesh22, kMesh41),
                         [](const auto& sample) { return sample.index == 0 ? "msh22" : "msh41"; });

std::string message(std::string text) {
  const Result<Input> input = parse_msh(text, "dev.msh");
  EXPECT_FALSE(input.has_value());
  return input ? "" : input.error().message;
}

std::string replaced(std::string_view from, std::string_view to) {
  std::string text(kMesh22);
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(ReadMshErrors, SayFileAndLine) {
  EXPECT_EQ(message(replaced("2.2 0 8", "2.2 1 8")),
            "dev.msh:2: a binary .msh; write it as text, with gmsh's Mesh.Binary = 0");
  EXPECT_EQ(message(replaced("2.2 0 8", "4 0 8")),
            "dev.msh:2: version 4 of .msh; versions 2.2 and 4.1 are read (gmsh -format msh22 or "
            "msh41)");
  EXPECT_EQ(message(replaced("6 2 1 3\n7", "6 2 one 3\n7")),
            "dev.msh:20: expected a coordinate, found 'one'");
  EXPECT_EQ(message(replaced("1 2 5\n5", "1 2 99\n5")),
            "dev.msh:28: element 4 has the node 99, which is not given");
  EXPECT_EQ(message(replaced("4 2 2 1 1", "4 4 2 1 1")),
            "dev.msh:28: elements of type 4; points, lines, triangles and quadrangles of a plane "
            "mesh are read");
  EXPECT_EQ(message(replaced("7 9 9 0", "6 9 9 0")), "dev.msh:21: node 6 is given twice");
  EXPECT_EQ(message("$NOD"), "dev.msh:1: expected $MeshFormat, found '$NOD'");
  EXPECT_NE(message(replaced("6 2 1 3", "6 2 1 4")).find("not in a plane z = constant"),
            std::string::npos);
  EXPECT_NE(message(std::string(kMesh22.substr(0, 300))), "");
}

TEST(ReadMshErrors, OfEveryTruncationAreErrors) {
  for (const std::string_view whole : {kMesh22, kMesh41})
    for (std::size_t n = 0; n + 2 < whole.size(); ++n) {
      const Result<Input> input = parse_msh(whole.substr(0, n), "dev.msh");
      ASSERT_FALSE(input.has_value()) << n;
    }
}

TEST(ReadMshHigherOrder, TakesCornersAndSaysSo) {
  const Result<Input> input = parse_msh(R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
6
1 0 0 0
2 2 0 0
3 0 2 0
4 1 0 0
5 1 1 0
6 0 1 0
$EndNodes
$Elements
1
1 9 2 0 8 1 2 3 4 5 6
$EndElements
)",
                                        "dev.msh");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->points.size(), 3u);
  EXPECT_EQ(input->seeds[0].material, "surface_8");
  EXPECT_EQ(input->warnings.size(), 1u);
}

}  // namespace
}  // namespace cover
