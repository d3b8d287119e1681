// The XML is read back by a parser of our own that knows only this shape of file.
#include <gtest/gtest.h>

#include <cover/write_mesh.hpp>

#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

using testing::WrittenCell;
using testing::WrittenMesh;

/// What stands between `before` and the next `after`, from `at` on; moves `at` behind it.
std::string between(const std::string& text, const std::string& before, const std::string& after,
                    std::size_t& at) {
  const std::size_t start = text.find(before, at);
  EXPECT_NE(start, std::string::npos) << before;
  if (start == std::string::npos) return {};
  const std::size_t first = start + before.size(), last = text.find(after, first);
  at = last + after.size();
  return text.substr(first, last - first);
}

/// The next DataItem: its rows and columns and its numbers.
struct DataItem {
  std::size_t rows = 0, columns = 0;
  std::string type;
  testing::Words words;

  DataItem(const std::string& text, std::size_t& at) : words("") {
    testing::Words size(between(text, "<DataItem Dimensions=\"", "\"", at));
    rows = size.index(0);
    columns = size.index(0);
    type = between(text, "NumberType=\"", "\"", at);
    words = testing::Words(between(text, "Format=\"XML\">", "</DataItem>", at));
  }
};

struct Grid {
  std::string topology;
  std::vector<WrittenCell> cells;
  std::vector<Point> points;
  std::vector<std::string> names;  ///< of the attributes
  std::vector<long> group;         ///< by cell
  std::map<long, std::string> groups;
};

Grid parse_grid(const std::string& text) {
  Grid grid;
  std::size_t at = 0;
  grid.topology = between(text, "TopologyType=\"", "\"", at);
  DataItem nodes(text, at);
  for (std::size_t k = 0; k < nodes.rows; ++k) {
    WrittenCell cell;
    for (std::size_t n = 0; n < nodes.columns; ++n) cell.nodes.push_back(nodes.words.index(0));
    grid.cells.push_back(cell);
  }
  EXPECT_TRUE(nodes.words.at_end());
  DataItem points(text, at);
  EXPECT_EQ(points.columns, 2U);
  EXPECT_EQ(points.type, "Float");
  for (std::size_t k = 0; k < points.rows; ++k) {
    const double x = points.words.number(), y = points.words.number();
    grid.points.push_back({x, y});
  }
  while (text.find("<Attribute", at) != std::string::npos) {
    grid.names.push_back(between(text, "<Attribute Name=\"", "\"", at));
    DataItem values(text, at);
    EXPECT_EQ(values.type, "Int");
    EXPECT_EQ(values.rows, grid.cells.size());
    for (WrittenCell& cell : grid.cells) {
      const long value = values.words.integer();
      if (grid.names.size() == 1) cell.number = value;
      if (grid.names.size() == 2) cell.entity = value;
      if (grid.names.size() == 3) grid.group.push_back(value);
    }
    EXPECT_TRUE(values.words.at_end());
  }
  while (text.find("<Information", at) != std::string::npos) {
    const std::string name = between(text, "<Information Name=\"", "\"", at);
    grid.groups[std::stol(between(text, "Value=\"", "\"", at))] = name;
  }
  return grid;
}

class WriteXdmf : public ::testing::Test {
 protected:
  /// The grids `mesh` and `lines`.
  std::pair<Grid, Grid> written(const WriteOptions& options) {
    const Status status = write_xdmf(output_, path_, options);
    EXPECT_TRUE(status) << status.error().message;
    const std::string text = testing::content(path_);
    std::size_t at = 0;
    const std::string mesh = between(text, "<Grid Name=\"mesh\"", "</Grid>", at);
    const std::string lines = between(text, "<Grid Name=\"lines\"", "</Grid>", at);
    return {parse_grid(mesh), parse_grid(lines)};
  }

  testing::TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "x.xdmf").string();
  Output output_ = testing::odd_device();
};

TEST_F(WriteXdmf, TwoGrids) {
  auto [mesh, lines] = written({});
  EXPECT_EQ(mesh.topology, "Triangle");
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"MaterialID", "RegionId", "GroupID"}));
  EXPECT_EQ(lines.topology, "PolyLine");
  EXPECT_EQ(lines.names, (std::vector<std::string>{"LineID", "Marker"}));
  EXPECT_EQ(mesh.points, lines.points);
  for (const WrittenCell& line : lines.cells)
    EXPECT_EQ(line.entity == 11, lines.groups.at(line.number) == "gate") << "marker";
  for (WrittenCell& line : lines.cells) line.entity = 0;

  const WrittenMesh file{mesh.points, mesh.cells, lines.cells, {}, lines.groups, true};
  testing::expect_same_triangles(output_, file);
  testing::expect_materials(output_, file);
  WrittenMesh groups{mesh.points, mesh.cells, {}, mesh.groups, {}, true};
  for (std::size_t t = 0; t < groups.triangles.size(); ++t)
    groups.triangles[t].number = mesh.group.at(t);
  testing::expect_region_groups(output_, groups);
  testing::expect_same_lines(output_, {mesh.points, {}, lines.cells, {}, lines.groups, true});
}

TEST_F(WriteXdmf, SecondOrder) {
  WriteOptions options;
  options.order = 2;
  auto [mesh, lines] = written(options);
  EXPECT_EQ(mesh.topology, "Triangle_6");
  EXPECT_EQ(lines.topology, "Edge_3");
  for (WrittenCell& line : lines.cells) line.entity = 0;
  const WrittenMesh file{mesh.points, mesh.cells, lines.cells, {}, {}};
  testing::expect_same_triangles(output_, file, 2);
  testing::expect_same_lines(output_, file);
}

}  // namespace
}  // namespace cover
