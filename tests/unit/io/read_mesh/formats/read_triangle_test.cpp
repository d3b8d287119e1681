// Files of Triangle, of which two or three are one mesh.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "io/read_mesh/mesh_formats.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

class ReadTriangle : public ::testing::Test {
 protected:
  void write(const std::string& extension, const std::string& text) const {
    (void)folder_.write("x" + extension, text);
  }
  [[nodiscard]] Result<MeshFile> read() const { return read_triangle(folder_.path() / "x.ele"); }
  [[nodiscard]] ErrorCode refusal() const {
    const Result<MeshFile> mesh = read();
    return mesh ? ErrorCode::internal : mesh.error().code;
  }

  testing::TemporaryFolder folder_;
};

TEST_F(ReadTriangle, RowsCountFromOneOrZeroAsTheNodesDo) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  write(".ele", "1 3 0\n1 1 2 3\n");
  const auto from_one = read();
  ASSERT_TRUE(from_one) << from_one.error().message;
  write(".node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
  write(".ele", "1 3 0\n0 0 1 2\n");
  const auto from_zero = read();
  ASSERT_TRUE(from_zero) << from_zero.error().message;
  EXPECT_EQ(from_one->soup.triangles, from_zero->soup.triangles);
  EXPECT_EQ(from_one->soup.points, from_zero->soup.points);
}

TEST_F(ReadTriangle, TheFirstAttributeIsTheMaterialAndTheSecondTheRegion) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  write(".ele", "1 3 1\n1 1 2 3 7\n");
  EXPECT_EQ(read()->soup.material, (std::vector<std::int64_t>{7}));
  EXPECT_TRUE(read()->soup.region.empty());
  write(".ele", "1 3 2\n1 1 2 3 7 4\n");
  EXPECT_EQ(read()->soup.material, (std::vector<std::int64_t>{7}));
  EXPECT_EQ(read()->soup.region, (std::vector<std::int64_t>{4}));
  write(".ele", "1 3 3\n1 1 2 3 9 4 7\n");
  EXPECT_EQ(read()->soup.material, (std::vector<std::int64_t>{7})) << "of three it is the last";
}

TEST_F(ReadTriangle, EdgesAreReadWhereTheyAreThere) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  write(".ele", "1 3 0\n1 1 2 3\n");
  EXPECT_TRUE(read()->lines.empty());
  write(".edge", "1 1\n1 1 2 5\n");
  const auto mesh = read();
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->lines.size(), 1U);
  EXPECT_EQ(mesh->lines[0].group, 5);
}

TEST_F(ReadTriangle, TheFirstMidpointIsOppositeToTheFirstCorner) {
  write(".node", "6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0\n");
  write(".ele", "1 6 0\n1 1 2 3 4 5 6\n");
  const auto mesh = read();
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_TRUE(mesh->second_order);
  ASSERT_EQ(mesh->middles.size(), 1U);
  EXPECT_EQ(mesh->middles[0], (std::array<Point, 3>{{{1, 0}, {1, 1}, {0, 1}}}));
}

TEST_F(ReadTriangle, AMeshWithoutItsNodesIsRefused) {
  write(".ele", "1 3 2\n");
  EXPECT_EQ(refusal(), ErrorCode::cannot_open);
}

TEST_F(ReadTriangle, ACornerThatIsNoPointIsRefused) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  write(".ele", "1 3 2\n1 1 2 4 1 1\n");
  EXPECT_EQ(refusal(), ErrorCode::id_out_of_range);
}

TEST_F(ReadTriangle, AGapInTheNumbersOfPointsIsRefused) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n4 0 1\n");
  write(".ele", "1 3 0\n1 1 2 3\n");
  EXPECT_EQ(refusal(), ErrorCode::syntax);
}

TEST_F(ReadTriangle, FewerRowsThanAnnouncedAreRefused) {
  write(".node", "3 2 0 0\n1 0 0\n2 1 0\n");
  write(".ele", "1 3 0\n1 1 2 3\n");
  EXPECT_EQ(refusal(), ErrorCode::truncated);
}

}  // namespace
}  // namespace cover
