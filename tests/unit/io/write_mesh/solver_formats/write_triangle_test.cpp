#include <gtest/gtest.h>

#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

class WriteTriangle : public ::testing::Test {
 protected:
  WrittenMesh written(const WriteOptions& options) {
    const Status status = write_triangle(output_, name(".ele"), options);
    EXPECT_TRUE(status) << status.error().message;
    nodes();
    elements();
    edges();
    return mesh_;
  }

  Output output_ = testing::odd_device();

 private:
  [[nodiscard]] std::string name(const char* extension) const {
    return (folder_.path() / "x.1").string() + extension;
  }

  void nodes() {
    testing::Words words(testing::content(name(".node")));
    const long count = words.integer();
    for (const char* word : {"2", "0", "0"}) words.expect(word);
    for (long n = 1; n <= count; ++n) {
      EXPECT_EQ(words.integer(), n);
      const double x = words.number(), y = words.number();
      mesh_.points.push_back({x, y});
    }
    EXPECT_TRUE(words.at_end());
  }

  void elements() {
    testing::Words words(testing::content(name(".ele")));
    const long count = words.integer(), nodes = words.integer();
    words.expect("2");
    for (long n = 1; n <= count; ++n) {
      EXPECT_EQ(words.integer(), n);
      WrittenCell cell;
      for (long k = 0; k < nodes; ++k) cell.nodes.push_back(words.index());
      // Triangle: nodes 4, 5, 6 are opposite the corners 1, 2, 3.
      if (nodes == 6) std::rotate(cell.nodes.begin() + 3, cell.nodes.begin() + 5, cell.nodes.end());
      cell.number = words.integer();
      cell.entity = words.integer();
      mesh_.triangles.push_back(cell);
    }
    EXPECT_TRUE(words.at_end());
  }

  void edges() {
    testing::Words words(testing::content(name(".edge")));
    const long count = words.integer();
    words.expect("1");
    for (long n = 1; n <= count; ++n) {
      EXPECT_EQ(words.integer(), n);
      WrittenCell cell;
      for (int k = 0; k < 2; ++k) cell.nodes.push_back(words.index());
      cell.number = words.integer();
      mesh_.lines.push_back(cell);
    }
    EXPECT_TRUE(words.at_end());
  }

  testing::TemporaryFolder folder_;
  WrittenMesh mesh_;
};

TEST_F(WriteTriangle, MarkersOfTheInput) {
  const WrittenMesh file = written({});
  testing::expect_same_triangles(output_, file);
  testing::expect_materials(output_, file);
  for (const WrittenCell& line : file.lines) {
    const bool gate = file.points[line.nodes[0]].x == 0 && file.points[line.nodes[1]].x == 0 &&
                      file.points[line.nodes[0]].y < 1 && file.points[line.nodes[1]].y < 1;
    EXPECT_EQ(line.number, gate ? 11 : 0);
  }
}

TEST_F(WriteTriangle, NumbersOfLinesWhereTheInputHasNoMarkers) {
  for (const auto e : output_.mesh.tri().edges()) output_.mesh.set_marker(e, 0);
  const WrittenMesh file = written({});
  testing::expect_same_lines(output_, file);
}

TEST_F(WriteTriangle, SecondOrder) {
  WriteOptions options;
  options.order = 2;
  testing::expect_same_triangles(output_, written(options), 2);
}

}  // namespace
}  // namespace cover
