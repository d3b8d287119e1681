// Every format, written and read back. What each format means, and broken files, stand in formats/.
#include <gtest/gtest.h>

#include <algorithm>

#include <cover/cover_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/mesh_shape.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/read_mesh/edges_of.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

/// A format in which a mesh can be written and read again.
struct Way {
  const char* name;
  WriteOptions options;
  bool names = false;  ///< the file alone has names of regions and contacts
  bool materials = true;
};

const std::vector<Way>& ways() {
  static const std::vector<Way> all = [] {
    std::vector<Way> list;
    for (const int order : {1, 2}) {
      list.push_back({"x.vtu", {.order = order}});
      list.push_back({"x.vtk", {.order = order}});
      list.push_back({"x.vtk", {.order = order, .lines = true}});
      list.push_back({"x.vtm", {.order = order}, true});
      list.push_back({"x.msh", {.order = order}, true, false});
      list.push_back({"x.msh", {.order = order, .inner_lines = false}, true, false});
      list.push_back({"x.msh", {.order = order, .msh = "4.1"}, true, false});
      list.push_back({"x.xdmf", {.order = order}, true});
      list.push_back({"x.xdmf", {.order = order, .xdmf = "hdf5"}, true});
      list.push_back({"x.mesh", {.order = order}});
      list.push_back({"x.ele", {.order = order}});
      list.push_back({"x.inp", {.order = order}, true, false});
      for (const char* ids : {"region", "material", "name"}) {
        const bool names = ids != std::string("material");
        list.push_back({"x.vtk", {.order = order, .ids = ids}});
        list.push_back({"x.vtk", {.order = order, .lines = true, .ids = ids}});
        list.push_back({"x.msh", {.order = order, .ids = ids}, names, false});
        list.push_back({"x.msh", {.order = order, .msh = "4.1", .ids = ids}, names, false});
        list.push_back({"x.mesh", {.order = order, .ids = ids}, false, false});
        list.push_back({"x.ele", {.order = order, .ids = ids}});
      }
      list.push_back({"x.vtkhdf", {.order = order}, true});
    }
    return list;
  }();
  return all;
}

std::string describe(const Way& way) {
  return way.name + std::string(" of order ") + std::to_string(way.options.order) + ", .msh " +
         way.options.msh + (way.options.lines ? ", with lines" : "") +
         (way.options.inner_lines ? "" : ", without inner lines");
}

/// An Abaqus deck has 20 characters for a number, too few for some.
void expect_same_points(const TriangleSoup& read, const TriangleSoup& written, bool rounded) {
  if (!rounded) {
    EXPECT_EQ(read.points, written.points);
    return;
  }
  ASSERT_EQ(read.points.size(), written.points.size());
  for (std::size_t v = 0; v < read.points.size(); ++v) {
    EXPECT_NEAR(read.points[v].x, written.points[v].x, 1e-15 * std::abs(written.points[v].x));
    EXPECT_NEAR(read.points[v].y, written.points[v].y, 1e-15 * std::abs(written.points[v].y));
  }
}

TEST(ReadMesh, EveryFormatWithTheManifestGivesBackAll) {
  const Output written = testing::odd_device();
  const TriangleSoup before = triangle_soup(written.mesh);
  for (const Way& way : ways()) {
    SCOPED_TRACE(describe(way));
    const testing::TemporaryFolder folder;
    const std::string path = folder.path() / way.name;
    ASSERT_TRUE(write_mesh(written, path, way.options));
    ASSERT_TRUE(write_manifest(written, folder.path() / "x.json", way.options));
    const Result<Output> read = read_output(path);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->report.notes.empty());
    const TriangleSoup after = triangle_soup(read->mesh);
    expect_same_points(after, before, std::string(way.name) == "x.inp");
    EXPECT_EQ(after.triangles, before.triangles);
    EXPECT_EQ(after.region, before.region);
    EXPECT_EQ(after.material, before.material);
    EXPECT_EQ(testing::edges_of(*read), testing::edges_of(written));
    ASSERT_EQ(read->table.regions.size(), written.table.regions.size());
    for (std::size_t r = 0; r < written.table.regions.size(); ++r) {
      EXPECT_EQ(read->table.regions[r].name, written.table.regions[r].name);
      EXPECT_EQ(read->table.regions[r].material_name, written.table.regions[r].material_name);
    }
    ASSERT_EQ(read->table.interfaces.size(), written.table.interfaces.size());
    for (std::size_t i = 0; i < written.table.interfaces.size(); ++i) {
      EXPECT_EQ(read->table.interfaces[i].name, written.table.interfaces[i].name);
      EXPECT_EQ(read->table.interfaces[i].kind, written.table.interfaces[i].kind);
    }
    // And on into the next format, byte for byte.
    ASSERT_TRUE(write_msh(written, folder.path() / "before.msh"));
    ASSERT_TRUE(write_msh(*read, folder.path() / "after.msh"));
    if (std::string(way.name) != "x.inp") {
      EXPECT_EQ(testing::content((folder.path() / "after.msh").string()),
                testing::content((folder.path() / "before.msh").string()));
    }
  }
}

