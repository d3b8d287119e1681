// What VTK's own writers write, in all their ways, against the data sets that they were given.
#include "io/vtk_files/read_data_set.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/core.h>
#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkRectilinearGrid.h>
#include <vtkRectilinearGridWriter.h>
#include <vtkShortArray.h>
#include <vtkSignedCharArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkStructuredGrid.h>
#include <vtkStructuredGridWriter.h>
#include <vtkStructuredPoints.h>
#include <vtkStructuredPointsWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkUnsignedLongArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

template <class Array>
void add_array(vtkDataSetAttributes& data, const char* name, vtkIdType items) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(items);
  const int most = std::string_view(name) == "bits" ? 2 : 100;
  for (vtkIdType k = 0; k < items; ++k)
    array->SetTuple1(k, static_cast<double>((7 * k + 1) % most));
  data.AddArray(array);
}

/// Arrays of all types; the one of bytes is active, as the material of a label image is.
void add_arrays(vtkDataSetAttributes* data, vtkIdType items) {
  add_array<vtkUnsignedCharArray>(*data, "bytes", items);
  data->SetActiveScalars("bytes");
  add_array<vtkSignedCharArray>(*data, "signed", items);
  add_array<vtkShortArray>(*data, "short", items);
  add_array<vtkUnsignedShortArray>(*data, "unsigned short", items);
  add_array<vtkIntArray>(*data, "int", items);
  add_array<vtkUnsignedIntArray>(*data, "unsigned int", items);
  add_array<vtkLongArray>(*data, "long", items);
  add_array<vtkUnsignedLongArray>(*data, "unsigned long", items);
  add_array<vtkIdTypeArray>(*data, "Gr\xc3\xb6\xc3\x9f e 100%", items);
  add_array<vtkFloatArray>(*data, "float", items);
  add_array<vtkBitArray>(*data, "bits", items);
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  for (vtkIdType k = 0; k < items; ++k)
    strings->InsertNextValue(std::string(static_cast<std::size_t>(90 * k % 400), 'x') + "\n \xff");
  data->AddArray(strings);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetComponentName(0, "first one");
  for (vtkIdType k = 0; k < items; ++k) vectors->InsertNextTuple3(1, 2, static_cast<double>(k));
  data->AddArray(vectors);
  vtkNew<vtkDoubleArray> doubles;
  doubles->SetName("doubles");
  for (vtkIdType k = 0; k < items; ++k)
    doubles->InsertNextValue(static_cast<double>(k * k) * 0.25 - 3);
  data->AddArray(doubles);
}

vtkSmartPointer<vtkPoints> some_points(int count) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  // Numbers that VTK's writers, which spend few digits in ASCII, write as they are.
  for (int k = 0; k < count; ++k) points->InsertNextPoint(k % 7 * 0.25, k / 7 - 1e3, 0.5);
  return points;
}

vtkSmartPointer<vtkDataSet> unstructured_grid() {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(some_points(60));
  for (int k = 0; k < 30; ++k) {
    for (const auto& [type, nodes] : {std::pair{5, 3}, {9, 4}, {7, 5}, {3, 2}, {22, 6}, {1, 1}}) {
      vtkNew<vtkIdList> ids;
      for (int i = 0; i < nodes; ++i) ids->InsertNextId((k + 7 * i) % 60);
      grid->InsertNextCell(type, ids);
    }
  }
  return grid;
}

vtkSmartPointer<vtkCellArray> cells(std::initializer_list<std::vector<vtkIdType>> all) {
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& nodes : all)
    array->InsertNextCell(static_cast<vtkIdType>(nodes.size()), nodes.data());
  return array;
}

vtkSmartPointer<vtkDataSet> surface() {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(some_points(21));
  data->SetVerts(cells({{0}, {1, 2}}));
  data->SetLines(cells({{0, 1}, {1, 2, 3}}));
  data->SetPolys(cells({{0, 1, 8}, {1, 2, 9, 8}, {2, 3, 4, 11, 10}}));
  data->SetStrips(cells({{7, 8, 14, 15, 16}}));
  return data;
}

vtkSmartPointer<vtkDataSet> image() {
  auto data = vtkSmartPointer<vtkStructuredPoints>::New();
  data->SetDimensions(7, 5, 1);
  data->SetOrigin(1, 2, 3);
  data->SetSpacing(0.5, 0.25, 1);
  return data;
}

