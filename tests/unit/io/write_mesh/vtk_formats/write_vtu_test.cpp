// A .vtu, read back with VTK's own reader and looked at as bytes.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <filesystem>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"
#include "unit/io/write_mesh/written_text.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

Output checker_output(unsigned threads = 1) {
  Options options;
  options.threads = threads;
  Result<Output> output = cover_mesh(testing::checker(3, 4, 5), options);
  EXPECT_TRUE(output) << output.error().message;
  return std::move(output).value();
}

vtkSmartPointer<vtkUnstructuredGrid> read_vtu(const fs::path& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST(WriteVtu, VtkReadsBackEveryBit) {
  const testing::TemporaryFolder folder;
  const Output output = checker_output();
  const TriMesh& tri = output.mesh.tri();
  const fs::path path = folder.path() / "checker.vtu";
  ASSERT_TRUE(write_vtu(output, path));
  const auto grid = read_vtu(path);
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(tri.n_vertices()));
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(tri.n_faces()));
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (const auto v : tri.vertices()) {
    const double* p = grid->GetPoint(v.idx());
    EXPECT_EQ(TriMesh::Point(p[0], p[1], p[2]), tri.point(v));
  }
  vtkCellData* data = grid->GetCellData();
  for (const auto f : tri.faces()) {
    EXPECT_EQ(grid->GetCellType(f.idx()), VTK_TRIANGLE);
    for (const char* name : {"material", "MaterialID", "mat_id"}) {
      EXPECT_EQ(data->GetArray(name)->GetTuple1(f.idx()), output.mesh.material(f));
    }
    EXPECT_EQ(data->GetArray("RegionId")->GetTuple1(f.idx()), output.mesh.region(f).value());
    const double largest = data->GetArray("max_angle")->GetTuple1(f.idx());
    const double smallest = data->GetArray("min_angle")->GetTuple1(f.idx());
    EXPECT_GE(largest, 60 - 1e-9);
    EXPECT_LE(smallest, 60 + 1e-9);
    EXPECT_GT(smallest, 0);
    EXPECT_LE(largest, output.report.quality.largest_nu.supplement().in_degrees() + 1e-9);
  }
}

TEST(WriteVtu, ArraysStandInTheOrderThatReadersWant) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.path() / "checker.vtu";
  ASSERT_TRUE(write_vtu(checker_output(), path));
  const auto grid = read_vtu(path);
  vtkCellData* data = grid->GetCellData();
  const std::vector<std::pair<std::string, int>> expected{
      {"material", VTK_INT}, {"MaterialID", VTK_INT}, {"max_angle", VTK_DOUBLE},
      {"mat_id", VTK_INT},   {"RegionId", VTK_INT},   {"min_angle", VTK_DOUBLE}};
  ASSERT_EQ(data->GetNumberOfArrays(), static_cast<int>(expected.size()));
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    EXPECT_EQ(data->GetArrayName(i), expected[static_cast<std::size_t>(i)].first);
    EXPECT_EQ(data->GetArray(i)->GetDataType(), expected[static_cast<std::size_t>(i)].second);
  }
  EXPECT_EQ(grid->GetFieldData()->GetNumberOfArrays(), 0);
  const std::string bytes = testing::content(path);
  EXPECT_NE(bytes.find("<CellData Scalars=\"material\">"), std::string::npos);
  EXPECT_NE(bytes.find("header_type=\"UInt64\""), std::string::npos);
  EXPECT_NE(bytes.find("<AppendedData encoding=\"raw\">"), std::string::npos);
  EXPECT_EQ(bytes.find("compressor"), std::string::npos);
  EXPECT_EQ(bytes.find("<FieldData"), std::string::npos);
}

TEST(WriteVtu, SameBytesForAnyNumberOfThreadsAndAnyRepeat) {
  const testing::TemporaryFolder folder;
  std::string first;
  for (const unsigned threads : {1U, 2U, 8U, 1U, 8U}) {
    const fs::path path = folder.path() / "checker.vtu";
    ASSERT_TRUE(write_vtu(checker_output(threads), path));
    if (first.empty()) first = testing::content(path);
    EXPECT_EQ(testing::content(path), first) << threads << " threads";
  }
  EXPECT_FALSE(first.empty());
}

TEST(WriteVtu, SecondOrder) {
  const testing::TemporaryFolder folder;
  const Output output = checker_output();
  const fs::path path = folder.path() / "checker.vtu";
  ASSERT_TRUE(write_vtu(output, path, {.order = 2}));
  const auto grid = read_vtu(path);
  ASSERT_EQ(grid->GetNumberOfPoints(),
            static_cast<vtkIdType>(output.mesh.tri().n_vertices() + output.mesh.tri().n_edges()));
  vtkNew<vtkIdList> nodes;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    ASSERT_EQ(grid->GetCellType(c), VTK_QUADRATIC_TRIANGLE);
    grid->GetCellPoints(c, nodes);
    for (int i = 0; i < 3; ++i) {
      std::array<double, 3> a{}, b{}, middle{};
      grid->GetPoint(nodes->GetId(i), a.data());
      grid->GetPoint(nodes->GetId((i + 1) % 3), b.data());
      grid->GetPoint(nodes->GetId(3 + i), middle.data());
      EXPECT_DOUBLE_EQ(middle[0], (a[0] + b[0]) / 2);
      EXPECT_DOUBLE_EQ(middle[1], (a[1] + b[1]) / 2);
    }
  }
}

TEST(WriteVtu, SaysWhatItCannotWrite) {
  const Output output = checker_output();
  const Status status = write_vtu(output, "/nowhere/checker.vtu");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
  EXPECT_NE(status.error().message.find("/nowhere/checker.vtu"), std::string::npos);
}

}  // namespace
}  // namespace cover
