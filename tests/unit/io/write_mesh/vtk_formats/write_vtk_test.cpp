// The legacy format is read back by a parser of our own and by VTK's.
#include <gtest/gtest.h>

#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

struct LegacyFile {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> cells;
  std::vector<long> types;
  std::vector<std::string> names;  ///< of the arrays, in order
  std::map<std::string, std::vector<long>> arrays;
};

LegacyFile parse(const std::string& path) {
  const std::string text = testing::content(path);
  EXPECT_EQ(text.rfind("# vtk DataFile Version 3.0\n", 0), 0U);
  const std::size_t title = text.find('\n') + 1, end = text.find('\n', title);
  EXPECT_LE(end - title, 255U);
  testing::Words words(text.substr(end));
  for (const char* word : {"ASCII", "DATASET", "UNSTRUCTURED_GRID", "POINTS"}) words.expect(word);
  LegacyFile file;
  const long points = words.integer();
  words.expect("double");
  for (long p = 0; p < points; ++p) {
    const double x = words.number(), y = words.number();
    file.points.push_back({x, y});
    words.expect("0");
  }
  words.expect("CELLS");
  const auto cells = static_cast<std::size_t>(words.integer());
  long numbers = words.integer();
  for (std::size_t c = 0; c < cells; ++c) {
    std::vector<std::uint32_t> nodes(static_cast<std::size_t>(words.integer()));
    for (auto& node : nodes) node = words.index(0);
    numbers -= static_cast<long>(nodes.size()) + 1;
    file.cells.push_back(nodes);
  }
  EXPECT_EQ(numbers, 0);
  words.expect("CELL_TYPES");
  EXPECT_EQ(words.integer(), static_cast<long>(cells));
  for (std::size_t c = 0; c < cells; ++c) file.types.push_back(words.integer());
  words.expect("CELL_DATA");
  EXPECT_EQ(words.integer(), static_cast<long>(cells));
  while (!words.at_end()) {
    words.expect("SCALARS");
    file.names.push_back(words.word());
    for (const char* word : {"int", "1", "LOOKUP_TABLE", "default"}) words.expect(word);
    for (std::size_t c = 0; c < cells; ++c)
      file.arrays[file.names.back()].push_back(words.integer());
  }
  return file;
}

/// Triangles numbered by `material`, lines by `line`.
WrittenMesh mesh_of(const LegacyFile& file, const std::string& material, const std::string& line) {
  WrittenMesh mesh;
  mesh.points = file.points;
  for (std::size_t c = 0; c < file.cells.size(); ++c) {
    const bool is_line = file.types[c] == 3 || file.types[c] == 21;
    EXPECT_TRUE(is_line || mesh.lines.empty()) << "a line before a triangle";
    WrittenCell cell{file.cells[c], file.arrays.at(is_line ? line : material)[c],
                     is_line ? 0 : file.arrays.at("RegionId")[c]};
    (is_line ? mesh.lines : mesh.triangles).push_back(cell);
  }
  return mesh;
}

class WriteVtk : public ::testing::Test {
 protected:
  LegacyFile written(const WriteOptions& options) {
    const Status status = write_vtk(output_, path_, options);
    EXPECT_TRUE(status) << status.error().message;
    return parse(path_);
  }

  testing::TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "x.vtk").string();
  Output output_ = testing::odd_device();
};

TEST_F(WriteVtk, TrianglesUnderTheNamesThatReadersLookFor) {
  const LegacyFile file = written({});
  EXPECT_EQ(file.names, (std::vector<std::string>{"MaterialID", "material", "mat_id", "RegionId"}));
  for (const char* name : {"MaterialID", "material", "mat_id"}) {
    const WrittenMesh mesh = mesh_of(file, name, "");
    testing::expect_same_triangles(output_, mesh);
    testing::expect_materials(output_, mesh);
  }
}

TEST_F(WriteVtk, Lines) {
  WriteOptions options;
  options.lines = true;
  const LegacyFile file = written(options);
  EXPECT_EQ(file.names,
            (std::vector<std::string>{"MaterialID", "ManifoldID", "LineID", "RegionId"}));
  const WrittenMesh mesh = mesh_of(file, "MaterialID", "LineID");
  testing::expect_same_triangles(output_, mesh);
  testing::expect_materials(output_, mesh);
  testing::expect_same_lines(output_, mesh);

  // deal.II: boundary ids in one array, those of inner lines in the other.
  WrittenMesh outer, inner;
  for (std::size_t c = 0; c < file.cells.size(); ++c) {
    if (file.types[c] != 3) {
      EXPECT_EQ(file.arrays.at("ManifoldID")[c], -1);
      continue;
    }
    const long boundary = file.arrays.at("MaterialID")[c],
               manifold = file.arrays.at("ManifoldID")[c];
    EXPECT_NE(boundary == -1, manifold == -1);
    (boundary == -1 ? inner : outer)
        .lines.push_back({file.cells[c], std::max(boundary, manifold), 0});
  }
  testing::expect_same_lines(output_, outer, {.inner_lines = false});
  testing::expect_same_lines(output_, inner, {.outer_lines = false});
}

TEST_F(WriteVtk, SecondOrder) {
  WriteOptions options;
  options.order = 2;
  options.lines = true;
  const LegacyFile file = written(options);
  EXPECT_EQ(file.types.front(), 22);
  EXPECT_EQ(file.types.back(), 21);
  const WrittenMesh mesh = mesh_of(file, "MaterialID", "LineID");
  testing::expect_same_triangles(output_, mesh, 2);
  testing::expect_same_lines(output_, mesh);
}

TEST_F(WriteVtk, VtkReadsIt) {
  ASSERT_TRUE(write_vtk(output_, path_));
  const Result<MeshFile> file = read_mesh(path_);
  ASSERT_TRUE(file) << file.error().message;
  const TriangleSoup soup = triangle_soup(output_.mesh);
  EXPECT_EQ(file->soup.points, soup.points);
  EXPECT_EQ(file->soup.triangles, soup.triangles);
  EXPECT_EQ(file->soup.material, soup.material);
  EXPECT_EQ(file->soup.region, soup.region);
}

}  // namespace
}  // namespace cover
