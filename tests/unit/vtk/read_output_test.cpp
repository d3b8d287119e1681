// Meshes that cover wrote, read back as what cover_mesh() returned.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include <cover/cover_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

/// A checkerboard with a contact and boundary markers.
Output device() {
  Input input = testing::checker(3, 4, 5);
  input.segments[0].name = input.segments[1].name = "drain";
  for (std::size_t s = 0; s < input.segments.size(); s += 3) {
    input.segments[s].marker = static_cast<int>(s) + 1;
  }
  Result<Output> output = cover_mesh(input);
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

/// Interface and marker of every edge that has one, by its ends.
std::map<std::pair<int, int>, std::pair<std::string, int>> edges_of(const Output& output) {
  std::map<std::pair<int, int>, std::pair<std::string, int>> edges;
  const TriMesh& tri = output.mesh.tri();
  for (const auto e : tri.edges()) {
    const InterfaceId id = output.mesh.interface(e);
    if (id == kNoInterface) continue;
    const auto h = tri.halfedge_handle(e, 0);
    const int a = tri.from_vertex_handle(h).idx(), b = tri.to_vertex_handle(h).idx();
    edges[std::minmax(a, b)] = {output.table.interfaces[id.index() - 1].name,
                                output.mesh.marker(e)};
  }
  return edges;
}

void expect_same_mesh(const Output& read, const Output& written) {
  const TriangleSoup a = triangle_soup(read.mesh), b = triangle_soup(written.mesh);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.region, b.region);
  EXPECT_EQ(a.material, b.material);
}

TEST(ReadOutput, VtuWithTheManifestBesideIt) {
  const testing::TemporaryFolder folder;
  Output written = device();
  written.table.regions[2].name = "Si/\xc3\xa9 \"x\"";
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(written, path));
  ASSERT_TRUE(write_manifest(written, folder.path() / "device.json"));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  expect_same_mesh(*read, written);
  EXPECT_TRUE(read->report.notes.empty());
  EXPECT_EQ(edges_of(*read), edges_of(written));
  ASSERT_EQ(read->table.regions.size(), 9U);
  for (std::size_t r = 0; r < 9; ++r) {
    EXPECT_EQ(read->table.regions[r].name, written.table.regions[r].name);
    EXPECT_NEAR(read->table.regions[r].area, written.table.regions[r].area, 1e-15);
  }
  for (std::size_t i = 0; i < written.table.interfaces.size(); ++i) {
    EXPECT_EQ(read->table.interfaces[i].kind, written.table.interfaces[i].kind);
    EXPECT_NEAR(read->table.interfaces[i].length, written.table.interfaces[i].length, 1e-15);
  }
  EXPECT_EQ(read->report.steiner_vertices, written.report.steiner_vertices);
  // It is a whole Output: the promises can be checked on it.
  EXPECT_EQ(verify_cover(read->pslg, read->table, triangle_soup(read->mesh)).violation_count, 0U);
}

TEST(ReadOutput, VtuWithTheVtmBesideIt) {
  const testing::TemporaryFolder folder;
  const Output written = device();
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(written, path));
  ASSERT_TRUE(write_vtm(written, folder.path() / "device.vtm"));
  // A file of the same name that is no manifest is not in the way.
  ASSERT_TRUE(write_report_json(written, folder.path() / "device.json"));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  expect_same_mesh(*read, written);
  EXPECT_EQ(edges_of(*read).size(), edges_of(written).size());
  EXPECT_EQ(read->table.regions[4].name, written.table.regions[4].name);
  EXPECT_TRUE(std::any_of(read->table.interfaces.begin(), read->table.interfaces.end(),
                          [](const Interface& line) {
                            return line.name == "drain" && line.kind == InterfaceKind::contact;
                          }));
}

TEST(ReadOutput, VtmAlone) {
  const testing::TemporaryFolder folder;
  const Output written = device();
  const std::string path = folder.path() / "device.vtm";
  ASSERT_TRUE(write_vtm(written, path));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  expect_same_mesh(*read, written);
  const auto before = edges_of(written), after = edges_of(*read);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [ends, line] : before) EXPECT_EQ(after.at(ends).second, line.second);
}

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

TEST(ReadOutput, EveryFormatWithTheManifestGivesBackAll) {
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
    EXPECT_EQ(read->report.notes.size(), way.options.order == 2 ? 1U : 0U);
    const TriangleSoup after = triangle_soup(read->mesh);
    expect_same_points(after, before, std::string(way.name) == "x.inp");
    EXPECT_EQ(after.triangles, before.triangles);
    EXPECT_EQ(after.region, before.region);
    EXPECT_EQ(after.material, before.material);
    EXPECT_EQ(edges_of(*read), edges_of(written));
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

TEST(ReadOutput, EveryFormatAloneGivesBackWhatItHolds) {
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
    EXPECT_EQ(read->report.notes.size(),
              (way.names && way.materials ? 0U : 1U) + (way.options.order == 2 ? 1U : 0U));
    if (!way.names || std::string(way.name) == "x.inp") continue;
    const bool keeps_all = std::string(way.name) == "x.vtm" || std::string(way.name) == "x.vtkhdf";
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

TEST(ReadOutput, RefusesFormatsWithoutRegions) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"x.obj", "x.off", "x.ply"}) {
    const std::string path = folder.path() / name;
    ASSERT_TRUE(write_mesh(device(), path));
    const Result<Output> read = read_output(path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::unsupported_format);
    EXPECT_NE(read.error().message.find("keeps no regions"), std::string::npos);
  }
}

