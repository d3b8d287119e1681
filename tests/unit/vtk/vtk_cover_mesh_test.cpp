#include <cover/vtk_cover_mesh.hpp>

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace {

using Path = std::vector<std::array<double, 2>>;

/// Plane cells at z = 5.
vtkSmartPointer<vtkPolyData> plane(const std::vector<Path>& areas, const std::vector<Path>& lines) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto add = [&](const std::vector<Path>& paths, vtkCellArray* cells) {
    for (const Path& path : paths) {
      cells->InsertNextCell(static_cast<int>(path.size()));
      for (const auto& [x, y] : path) cells->InsertCellPoint(points->InsertNextPoint(x, y, 5));
    }
  };
  vtkNew<vtkCellArray> of_areas, of_lines;
  add(lines, of_lines);
  add(areas, of_areas);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(of_areas);
  data->SetLines(of_lines);
  return data;
}

/// One value for each cell; lines come first.
void name_cells(vtkPolyData& data, const char* array, const std::vector<std::string>& names) {
  vtkNew<vtkStringArray> strings;
  strings->SetName(array);
  for (const std::string& name : names) strings->InsertNextValue(name);
  data.GetCellData()->AddArray(strings);
}

double area_of(vtkPolyData& data, int region) {
  auto* const regions = data.GetCellData()->GetArray("RegionId");
  double area = 0;
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c) {
    if (regions->GetTuple1(c) != region) continue;
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    data.GetCellPoints(c, count, p);
    EXPECT_EQ(count, 3);
    double a[3], b[3], d[3];
    data.GetPoint(p[0], a);
    data.GetPoint(p[1], b);
    data.GetPoint(p[2], d);
    EXPECT_EQ(a[2], 5);
    area += ((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0])) / 2;
  }
  return area;
}

std::vector<std::string> strings(vtkPolyData& data, const char* name) {
  auto* const array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
  std::vector<std::string> out;
  for (vtkIdType k = 0; array != nullptr && k < array->GetNumberOfValues(); ++k)
    out.push_back(array->GetValue(k));
  return out;
}

const Path kLeft{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, kRight{{1, 0}, {3, 0}, {3, 1}, {1, 1}};

TEST(VtkCoverMesh, MeshesPolygonsWithTheirMaterials) {
  const auto input = plane({kLeft, kRight}, {{{0, 0}, {0, 1}}});
  name_cells(*input, "material", {"", "Si", "SiO2"});
  name_cells(*input, "name", {"gate", "", ""});
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(input);
  ASSERT_TRUE(mesher->SetOption("max-angle", "95"));
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  vtkPolyData& mesh = *mesher->GetOutput();
  ASSERT_GE(mesh.GetNumberOfCells(), 4);
  EXPECT_EQ(strings(mesh, "MaterialName"), (std::vector<std::string>{"Si", "SiO2"}));
  EXPECT_EQ(strings(mesh, "RegionName").size(), 2U);
  EXPECT_NEAR(area_of(mesh, 1), 1, 1e-14);
  EXPECT_NEAR(area_of(mesh, 2), 2, 1e-14);
  vtkPolyData& lines = *mesher->GetOutput(1);
  const std::vector<std::string> names = strings(lines, "LineName");
  const auto gate = std::find(names.begin(), names.end(), "gate") - names.begin();
  ASSERT_LT(gate, static_cast<std::ptrdiff_t>(names.size()));
  auto* const ids = lines.GetCellData()->GetArray("LineId");
  double length = 0;
  for (vtkIdType c = 0; c < lines.GetNumberOfCells(); ++c) {
    if (ids->GetTuple1(c) != static_cast<double>(gate + 1)) continue;
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    lines.GetCellPoints(c, count, p);
    double a[3], b[3];
    lines.GetPoint(p[0], a);
    lines.GetPoint(p[1], b);
    EXPECT_EQ(a[0], 0);
    EXPECT_EQ(a[2], 5);
    length += std::abs(b[1] - a[1]);
  }
  EXPECT_NEAR(length, 1, 1e-15);
}

TEST(VtkCoverMesh, OptionsAreThoseOfTheProgram) {
  const auto input = plane({kLeft, kRight}, {});
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(input);
  mesher->Update();
  EXPECT_EQ(strings(*mesher->GetOutput(), "RegionName").size(), 2U);
  EXPECT_EQ(strings(*mesher->GetOutput(), "MaterialName"),
            (std::vector<std::string>{"material_1", "material_1"}));
  ASSERT_TRUE(mesher->SetOption("merge-materials", "true"));
  mesher->Update();
  EXPECT_EQ(strings(*mesher->GetOutput(), "RegionName").size(), 1U);
  EXPECT_NEAR(area_of(*mesher->GetOutput(), 1), 3, 1e-14);
  mesher->ClearOptions();
  mesher->Update();
  EXPECT_EQ(strings(*mesher->GetOutput(), "RegionName").size(), 2U);
  EXPECT_FALSE(mesher->SetOption("max-angel", "100"));
  EXPECT_EQ(mesher->LastError(), "there is no option 'max-angel'");
  EXPECT_FALSE(mesher->SetOption("max-angle", "200"));
  EXPECT_NE(mesher->LastError().find("max-angle: 200 is not above 60"), std::string::npos);
}

TEST(VtkCoverMesh, ReadsTheSizeFieldThatAnOptionNames) {
  vtkObject::GlobalWarningDisplayOff();
  const cover::testing::TemporaryFolder folder;
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(plane({kLeft}, {}));
  ASSERT_TRUE(mesher->SetOption("split-interfaces", "90"));
  ASSERT_TRUE(mesher->SetOption("size-field", folder.path() / "none.csv"));
  mesher->Update();
  EXPECT_NE(mesher->LastError().find("none.csv"), std::string::npos) << mesher->LastError();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  const std::string sizes = "x,y,size\n0,0,.1\n1,0,.1\n1,1,.1\n0,1,.1\n";
  ASSERT_TRUE(mesher->SetOption("size-field", folder.write("sizes.csv", sizes)));
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 100);
  vtkObject::GlobalWarningDisplayOn();
}