/// In the plane x = constant, and in three dimensions.
template <int nx>
vtkSmartPointer<vtkDataSet> rectilinear_grid() {
  auto data = vtkSmartPointer<vtkRectilinearGrid>::New();
  data->SetDimensions(nx, 3, 4);
  const auto axis = [](int count) {
    auto places = vtkSmartPointer<vtkDoubleArray>::New();
    for (int k = 0; k < count; ++k) places->InsertNextValue(k * k + 0.5);
    return places;
  };
  data->SetXCoordinates(axis(nx));
  data->SetYCoordinates(axis(3));
  data->SetZCoordinates(axis(4));
  return data;
}

template <int nz>
vtkSmartPointer<vtkDataSet> structured_grid() {
  auto data = vtkSmartPointer<vtkStructuredGrid>::New();
  data->SetDimensions(4, 3, nz);
  data->SetPoints(some_points(12 * nz));
  return data;
}

/// The arrays of points, or cells, as text.
std::vector<std::string> arrays_of(vtkDataSetAttributes* data) {
  std::vector<std::string> out;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    out.push_back(fmt::format("{} {}:", data->GetArrayName(i),
                              array == nullptr ? 0 : array->GetNumberOfComponents()));
    if (array == nullptr || array->GetNumberOfComponents() != 1) continue;
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
      out.back() += fmt::format(" {}", array->GetTuple1(k));
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::string> arrays_of(const std::vector<NumberArray>& arrays) {
  std::vector<std::string> out;
  for (const NumberArray& array : arrays) {
    out.push_back(fmt::format("{} {}:", array.name, array.components));
    if (array.components != 1) continue;
    array.visit([&](auto numbers) {
      for (std::size_t k = 0; k < numbers.size(); ++k)
        out.back() += fmt::format(" {}", static_cast<double>(numbers[k]));
    });
  }
  std::sort(out.begin(), out.end());
  return out;
}

void expect_same(const std::string& path, vtkDataSet& written) {
  const Result<DataSetFile> file = read_data_set(path);
  ASSERT_TRUE(file) << file.error().message;
  const DataSet& data = file->data;
  ASSERT_EQ(data.point_count(), static_cast<std::size_t>(written.GetNumberOfPoints()));
  for (vtkIdType p = 0; p < written.GetNumberOfPoints(); ++p) {
    DataSet::Coordinates x{};
    written.GetPoint(p, x.data());
    EXPECT_EQ(data.point(static_cast<std::size_t>(p)), x);
  }
  ASSERT_EQ(data.cell_count(), static_cast<std::size_t>(written.GetNumberOfCells()));
  std::array<std::uint32_t, 8> room{};
  for (vtkIdType c = 0; c < written.GetNumberOfCells(); ++c) {
    EXPECT_EQ(data.type(static_cast<std::size_t>(c)), written.GetCellType(c));
    vtkNew<vtkIdList> ids;
    written.GetCellPoints(c, ids);
    const auto nodes = data.nodes(static_cast<std::size_t>(c), room);
    EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), ids->begin(), ids->end())) << "cell " << c;
  }
  EXPECT_TRUE(arrays_of(data.point_arrays) == arrays_of(written.GetPointData()));
  EXPECT_TRUE(arrays_of(data.cell_arrays) == arrays_of(written.GetCellData()));
}

vtkSmartPointer<vtkDataSet> with_arrays(vtkSmartPointer<vtkDataSet> data) {
  add_arrays(data->GetPointData(), data->GetNumberOfPoints());
  add_arrays(data->GetCellData(), data->GetNumberOfCells());
  return data;
}

