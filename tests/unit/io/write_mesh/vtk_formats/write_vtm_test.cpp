// A .vtm and its pieces, read back with VTK's own reader and looked at as files.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <stop_token>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/read_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

Output output_with_blocks() {
  Result<Output> output = cover_mesh(testing::checker(3, 4, 5));
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

/// Names of the blocks of block `k`.
std::map<std::string, vtkSmartPointer<vtkUnstructuredGrid>> blocks_of(vtkMultiBlockDataSet* root,
                                                                      unsigned k) {
  std::map<std::string, vtkSmartPointer<vtkUnstructuredGrid>> blocks;
  auto* group = vtkMultiBlockDataSet::SafeDownCast(root->GetBlock(k));
  for (unsigned i = 0; group != nullptr && i < group->GetNumberOfBlocks(); ++i) {
    blocks[group->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())] =
        vtkUnstructuredGrid::SafeDownCast(group->GetBlock(i));
  }
  return blocks;
}

TEST(WriteVtm, NamedBlocksForRegionsAndInterfaces) {
  const testing::TemporaryFolder folder;
  Output output = output_with_blocks();
  output.table.regions[3].name = "a/b";
  for (Region& region : output.table.regions)  // two materials, one name
    if (region.id.value() > 4) region.name = "Si";
  const fs::path path = folder.path() / "checker.vtm";
  for (int repeat = 0; repeat < 2; ++repeat) {  // the second replaces the first
    ASSERT_TRUE(write_vtm(output, path));
    vtkNew<vtkXMLMultiBlockDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    auto* root = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    ASSERT_NE(root, nullptr);
    ASSERT_EQ(root->GetNumberOfBlocks(), 2U);
    EXPECT_STREQ(root->GetMetaData(0U)->Get(vtkCompositeDataSet::NAME()), "regions");
    EXPECT_STREQ(root->GetMetaData(1U)->Get(vtkCompositeDataSet::NAME()), "interfaces");
    const auto regions = blocks_of(root, 0), lines = blocks_of(root, 1);
    const MeshView view = view_of(output, {});
    EXPECT_EQ(regions.size(), view.region_groups.size());
    EXPECT_EQ(lines.size(), view.line_groups.size());
    for (const Group& group : view.region_groups) EXPECT_TRUE(regions.contains(group.label));
    for (const Group& group : view.line_groups) EXPECT_TRUE(lines.contains(group.label));
    EXPECT_TRUE(regions.contains("a/b"));
    EXPECT_TRUE(regions.contains("Si"));
    EXPECT_TRUE(regions.contains("Si_2"));
    vtkIdType cells = 0;
    for (const auto& [name, grid] : regions) cells += grid->GetNumberOfCells();
    EXPECT_EQ(cells, static_cast<vtkIdType>(output.mesh.tri().n_faces()));
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 2U) << "checker.vtm and the folder of its pieces";
}

/// Many cells in a row, each of a name of its own, with a contact at the bottom.
Output row_of_parcels(int count) {
  Input input;
  for (int k = 0; k <= count; ++k) {
    input.points.push_back({1.0 * k, 0});
    input.points.push_back({1.0 * k, 1});
  }
  const auto add = [&](int a, int b, const char* name) {
    InputSegment segment;
    segment.a = static_cast<std::uint32_t>(a);
    segment.b = static_cast<std::uint32_t>(b);
    segment.name = name;
    input.segments.push_back(segment);
  };
  for (int k = 0; k <= count; ++k) add(2 * k, 2 * k + 1, "");
  for (int k = 0; k < count; ++k) add(2 * k, 2 * k + 2, k < 3 ? "road" : "");
  for (int k = 0; k < count; ++k) add(2 * k + 1, 2 * k + 3, "");
  Result<Output> output = cover_mesh(std::move(input));
  EXPECT_TRUE(output);
  for (Region& region : output->table.regions) {
    region.name = "parcel " + std::to_string(region.id.value());
    region.material_name = "f\xc3\xa4rm";
  }
  return std::move(output).value();
}

