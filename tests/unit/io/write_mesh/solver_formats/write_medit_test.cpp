#include <gtest/gtest.h>

#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

std::vector<WrittenCell> cells(testing::Words& words, const std::string& keyword,
                               std::size_t nodes) {
  words.expect(keyword);
  std::vector<WrittenCell> cells(static_cast<std::size_t>(words.integer()));
  for (WrittenCell& cell : cells) {
    for (std::size_t k = 0; k < nodes; ++k) cell.nodes.push_back(words.index());
    cell.number = words.integer();
  }
  return cells;
}

WrittenMesh parse_medit_text(const std::string& path, bool second_order) {
  testing::Words words(testing::content(path));
  for (const char* word : {"MeshVersionFormatted", "2", "Dimension", "2", "Vertices"})
    words.expect(word);
  WrittenMesh mesh;
  for (long n = words.integer(); n > 0; --n) {
    const double x = words.number(), y = words.number();
    mesh.points.push_back({x, y});
    words.expect("0");
  }
  mesh.lines = cells(words, second_order ? "EdgesP2" : "Edges", second_order ? 3 : 2);
  mesh.triangles = cells(words, second_order ? "TrianglesP2" : "Triangles", second_order ? 6 : 3);
  words.expect("End");
  EXPECT_TRUE(words.at_end());
  return mesh;
}

TEST(WriteMedit, HoldsEverything) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "x.mesh").string();
  const Output output = testing::odd_device();
  for (const int order : {1, 2}) {
    WriteOptions options;
    options.order = order;
    ASSERT_TRUE(write_medit(output, path, options));
    WrittenMesh file = parse_medit_text(path, order == 2);
    testing::expect_same_triangles(output, file, order);
    testing::expect_materials(output, file);
    testing::expect_same_lines(output, file);
  }
}

}  // namespace
}  // namespace cover