template <class Writer>
void read_all_xml(const char* name, vtkSmartPointer<vtkDataSet> data) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / name;
  for (int way = 0; way < 4 * 4 * 2 * 2; ++way) {
    const int mode = way % 4, compression = way / 4 % 4, header = way / 16 % 2, order = way / 32;
    SCOPED_TRACE(fmt::format("mode {}, compression {}, header {}, order {}", mode, compression,
                             header, order));
    vtkNew<Writer> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    if (mode == 0) writer->SetDataModeToAscii();
    if (mode == 1) writer->SetDataModeToBinary();
    if (mode > 1) writer->SetDataModeToAppended();
    writer->SetEncodeAppendedData(mode == 2 ? 1 : 0);
    writer->SetCompressorType(compression);
    writer->SetBlockSize(800);
    header == 0 ? writer->SetHeaderTypeToUInt32() : writer->SetHeaderTypeToUInt64();
    order == 0 ? writer->SetByteOrderToLittleEndian() : writer->SetByteOrderToBigEndian();
    ASSERT_EQ(writer->Write(), 1);
    expect_same(path, *data);
  }
}

TEST(ReadDataSet, UnstructuredGridsOfVtk) {
  read_all_xml<vtkXMLUnstructuredGridWriter>("a.vtu", with_arrays(unstructured_grid()));
}
TEST(ReadDataSet, SurfacesOfVtk) {
  read_all_xml<vtkXMLPolyDataWriter>("a.vtp", with_arrays(surface()));
}
TEST(ReadDataSet, ImagesOfVtk) {
  read_all_xml<vtkXMLImageDataWriter>("a.vti", with_arrays(image()));
}

template <class Writer>
void read_all_legacy(vtkSmartPointer<vtkDataSet> data) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "a.vtk";
  for (const bool binary : {false, true}) {
    for (const int version : {42, 51}) {
      SCOPED_TRACE(fmt::format("version {}{}", version, binary ? ", binary" : ""));
      vtkNew<Writer> writer;
      writer->SetFileName(path.c_str());
      writer->SetInputData(data);
      writer->SetFileVersion(version);
      binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
      ASSERT_EQ(writer->Write(), 1);
      expect_same(path, *data);
    }
  }
}

TEST(ReadDataSet, LegacyFilesOfVtk) {
  read_all_legacy<vtkUnstructuredGridWriter>(with_arrays(unstructured_grid()));
  read_all_legacy<vtkPolyDataWriter>(with_arrays(surface()));
  read_all_legacy<vtkStructuredPointsWriter>(with_arrays(image()));
  read_all_legacy<vtkRectilinearGridWriter>(with_arrays(rectilinear_grid<1>()));
  read_all_legacy<vtkRectilinearGridWriter>(with_arrays(rectilinear_grid<3>()));
  read_all_legacy<vtkStructuredGridWriter>(with_arrays(structured_grid<1>()));
  read_all_legacy<vtkStructuredGridWriter>(with_arrays(structured_grid<2>()));
}

/// Two triangles in two pieces, of which the second has its arrays in another order, and one more.
TEST(ReadDataSet, PiecesAreJoined) {
  const auto piece = [](std::string_view arrays) {
    return fmt::format(
        "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float32\" "
        "NumberOfComponents=\"3\">0 0 0 1 0 0 0 1 0</DataArray></Points><Cells><DataArray "
        "type=\"Int32\" Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int32\" "
        "Name=\"offsets\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\">5</DataArray>"
        "</Cells><CellData>{}</CellData></Piece>",
        arrays);
  };
  const std::string text = "<VTKFile><UnstructuredGrid>" +
                           piece(
                               "<DataArray type=\"Int32\" Name=\"a\">7</DataArray>"
                               "<DataArray type=\"Int8\" Name=\"b\">1</DataArray>") +
                           "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>" +
                           piece(
                               "<DataArray type=\"Float64\" Name=\"b\">2.5</DataArray>"
                               "<DataArray type=\"Int32\" Name=\"c\">9</DataArray>"
                               "<DataArray type=\"Int32\" Name=\"a\">8</DataArray>") +
                           "</UnstructuredGrid></VTKFile>";
  const auto data = parse_data_set(text, ".vtu", "a.vtu");
  ASSERT_TRUE(data) << data.error().message;
  EXPECT_EQ(data->point_count(), 6U);
  ASSERT_EQ(data->cell_count(), 2U);
  std::array<std::uint32_t, 8> room{};
  EXPECT_EQ(data->nodes(1, room)[2], 5U);
  EXPECT_EQ(arrays_of(data->cell_arrays), (std::vector<std::string>{"a 1: 7 8", "b 1: 1 2.5"}));
}

}  // namespace
}  // namespace cover
