// .obj, .off and .ply are read back by parsers of our own and by OpenMesh (whose coordinates are
// floats, so only the counts are compared).
#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>

#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

class WriteSurface : public ::testing::Test {
 protected:
  /// The words of the file that `write` makes.
  testing::Words written(Status (*write)(const Output&, const std::string&, const WriteOptions&),
                         const char* extension) {
    const std::string path = (folder_.path() / "x").string() + extension;
    const Status status = write(output_, path, {});
    EXPECT_TRUE(status) << status.error().message;
    TriMesh tri;
    EXPECT_TRUE(OpenMesh::IO::read_mesh(tri, path));
    EXPECT_EQ(tri.n_faces(), output_.mesh.tri().n_faces());
    return testing::Words(testing::content(path));
  }

  static Point point(testing::Words& words) {
    const double x = words.number(), y = words.number();
    words.expect("0");
    return {x, y};
  }

  testing::TemporaryFolder folder_;
  Output output_ = testing::odd_device();
};

TEST_F(WriteSurface, Obj) {
  testing::Words words = written(write_obj, ".obj");
  WrittenMesh file;
  std::map<std::string, long> numbers;
  std::string group;
  while (!words.at_end()) {
    const std::string key = words.word();
    if (key == "v") file.points.push_back(point(words));
    if (key == "g") group = words.word();
    if (key != "f" && key != "l") continue;
    WrittenCell cell;
    for (int k = key == "f" ? 3 : 2; k > 0; --k) cell.nodes.push_back(words.index());
    cell.number = numbers.emplace(group, static_cast<long>(numbers.size()) + 1).first->second;
    (key == "f" ? file.region_names : file.line_names)[cell.number] = group;
    (key == "f" ? file.triangles : file.lines).push_back(cell);
  }
  testing::expect_same_triangles(output_, file);
  testing::expect_region_groups(output_, file);
  testing::expect_same_lines(output_, file);
}

TEST_F(WriteSurface, Off) {
  testing::Words words = written(write_off, ".off");
  words.expect("OFF");
  WrittenMesh file;
  file.points.resize(static_cast<std::size_t>(words.integer()));
  file.triangles.resize(static_cast<std::size_t>(words.integer()));
  words.expect("0");
  for (Point& p : file.points) p = point(words);
  for (WrittenCell& cell : file.triangles) {
    words.expect("3");
    for (int k = 0; k < 3; ++k) cell.nodes.push_back(words.index(0));
  }
  EXPECT_TRUE(words.at_end());
  testing::expect_same_triangles(output_, file);
}

TEST_F(WriteSurface, Ply) {
  testing::Words words = written(write_ply, ".ply");
  WrittenMesh file;
  for (std::string word = words.word(); word != "end_header"; word = words.word()) {
    if (word != "element") continue;
    if (words.word() == "vertex") {
      file.points.resize(static_cast<std::size_t>(words.integer()));
    } else {
      file.triangles.resize(static_cast<std::size_t>(words.integer()));
    }
  }
  for (Point& p : file.points) p = point(words);
  for (WrittenCell& cell : file.triangles) {
    words.expect("3");
    for (int k = 0; k < 3; ++k) cell.nodes.push_back(words.index(0));
    cell.number = words.integer();
    cell.entity = words.integer();
  }
  EXPECT_TRUE(words.at_end());
  testing::expect_same_triangles(output_, file);
  testing::expect_materials(output_, file);
}

}  // namespace
}  // namespace cover