TEST(ReadOutput, BrokenFilesAreErrors) {
  const testing::TemporaryFolder folder;
  const auto code = [&](const char* name, const std::string& text) {
    const Result<Output> read = read_output(folder.write(name, text));
    return read ? ErrorCode::internal : read.error().code;
  };
  EXPECT_EQ(code("a.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices 1\n0 0 0\nEnd"),
            ErrorCode::syntax);
  EXPECT_EQ(code("b.mesh",
                 "MeshVersionFormatted 2\nDimension 2\nVertices 1\n0 0 0\n"
                 "Triangles 1\n1 2 3 1\nEnd"),
            ErrorCode::id_out_of_range);
  EXPECT_EQ(code("c.mesh", "MeshVersionFormatted 2\nDimension 2\nVertices 9"),
            ErrorCode::truncated);
  EXPECT_EQ(code("a.inp", "*NODE\n1, 0, 0\n*ELEMENT, TYPE=S3, ELSET=A\n1, 1, 2, 3\n"),
            ErrorCode::id_out_of_range);
  EXPECT_EQ(code("b.inp", "*NODE\n1, x, 0\n"), ErrorCode::syntax);
  EXPECT_EQ(code("a.xdmf", "<Xdmf><Domain/></Xdmf>"), ErrorCode::syntax);
  EXPECT_EQ(code("b.xdmf", "no XML"), ErrorCode::syntax);
  EXPECT_EQ(code("a.ele", "1 3 2\n"), ErrorCode::cannot_open);
  (void)folder.write("b.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  EXPECT_EQ(code("b.ele", "1 3 2\n1 1 2 4 1 1\n"), ErrorCode::id_out_of_range);
  // Legacy files that VTK's reader crashed on: cells shorter or longer than they say.
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
  EXPECT_EQ(code("c.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"), ErrorCode::truncated);
}

TEST(ReadOutput, TheManifestSaysHowTheMeshCameAbout) {
  const testing::TemporaryFolder folder;
  Output written = device();
  written.report.unit = "nm";
  written.report.scale = 1e-9;
  written.report.provenance.settings.push_back({"size", "oxide=2"});
  written.report.provenance.settings.push_back({"size", "3"});
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(written, path));
  ASSERT_TRUE(write_manifest(written, folder.path() / "device.json"));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->report.unit, "nm");
  EXPECT_EQ(read->report.scale, 1e-9);
  EXPECT_EQ(read->report.provenance.source, written.report.provenance.source);
  EXPECT_EQ(read->report.provenance.version, COVER_VERSION);
  EXPECT_EQ(read->report.provenance.settings, written.report.provenance.settings);
}

TEST(ReadOutput, WithoutEitherItSaysWhatIsMissing) {
  const testing::TemporaryFolder folder;
  const Output written = device();
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(written, path));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  expect_same_mesh(*read, written);
  ASSERT_EQ(read->report.notes.size(), 1U);
  EXPECT_NE(read->report.notes[0].message.find("device.json"), std::string::npos);
  EXPECT_NE(read->report.notes[0].message.find("device.vtm"), std::string::npos);
  EXPECT_EQ(read->pslg.segments.size(), written.pslg.segments.size());
}

TEST(ReadOutput, RefusesNamesOfAnotherMesh) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(device(), path));
  const Output other = cover_mesh(testing::checker(2, 3, 1)).value();
  ASSERT_TRUE(write_vtm(other, folder.path() / "device.vtm"));
  Result<Output> read = read_output(path);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("another mesh"), std::string::npos);
  ASSERT_TRUE(write_manifest(other, folder.path() / "device.json"));
  read = read_output(path);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("device.json"), std::string::npos);
}

TEST(ReadOutput, SaysWhatIsWrongWithTheFile) {
  const testing::TemporaryFolder folder;
  EXPECT_EQ(read_output("/nowhere/x.vtu").error().code, ErrorCode::cannot_open);
  EXPECT_EQ(read_output("/nowhere/x.vtm").error().code, ErrorCode::cannot_open);
  EXPECT_EQ(read_output(folder.write("x.vtm", "<VTKFile")).error().code, ErrorCode::truncated);
  EXPECT_EQ(read_output(folder.write("x.vtu", "rubbish")).error().code, ErrorCode::syntax);
}

/// Two triangles of two regions.
StoredMesh two_triangles() {
  StoredMesh stored;
  stored.soup.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  stored.soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  stored.soup.region = {1, 2};
  stored.soup.material = {5, 6};
  return stored;
}

TEST(Rebuild, MakesUpWhatIsMissing) {
  const Result<Output> output = rebuild(two_triangles());
  ASSERT_TRUE(output);
  EXPECT_EQ(output->table.regions[1].name, "material_6");
  EXPECT_EQ(output->table.interfaces.size(), 3U);
  EXPECT_EQ(output->pslg.segments.size(), 5U);
}

TEST(Rebuild, RefusesWhatIsNoMesh) {
  const auto message = [](auto change) {
    StoredMesh stored = two_triangles();
    change(stored);
    const Result<Output> output = rebuild(stored);
    return output ? std::string() : output.error().message;
  };
  EXPECT_NE(message([](StoredMesh& s) {
              s.soup.triangles[1] = {0, 1, 3};
            }).find("overlap"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) { s.soup.triangles[1][2] = 9; }).find("vertex 9"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) { s.soup.region[0] = 0; }).find("RegionId 0"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) { s.soup.region[0] = 77; }).find("RegionId 77"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) { s.soup.region.pop_back(); }).find("per triangle"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) { s.soup.points[0].x = std::nan(""); }).find("finite"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) {
              s.edges = {{1, 3, InterfaceId{1}, 0}};
            }).find("no edge"),
            std::string::npos);
  EXPECT_NE(message([](StoredMesh& s) {
              s.edges = {{0, 1, InterfaceId{1}, 0}};
            }).find("interface 1"),
            std::string::npos);
}

}  // namespace
}  // namespace cover