TEST(WriteVtm, OneFilePerNameAtMostAndOneForAllLinesOfMany) {
  const testing::TemporaryFolder folder;
  const Output output = row_of_parcels(150);
  const fs::path path = folder.path() / "map.vtm";
  ASSERT_TRUE(write_vtm(output, path));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path() / "map")) ++files;
  EXPECT_EQ(files, 150U + 2U) << "regions, the road, all other lines";
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto blocks =
      blocks_of(vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0)), 1);
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks.at("road")->GetNumberOfCells(), 3);
  EXPECT_EQ(blocks.at("lines")->GetNumberOfCells() + 3,
            static_cast<vtkIdType>(output.pslg.segments.size()));
  const Result<Output> read = read_output(path);
  ASSERT_TRUE(read) << read.error().message;
  for (std::size_t r = 0; r < 150; ++r) {
    EXPECT_EQ(read->table.regions[r].name, output.table.regions[r].name);
    EXPECT_EQ(read->table.regions[r].material_name, "f\xc3\xa4rm");
  }
  ASSERT_EQ(read->table.interfaces.size(), output.table.interfaces.size());
  for (std::size_t k = 0; k < output.table.interfaces.size(); ++k)
    EXPECT_EQ(read->table.interfaces[k].name, output.table.interfaces[k].name);
}

TEST(WriteVtm, PiecesThatAreThereAreNotTouched) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "map.vtm", pieces = folder.path() / "map";
  ASSERT_TRUE(write_vtm(row_of_parcels(20), path));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const auto& entry : fs::directory_iterator(pieces)) fs::last_write_time(entry, long_ago);
  Output other = row_of_parcels(20);
  other.mesh.set_material(other.mesh.tri().face_handle(0), 77);
  ASSERT_TRUE(write_vtm(other, path));
  std::size_t old = 0, fresh = 0;
  for (const auto& entry : fs::directory_iterator(pieces))
    ++(fs::last_write_time(entry) < long_ago + std::chrono::minutes(1) ? old : fresh);
  EXPECT_EQ(fresh, 1U);
  EXPECT_GT(old, 20U);
}

/// All files below a folder, by their names in it.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).string()] = testing::content(entry.path());
  return files;
}

TEST(WriteVtm, ReplacesItsOwnPiecesOnly) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "checker.vtm", pieces = folder.path() / "checker";
  const std::vector<std::string> foreign{
      "checker/device.poly", "checker/checker_notes.vtu", "checker/checker_.vtu",
      "checker/other_0.vtu", "checker/deep/checker_0.vtu",
      // As ParaView numbers the files of a time series.
      "checker/checker_7.vtu", "checker/checker_8_0123456789abcdeg.vtu"};
  fs::create_directories(pieces / "deep");
  for (const std::string& name : foreign) (void)folder.write(name, name);
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  const auto first = contents(folder.path());
  // What a killed run leaves behind, and a piece of a .vtm that VTK wrote.
  (void)folder.write("checker/checker_99_0123456789abcdef.vtu", "");
  (void)folder.write("checker/.checker.3.tmp", "");
  (void)folder.write(".checker.vtm.0.tmp", "");
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  EXPECT_EQ(contents(folder.path()), first) << "same bytes, same names, nothing else";
  (void)folder.write("checker.vtm", "<DataSet index=\"0\" file=\"checker/checker_99.vtu\"/>");
  (void)folder.write("checker/checker_99.vtu", "");
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  EXPECT_EQ(contents(folder.path()), first);
  Output other = output_with_blocks();
  other.table.regions[3].material = 77;
  ASSERT_TRUE(write_vtm(other, path));
  const auto second = contents(folder.path());
  EXPECT_NE(second, first);
  for (const std::string& name : foreign) EXPECT_EQ(second.at(name), name);
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  EXPECT_EQ(contents(folder.path()), first);
}

TEST(WriteVtm, MendsADamagedPiece) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "checker.vtm";
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  const auto whole = contents(folder.path());
  for (const auto& entry : fs::directory_iterator(folder.path() / "checker"))
    fs::resize_file(entry.path(), 10);
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  EXPECT_EQ(contents(folder.path()), whole);
}

