#include <cover/read_input.hpp>
#include <cover/read_vtk_input.hpp>

#include <gtest/gtest.h>

#include <ostream>

#include "support/temporary_folder.hpp"

namespace cover {
namespace {

using testing::TemporaryFolder;

// Two unit squares beside each other, as two triangles and a quadrangle, and a line below.
constexpr std::string_view kLegacy = R"(# vtk DataFile Version 3.0
two squares
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 double
0 0 0  1 0 0  2 0 0  0 1 0  1 1 0  2 1 0
CELLS 4 16
3 0 1 4
3 0 4 3
4 1 2 5 4
2 0 1
CELL_TYPES 4
5 5 9 3
CELL_DATA 4
SCALARS MaterialID int 1
LOOKUP_TABLE default
3 3 7 -1
SCALARS LineID int 1
LOOKUP_TABLE default
0 0 0 12
)";

constexpr std::string_view kPolyData = R"(<VTKFile type="PolyData" version="1.0">
<PolyData><Piece NumberOfPoints="6" NumberOfPolys="2">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0  1 0 0  2 0 0  0 1 0  1 1 0  2 1 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 4 3 1 2 5 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray></Polys>
<CellData><DataArray type="Int32" Name="phase" format="ascii">3 7</DataArray>
<DataArray type="Float64" Name="stress" format="ascii">0.5 1.5</DataArray></CellData>
</Piece></PolyData></VTKFile>
)";

constexpr std::string_view kGrid = R"(<VTKFile type="UnstructuredGrid" version="1.0">
<UnstructuredGrid><Piece NumberOfPoints="6" NumberOfCells="2">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 5  1 0 5  2 0 5  0 1 5  1 1 5  2 1 5</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 3 4 1 2 5 4</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">8 9</DataArray></Cells>
<CellData><DataArray type="Int32" Name="RegionId" format="ascii">1 2</DataArray>
<DataArray type="Int32" Name="material" format="ascii">3 7</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>
)";

struct Sample {
  const char* name;
  std::string_view text;
};
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

class ReadVtkInput : public ::testing::TestWithParam<Sample> {};

TEST_P(ReadVtkInput, FindsTheBorderBetweenMaterials) {
  const TemporaryFolder folder;
  const Result<Input> input = read_vtk_input(folder.write(GetParam().name, GetParam().text));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->points.size(), 6u);
  EXPECT_EQ(input->segments.size(), 7u);
  ASSERT_EQ(input->seeds.size(), 2u);
  EXPECT_EQ(input->seeds[0].material, "3");
  EXPECT_EQ(input->seeds[1].material, "7");
  EXPECT_EQ(input->void_rule, VoidRule::unseeded_faces);
}

INSTANTIATE_TEST_SUITE_P(Formats, ReadVtkInput,
                         ::testing::Values(Sample{"a.vtk", kLegacy}, Sample{"a.vtp", kPolyData},
                                           Sample{"a.vtu", kGrid}));

TEST(ReadVtkInputLines, KeepTheirNumber) {
  const TemporaryFolder folder;
  const Result<Input> input = read_vtk_input(folder.write("a.vtk", kLegacy));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  int named = 0;
  for (const InputSegment& s : input->segments) named += s.name == "12" && s.marker == 12;
  EXPECT_EQ(named, 1);
}

std::string vtk_message(const std::string& name, std::string_view text) {
  const TemporaryFolder folder;
  const Result<Input> input = read_vtk_input(folder.write(name, text));
  EXPECT_FALSE(input.has_value());
  return input ? "" : input.error().message.substr(folder.path().string().size() + 1);
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const auto at = result.find(from);
  EXPECT_NE(at, std::string::npos);
  return result.replace(at, from.size(), to);
}

constexpr std::string_view kCurved = R"(# vtk DataFile Version 3.0
a triangle and a line of second order
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 double
0 0 0  1 0 0  0 1 0  0.5 -0.1 0  0.5 0.5 0  0 0.5 0
CELLS 2 11
6 0 1 2 3 4 5
3 0 1 3
CELL_TYPES 2
22 21
CELL_DATA 2
SCALARS MaterialID int 1
LOOKUP_TABLE default
3 -1
)";

