// What of gmsh's files is a mesh. Their syntax is tested in
// tests/unit/io/input/meshes/read_msh_test.cpp.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/read_mesh/mesh_formats.hpp"

namespace cover {
namespace {

const std::string kMshHead = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 11 "contact"
2 1 "Si"
2 2 "SiO2"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
)";

/// With these elements, one a line.
Result<MeshFile> msh_mesh(int count, const std::string& elements) {
  return parse_msh_mesh(
      kMshHead + "$Elements\n" + std::to_string(count) + "\n" + elements + "$EndElements\n",
      "x.msh");
}

TEST(ParseMshMesh, PhysicalGroupsAreGroupsAndEntitiesAreRegions) {
  const auto mesh = msh_mesh(3, "1 1 2 11 4 1 2\n2 2 2 1 5 1 2 3\n3 2 2 2 6 1 3 4\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 2U);
  EXPECT_EQ(mesh->group, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(mesh->soup.region, (std::vector<std::int64_t>{5, 6}));
  EXPECT_TRUE(mesh->soup.material.empty()) << "groups are all that the file has";
  ASSERT_EQ(mesh->lines.size(), 1U);
  EXPECT_EQ(mesh->lines[0].group, 11);
}

TEST(ParseMshMesh, NamesAreThoseOfTheirDimension) {
  const auto mesh = msh_mesh(1, "1 2 2 1 5 1 2 3\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  using Names = std::map<std::int64_t, std::string>;
  EXPECT_EQ(mesh->line_names, (Names{{11, "contact"}}));
  EXPECT_EQ(mesh->region_names, (Names{{1, "Si"}, {2, "SiO2"}}));
}

TEST(ParseMshMesh, ElementsThatArePointsAreLeftOut) {
  const auto mesh = msh_mesh(2, "1 15 2 3 1 1\n2 2 2 1 5 1 2 3\n");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->soup.triangles.size(), 1U);
  EXPECT_TRUE(mesh->lines.empty());
}

TEST(ParseMshMesh, QuadranglesAreRefused) {
  const auto mesh = msh_mesh(1, "1 3 2 1 5 1 2 3 4\n");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::unsupported_format);
  EXPECT_EQ(mesh.error().message, "x.msh: cells that are no triangles");
}

TEST(ParseMshMesh, AFileThatEndsEarlyIsRefused) {
  const auto mesh = parse_msh_mesh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "x.msh");
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::truncated);
}

}  // namespace
}  // namespace cover
