// Meshes that cover wrote, read back as what cover_mesh() returned, with and without the files that
// name their parts. The formats one by one: read_mesh_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include <cover/cover_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/verify.hpp>
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

#include "io/text/text.hpp"
#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_mesh.hpp"
#include "unit/io/read_mesh/edges_of.hpp"

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
  EXPECT_EQ(testing::edges_of(*read), testing::edges_of(written));
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
  EXPECT_EQ(testing::edges_of(*read).size(), testing::edges_of(written).size());
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
  const auto before = testing::edges_of(written), after = testing::edges_of(*read);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [ends, line] : before) EXPECT_EQ(after.at(ends).second, line.second);
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

TEST(ReadOutput, RefusesNumbersOfLinesWithoutEnd) {
  const testing::TemporaryFolder folder;
  const Output written = device();
  const std::string path = folder.path() / "device.vtu", names = folder.path() / "device.json";
  ASSERT_TRUE(write_vtu(written, path));
  ASSERT_TRUE(write_manifest(written, names));
  std::string text = read_file(names).value();
  const std::size_t id = text.find("\"id\"", text.find("\"lines\": ["));
  ASSERT_NE(id, std::string::npos);
  const std::size_t first = text.find_first_of("0123456789", id);
  text.replace(first, text.find_first_not_of("0123456789", first) - first, "4294967295");
  std::ofstream(names) << text;
  const Result<Output> read = read_output(path);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("a line has the number 4294967295"), std::string::npos)
      << read.error().message;
}

/// What stands for a member of the manifest of device(), behind its n-th mention.
std::string refusal_with(const std::string& member, int mention, const std::string& value) {
  const testing::TemporaryFolder folder;
  const Output written = device();
  const std::string path = folder.path() / "device.vtu", names = folder.path() / "device.json";
  EXPECT_TRUE(write_vtu(written, path));
  EXPECT_TRUE(write_manifest(written, names));
  std::string text = read_file(names).value();
  std::size_t at = 0;
  for (int k = 0; k < mention; ++k) at = text.find('"' + member + '"', at + 1);
  const std::size_t first = text.find_first_of("-0123456789", at + member.size());
  text.replace(first, text.find_first_not_of("-0123456789", first) - first, value);
  std::ofstream(names) << text;
  const Result<Output> read = read_output(path);
  return read ? "" : read.error().message;
}

TEST(ReadOutput, RefusesNumbersThatAreNoCountsAndIds) {
  for (const char* const member : {"vertices", "triangles", "input_vertices", "cut_vertices",
                                   "left", "right", "edges", "material"}) {
    for (const char* const value : {"1e300", "-1e300", "0.5", "99999999999", "-99999999999"}) {
      const std::string told = refusal_with(member, 1, value);
      EXPECT_NE(told.find('"' + std::string(member) + "\": "), std::string::npos) << told;
      EXPECT_NE(told.find("is no whole number from "), std::string::npos) << told;
    }
  }
  const std::string told = refusal_with("vertices", 1, "-1");
  EXPECT_NE(told.find("\"vertices\": -1 is no whole number from 0 to 4294967295"),
            std::string::npos)
      << told;
  EXPECT_FALSE(refusal_with("vertices", 1, "\"7\"").empty());
  EXPECT_NE(refusal_with("triangles", 1, "1").find("1 triangles instead of"), std::string::npos);
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

/// 4294967303 is 7 but for bits that a material's number has not.
TEST(ReadOutput, MaterialsWithTooManyDigitsStayApart) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.write(
      "x.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n"
      "$EndNodes\n$Elements\n2\n1 2 2 4294967303 1 1 2 3\n2 2 2 7 2 1 3 4\n$EndElements\n");
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(triangle_soup(read->mesh).material, (std::vector<std::int64_t>{1, 7}));
  EXPECT_TRUE(
      std::any_of(read->report.notes.begin(), read->report.notes.end(), [](const Note& note) {
        return note.message.ends_with(
            "material 4294967303 is larger than 2147483647: it becomes number 1");
      }));
}

TEST(ReadOutput, RefusesNamesOfAnotherMesh) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "device.vtu";
  ASSERT_TRUE(write_vtu(device(), path));
  const Output other = cover_mesh(testing::checker(2, 3, 1)).value();
  ASSERT_TRUE(write_vtm(other, folder.path() / "device.vtm"));
  // What an earlier run left: names are made up, and that is told.
  Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->report.notes.size(), 1U);
  EXPECT_NE(read->report.notes[0].message.find("device.vtm is of another mesh: they are made up"),
            std::string::npos)
      << read->report.notes[0].message;
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

}  // namespace
}  // namespace cover