TEST(ReadVtkInputCells, OfSecondOrderAreToldOf) {
  const TemporaryFolder folder;
  const Result<Input> input = read_vtk_input(folder.write("a.vtk", kCurved));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->warnings,
            (std::vector<std::string>{"2 elements of higher order: their corners are taken, their "
                                      "other nodes left out"}));
}

TEST(ReadVtkInputPoints, ThatAreImagesAreToldOf) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : {std::pair{"a.vtk", kLegacy}, std::pair{"b.vtk", kCurved}})
    EXPECT_EQ(read_vtk_input(folder.write(name, text))->warnings.size(), text == kCurved) << name;
  const Result<Input> input = read_vtk_input(folder.write(
      "c.vtk", std::string(kLegacy) + "POINT_DATA 6\nSCALARS PeriodicNode int 1\nLOOKUP_TABLE "
                                      "default\n0 1 0 3 4 3\n"));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->warnings,
            (std::vector<std::string>{"which lines are images of each other (PeriodicNode) is not "
                                      "taken over: --periodic A=B says it, with names of lines"}));
}

TEST(ReadVtkInputArrays, AreKnownInWhateverCase) {
  const TemporaryFolder folder;
  for (const char* name : {"MATERIAL", "MaterialIds", "Attribute"}) {
    const std::string named = std::string("\"") + name + "\"";
    const Result<Input> input = read_vtk_input(
        folder.write("a.vtu", replaced(replaced(kGrid, "RegionId", "id"), "\"material\"", named)));
    ASSERT_TRUE(input.has_value()) << input.error().message;
    EXPECT_EQ(input->seeds[1].material, "7") << name;
  }
}

TEST(ReadVtkInputFiles, HaveExtensionsInWhateverCase) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_vtk_input(folder.write("A.VTU", kGrid)));
  EXPECT_TRUE(read_vtk_input(folder.write("A.Vtk", kLegacy)));
  const auto parsed = parse_input(kPolyData, ".VTP", "standard input");
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->segments.size(), 7U);
}

TEST(ReadVtkInputFiles, ThatAreCutOffSaySo) {
  for (std::size_t size = 0; size + 1 < kGrid.size(); size += 7) {
    const auto input = parse_input(kGrid.substr(0, size), ".vtu", "a.vtu");
    ASSERT_FALSE(input);
    EXPECT_EQ(input.error().code, ErrorCode::truncated) << input.error().message;
  }
}

TEST(ReadVtkInputErrors, NameTheFile) {
  const std::string no_integers =
      replaced(replaced(kPolyData, "Int32", "Float64"), "3 7<", "3.5 7<");
  EXPECT_EQ(vtk_message("a.vtp", no_integers),
            "a.vtp: no cell array of whole numbers called material (or MaterialID, mat_id, ...); "
            "the cell arrays are phase (no whole numbers), stress (no whole numbers)");
  const std::string two =
      replaced(replaced(kGrid, "RegionId", "colour"), "\"material\"", "\"kind\"");
  EXPECT_EQ(vtk_message("a.vtu", two),
            "a.vtu: no cell array of whole numbers called material (or MaterialID, mat_id, ...); "
            "the cell arrays are colour, kind");
  EXPECT_EQ(vtk_message("a.vtu", "no XML"), "a.vtu:1: no valid XML: syntax error");
  EXPECT_EQ(vtk_message("a.vtk", "no VTK"),
            "a.vtk:1: no file of VTK: it does not begin with '# vtk DataFile Version'");
  EXPECT_EQ(vtk_message("a.vtu", replaced(kGrid, "2 1 5<", "2 1 6<")),
            "a.vtu: the mesh is not in a plane z = constant: point 0 has z = 5, point 5 6");
  EXPECT_EQ(vtk_message("a.vtu", replaced(kGrid, "8 9<", "8 10<")),
            "a.vtu: cell 1 is of VTK's type 10; plane meshes of triangles, quadrangles and "
            "polygons are read");
  EXPECT_FALSE(read_vtk_input("nowhere.vtu").has_value());
  EXPECT_FALSE(read_vtk_input("a.stl").has_value());
}

}  // namespace
}  // namespace cover