TEST(WriteVtm, LosesNothingWhereItFails) {
  const testing::TemporaryFolder folder;
  const Output output = output_with_blocks();
  const fs::path path = folder.path() / "checker.vtm";
  // A folder under the name of the file.
  fs::create_directories(path / "in the way");
  (void)folder.write("checker.vtm/input.poly", "1");
  ASSERT_FALSE(write_vtm(output, path));
  EXPECT_EQ(contents(folder.path()).size(), 1U);
  EXPECT_FALSE(fs::exists(folder.path() / "checker"));
  // A file under the name of the folder.
  const fs::path other = folder.path() / "device.vtm";
  (void)folder.write("device", "input");
  const Status status = write_vtm(output, other);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("device.vtm"), std::string::npos);
  EXPECT_EQ(testing::content(folder.path() / "device"), "input");
}

TEST(WriteVtm, HeedsAStop) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "checker.vtm";
  WriteOptions stopped;
  std::stop_source source;
  source.request_stop();
  stopped.stop = source.get_token();
  Status status = write_vtm(output_with_blocks(), path, stopped);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cancelled);
  EXPECT_TRUE(fs::is_empty(folder.path()));
  ASSERT_TRUE(write_vtm(output_with_blocks(), path));
  const auto before = contents(folder.path());
  Output other = output_with_blocks();
  other.table.regions[3].material = 77;
  status = write_vtm(other, path, stopped);
  ASSERT_FALSE(status);
  EXPECT_EQ(contents(folder.path()), before);
}

TEST(WriteVtm, KeepsPermissionsAndLinks) {
  const testing::TemporaryFolder folder;
  const fs::path link = folder.path() / "link.vtm", path = folder.path() / "real" / "checker.vtm";
  fs::create_directory(folder.path() / "real");
  fs::create_symlink("real/checker.vtm", link);
  (void)folder.write("real/checker.vtm", "");
  fs::permissions(path, fs::perms(0600));
  ASSERT_TRUE(write_vtm(output_with_blocks(), link));
  EXPECT_TRUE(fs::is_symlink(link));
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "real")) {
    EXPECT_EQ(entry.status().permissions(), fs::perms(entry.is_directory() ? 0700 : 0600))
        << entry.path();
  }
  const Result<Output> read = read_output(link);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->mesh.tri().n_faces(), output_with_blocks().mesh.tri().n_faces());
}

TEST(WriteVtm, LinesHaveTheirLeftRegionOnTheLeft) {
  const testing::TemporaryFolder folder;
  const Output output = output_with_blocks();
  const fs::path path = folder.path() / "checker.vtm";
  ASSERT_TRUE(write_vtm(output, path));
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto lines =
      blocks_of(vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0)), 1);
  const TriMesh& tri = output.mesh.tri();
  std::size_t segments = 0;
  for (const auto& [name, grid] : lines) {
    vtkDataArray* ids = grid->GetPointData()->GetArray("GlobalNodeId");
    ASSERT_NE(ids, nullptr) << name;
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c, ++segments) {
      vtkNew<vtkIdList> ends;
      grid->GetCellPoints(c, ends);
      const auto vertex = [&](int i) {
        return TriMesh::VertexHandle(static_cast<int>(ids->GetTuple1(ends->GetId(i))));
      };
      const auto h = tri.find_halfedge(vertex(0), vertex(1));
      ASSERT_TRUE(h.is_valid());
      EXPECT_EQ(grid->GetCellData()->GetArray("LeftRegion")->GetTuple1(c),
                output.mesh.region(tri.face_handle(h)).value());
      EXPECT_EQ(grid->GetCellData()->GetArray("LineID")->GetTuple1(c),
                output.mesh.interface(tri.edge_handle(h)).value());
    }
  }
  EXPECT_EQ(segments, output.pslg.segments.size());
}

}  // namespace
}  // namespace cover
