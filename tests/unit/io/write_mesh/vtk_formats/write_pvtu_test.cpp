// .pvtu: VTK's own reader puts the parts together again.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/option_ranges.hpp>
#include <cover/verify.hpp>
#include <cover/write_mesh.hpp>

#include "support/inputs/inputs.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

double number(vtkDataArray* array, vtkIdType k) { return array->GetComponent(k, 0); }

TEST(WritePvtu, VtkReadsEveryTriangleOnceAndGhostsBeside) {
  const testing::TemporaryFolder folder;
  const Result<Output> output = cover_mesh(testing::checker(5, 4, 2));
  ASSERT_TRUE(output);
  const TriangleSoup soup = triangle_soup(output->mesh);
  const std::string path = folder.path() / "x.pvtu";
  for (const int parts : {1, 2, 5}) {
    SCOPED_TRACE(parts);
    ASSERT_TRUE(write_mesh(*output, path, WriteOptions{.parts = parts}));
    vtkNew<vtkXMLPUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->UpdateInformation();
    std::size_t own = 0, own_points = 0, ghosts = 0;
    std::map<long, int> owner_of;
    for (int part = 0; part < parts; ++part) {
      reader->UpdatePiece(part, parts, 0);
      vtkUnstructuredGrid* const grid = reader->GetOutput();
      const auto of_cells = [&](const char* name) { return grid->GetCellData()->GetArray(name); };
      const auto of_points = [&](const char* name) { return grid->GetPointData()->GetArray(name); };
      for (const char* name :
           {"material", "RegionId", "max_angle", "Owner", "GlobalCellId", "vtkGhostType"})
        ASSERT_NE(of_cells(name), nullptr) << name;
      for (const char* name : {"Owner", "GlobalNodeId", "vtkGhostType"})
        ASSERT_NE(of_points(name), nullptr) << name;
      EXPECT_EQ(grid->GetCellData()->GetGlobalIds(), of_cells("GlobalCellId"));
      for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
        const auto id = static_cast<std::size_t>(number(of_cells("GlobalCellId"), c));
        const auto owner = static_cast<int>(number(of_cells("Owner"), c));
        EXPECT_EQ(number(of_cells("vtkGhostType"), c), owner == part ? 0 : 1);
        EXPECT_EQ(number(of_cells("RegionId"), c), soup.region[id]);
        const auto [known, is_new] = owner_of.emplace(id, owner);
        EXPECT_EQ(known->second, owner);
        (owner == part ? own : ghosts) += 1;
        vtkNew<vtkIdList> corners;
        grid->GetCellPoints(c, corners);
        ASSERT_EQ(corners->GetNumberOfIds(), 3);
        for (int k = 0; k < 3; ++k) {
          const vtkIdType p = corners->GetId(k);
          EXPECT_EQ(number(of_points("GlobalNodeId"), p), soup.triangles[id][std::size_t(k)]);
          EXPECT_EQ(grid->GetPoint(p)[0], soup.points[soup.triangles[id][std::size_t(k)]].x);
        }
      }
      for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
        own_points += number(of_points("vtkGhostType"), p) == 0 ? 1 : 0;
    }
    EXPECT_EQ(own, soup.triangles.size());
    EXPECT_EQ(owner_of.size(), soup.triangles.size());
    EXPECT_EQ(own_points, output->mesh.vertices());
    EXPECT_EQ(ghosts > 0, parts > 1);
  }
}

TEST(WritePvtu, LeavesNothingOfWhatItReplaces) {
  const testing::TemporaryFolder folder;
  const Result<Output> output = cover_mesh(testing::checker(3, 4, 2));
  ASSERT_TRUE(output);
  const std::string path = folder.path() / "x.pvtu";
  ASSERT_TRUE(write_mesh(*output, path, WriteOptions{.parts = 7}));
  ASSERT_TRUE(write_mesh(*output, path, WriteOptions{.parts = 2}));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "x.parts")) {
    (void)entry;
    ++files;
  }
  EXPECT_EQ(files, 2U);
}

TEST(WritePvtu, RefusesPartsThatAreNone) {
  for (const int parts : {0, -1, static_cast<int>(ranges::kParts.high) + 1})
    EXPECT_FALSE(can_write("x.pvtu", WriteOptions{.parts = parts}));
  EXPECT_FALSE(can_write("x.vtu", WriteOptions{.parts = 2}));
  EXPECT_TRUE(can_write("x.vtu", {}));
}

}  // namespace
}  // namespace cover