TEST(ReadMesh, EveryFormatAloneGivesBackWhatItHolds) {
  const Output written = testing::odd_device();
  const TriangleSoup before = triangle_soup(written.mesh);
  for (const Way& way : ways()) {
    SCOPED_TRACE(describe(way));
    const testing::TemporaryFolder folder;
    const std::string path = folder.path() / way.name;
    ASSERT_TRUE(write_mesh(written, path, way.options));
    const Result<Output> read = read_output(path);
    ASSERT_TRUE(read) << read.error().message;
    const TriangleSoup after = triangle_soup(read->mesh);
    expect_same_points(after, before, std::string(way.name) == "x.inp");
    EXPECT_EQ(after.triangles.size(), before.triangles.size());
    EXPECT_EQ(read->table.regions.size(), written.table.regions.size());
    if (way.materials) {
      EXPECT_EQ(after.material, before.material);
    }
    const bool keeps_all = std::string(way.name) == "x.vtm" || std::string(way.name) == "x.vtkhdf";
    EXPECT_EQ(read->report.notes.size(), keeps_all ? 0U : 1U);
    if (!way.names || std::string(way.name) == "x.inp") continue;
    EXPECT_EQ(read->table.regions[0].name, keeps_all ? "Si/\"n\"" : "Si/_n_");
    if (keeps_all) {
      for (std::size_t r = 0; r < written.table.regions.size(); ++r)
        EXPECT_EQ(read->table.regions[r].material_name, written.table.regions[r].material_name);
    }
    const MeshView now = view_of(*read, {}), then = view_of(written, {});
    for (const char* contact : {"gate", "drain_contact"}) {
      const auto lines = [&](const MeshView& view) {
        return std::count_if(
            view.line_group.begin(), view.line_group.end(),
            [&](std::uint32_t group) { return view.line_groups[group].name == contact; });
      };
      EXPECT_EQ(lines(now), lines(then)) << contact;
    }
  }
}

TEST(ReadMesh, CutsGoOnIntoTheNextFile) {
  Options options;
  options.split_interfaces = Angle::degrees(90);
  const Output written = testing::must_mesh(testing::random_cells(12, 1), options);
  const std::size_t cuts = written.pslg.points.size() - written.report.input_points;
  ASSERT_GT(cuts, 0u);
  const testing::TemporaryFolder folder;
  ASSERT_TRUE(write_mesh(written, folder.path() / "a.vtm"));
  ASSERT_TRUE(write_mesh(written, folder.path() / "b.vtu"));
  ASSERT_TRUE(write_mesh(written, folder.path() / "c.pvtu", WriteOptions{.parts = 3}));
  for (const char* name : {"a.vtm", "b.vtu", "c.pvtu"}) {
    SCOPED_TRACE(name);
    const Result<Output> read = read_output(folder.path() / name);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->pslg.points.size() - read->report.input_points, cuts);
    ASSERT_TRUE(write_mesh(*read, folder.path() / "alone.vtu"));
    const Result<MeshFile> alone = read_mesh(folder.path() / "alone.vtu");
    ASSERT_TRUE(alone) << alone.error().message;
    EXPECT_EQ(alone->cut_vertices, cuts);
  }
}

TEST(ReadMesh, RefusesFormatsWithoutRegions) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"x.obj", "x.off", "x.ply"}) {
    const std::string path = folder.path() / name;
    ASSERT_TRUE(write_mesh(testing::odd_device(), path));
    const Result<Output> read = read_output(path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::unsupported_format);
    EXPECT_NE(read.error().message.find("keeps no regions"), std::string::npos);
  }
}

TEST(ReadMesh, CellsOfLegacyFilesThatAreShorterOrLongerThanTheySayAreRefused) {
  const testing::TemporaryFolder folder;
  const auto code = [&](const char* name, const std::string& text) {
    const Result<Output> read = read_output(folder.write(name, text));
    return read ? ErrorCode::internal : read.error().code;
  };
  // VTK's reader crashed on these.
  const std::string head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const std::string points = "POINTS 3 double\n0 0 0 1 0 0 0 1 0\n";
  const std::string rest =
      "CELL_TYPES 1\n5\nCELL_DATA 1\nSCALARS RegionId int 1\nLOOKUP_TABLE default\n1\n";
  EXPECT_EQ(code("a.vtk", head + points + "CELLS 1 2\n3 0 1 2\n" + rest), ErrorCode::syntax);
  EXPECT_EQ(code("b.vtk", head + points + "CELLS 1 9\n3 0 1 2\n" + rest), ErrorCode::syntax);
  EXPECT_EQ(code("c.vtk", head + points + "CELLS 1 4\n3 0 1 7\n" + rest), ErrorCode::syntax);
  EXPECT_EQ(code("d.vtk", head + "POINTS 99999999 double\n0 0 0\nCELLS 1 4\n3 0 1 2\n" + rest),
            ErrorCode::truncated);
  EXPECT_EQ(code("e.vtk", "# vtk DataFile Version 3\nx\nASCII\n" + points), ErrorCode::syntax);
  EXPECT_TRUE(read_output(folder.write("f.vtk", head + points + "CELLS 1 4\n3 0 1 2\n" + rest)));
}

}  // namespace
}  // namespace cover