TEST(VtkCoverMesh, FailsWhereTheMeshMissesWhatIsRequired) {
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(plane({{{0, 0}, {9, 0}, {4, 1}}}, {}));
  ASSERT_TRUE(mesher->SetOption("max-angle", "95"));
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  ASSERT_TRUE(mesher->SetOption("require", "max-angle"));
  mesher->Update();
  EXPECT_EQ(mesher->LastError().rfind("the mesh does not meet ", 0), 0U) << mesher->LastError();
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  vtkObject::GlobalWarningDisplayOn();
}

TEST(VtkCoverMesh, LinesAloneEncloseRegions) {
  const auto input = plane({}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, {{0, 0}, {1, 1}}});
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  numbers->InsertNextValue(7);
  numbers->InsertNextValue(8);
  input->GetCellData()->AddArray(numbers);
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(input);
  mesher->SetLineArrayName("number");
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  EXPECT_NEAR(area_of(*mesher->GetOutput(), 1), 0.5, 1e-15);
  EXPECT_NEAR(area_of(*mesher->GetOutput(), 2), 0.5, 1e-15);
  const std::vector<std::string> names = strings(*mesher->GetOutput(1), "LineName");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), (std::set<std::string>{"7", "8"}));
}

TEST(VtkCoverMesh, WhatIsWrongIsToldAndLeavesNothing) {
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkCoverMesh> mesher;
  mesher->SetInputData(plane({}, {{{0, 0}, {1, 0}}}));
  mesher->Update();
  EXPECT_NE(mesher->LastError(), "");
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  const auto tilted = plane({kLeft}, {});
  tilted->GetPoints()->SetPoint(2, 1, 1, 6);
  mesher->SetInputData(tilted);
  mesher->Update();
  EXPECT_EQ(mesher->LastError(),
            "the input is not in a plane z = constant: point 0 has z = 5, point 2 6");
  mesher->SetInputData(plane({}, {}));
  mesher->Update();
  EXPECT_NE(mesher->LastError(), "");
  mesher->SetInputData(plane({kLeft}, {}));
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 0);
  vtkObject::GlobalWarningDisplayOn();
}

/// Cells that VTK takes without a look at them, on four points around a square.
vtkSmartPointer<vtkPolyData> unchecked(void (vtkPolyData::*set)(vtkCellArray*),
                                       const std::vector<vtkIdType>& cell) {
  auto data = plane({kLeft}, {});
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  (data->*set)(cells);
  return data;
}

TEST(VtkCoverMesh, RefusesCellsWithPointsThatAreNotThere) {
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkCoverMesh> mesher;
  const auto expect_refused = [&](vtkPolyData* data, const std::string& words) {
    mesher->SetInputData(data);
    mesher->Update();
    EXPECT_NE(mesher->LastError().find(words), std::string::npos) << mesher->LastError();
    EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
  };
  const struct {
    void (vtkPolyData::*set)(vtkCellArray*);
    const char* name;
  } kinds[] = {{&vtkPolyData::SetVerts, "vertex"},
               {&vtkPolyData::SetLines, "line"},
               {&vtkPolyData::SetPolys, "polygon"},
               {&vtkPolyData::SetStrips, "strip"}};
  for (const auto& [set, name] : kinds) {
    SCOPED_TRACE(name);
    const std::string begin = std::string(name) + " 0 of the input has the point ";
    expect_refused(unchecked(set, {0, 1, 4}), begin + "4, but there are 4 points");
    expect_refused(unchecked(set, {0, 1, 1000000000000}), begin + "1000000000000,");
    expect_refused(unchecked(set, {0, -7, 2}), begin + "-7,");
  }
  const auto without_points = plane({kLeft}, {});
  without_points->SetPoints(nullptr);
  expect_refused(without_points, "but there are 0 points");
  const auto torn = plane({kLeft, kRight}, {});
  torn->GetPolys()->GetOffsetsArray()->SetComponent(1, 0, 700);
  expect_refused(torn, "the polygon cells of the input are no cells");
  vtkObject::GlobalWarningDisplayOn();
}

TEST(VtkCoverMesh, RefusesPlacesThatAreNotFiniteAndTakesCellsOfAllKinds) {
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkCoverMesh> mesher;
  for (const double wrong : {std::nan(""), HUGE_VAL}) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto data = plane({kLeft}, {});
      double at[3] = {1, 1, 5};
      at[axis] = wrong;
      data->GetPoints()->SetPoint(2, at);
      mesher->SetInputData(data);
      mesher->Update();
      EXPECT_NE(mesher->LastError(), "");
      EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
    }
  }
  // Polygons of no point, of one and of two have no area.
  const auto data = plane({kLeft, {}, {{0, 0}}, {{0, 0}, {1, 1}}}, {{{0, 0}, {0, 1}, {1, 1}}, {}});
  mesher->SetInputData(data);
  mesher->Update();
  EXPECT_EQ(mesher->LastError(), "");
  EXPECT_NEAR(area_of(*mesher->GetOutput(), 1), 1, 1e-14);
  vtkObject::GlobalWarningDisplayOn();
}

}  // namespace
