#include "io/images/read_image.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include <cover/read_input.hpp>

namespace cover {
namespace {

const std::string kPicture =
    "NRRD0004\ntype: uchar\nsizes: 4 2\nspacings: 0.5 2\nencoding: ascii\n\n1 1 7 7\n1 1 7 0\n";

std::set<std::string> materials_of(const Input& input) {
  std::set<std::string> out;
  for (const InputPolygon& polygon : input.polygons) out.insert(polygon.material);
  return out;
}

TEST(ReadImage, LabelsAreMaterials) {
  const Result<Input> input = parse_input(kPicture, ".nrrd", "a.nrrd");
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(materials_of(*input), (std::set<std::string>{"0", "1", "7"}));
  EXPECT_EQ(input->warnings,
            std::vector<std::string>{
                "2 regions of fewer than 4 pixels: is the picture a photograph, or were its edges "
                "softened? --speckle N makes those of fewer than N part of what is around"});
  ImageOptions options;
  options.smooth = false;
  const Result<Input> stairs = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(stairs);
  EXPECT_EQ(stairs->polygons[0].rings[0], (std::vector<Point>{{0, 0}, {1, 0}, {1, 4}, {0, 4}}));
}

/// A disk of label -1 in label 7.
std::string disk() {
  std::string out;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) out += (x - 11) * (x - 11) + (y - 9) * (y - 9) < 64 ? "-1 " : "7 ";
    out += '\n';
  }
  return out;
}

std::vector<std::vector<std::vector<Point>>> rings_of(const Input& input) {
  std::vector<std::vector<std::vector<Point>>> rings;
  for (const InputPolygon& polygon : input.polygons) rings.push_back(polygon.rings);
  return rings;
}

TEST(ReadImage, ImagesOfVtkAreTheSame) {
  const auto read = [](const std::string& text, const char* extension,
                       const ReadOptions& options = {}) {
    const Result<Input> input = parse_input(text, extension, "a", options);
    EXPECT_TRUE(input) << input.error().message;
    return input ? *input : Input();
  };
  const Input picture = read(
      "NRRD0004\ntype: short\nsizes: 24 24\nspacings: 0.5 0.25\nencoding: "
      "ascii\n\n" +
          disk(),
      ".nrrd");
  EXPECT_EQ(materials_of(picture), (std::set<std::string>{"-1", "7"}));
  const std::string vti =
      R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 24 0 24 0 0" Origin="0 0 0" Spacing="0.5 0.25 1">
<Piece Extent="0 24 0 24 0 0"><CellData><DataArray type="Int32" Name="material" format="ascii">)" +
      disk() + "</DataArray></CellData></Piece></ImageData></VTKFile>";
  const std::string vtk =
      "# vtk DataFile Version 3.0\nlabels\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 25 25 1\n"
      "ORIGIN 0 0 0\nSPACING 0.5 0.25 1\nCELL_DATA 576\nSCALARS phase int 1\n"
      "LOOKUP_TABLE default\n" +
      disk();
  for (const auto& [text, extension] : {std::pair(vti, ".vti"), std::pair(vtk, ".vtk")}) {
    SCOPED_TRACE(extension);
    const Input smooth = read(text, extension);
    EXPECT_EQ(materials_of(smooth), materials_of(picture));
    EXPECT_EQ(rings_of(smooth), rings_of(picture));
    ReadOptions options;
    options.smooth = false;
    // As of any mesh: segments on the sides of the cells.
    const Input stairs = read(text, extension, options);
    EXPECT_TRUE(stairs.polygons.empty());
    for (const InputSegment& s : stairs.segments) {
      const Point a = stairs.points[s.a], b = stairs.points[s.b];
      EXPECT_TRUE(a.x == b.x || a.y == b.y);
    }
  }
}

TEST(ReadImage, PointsOfAnImageOfVtkArePixelsWhereTheyHaveTheLabels) {
  const Result<Input> picture = parse_input(
      "NRRD0004\ntype: short\nsizes: 24 24\nspacings: 0.5 0.25\nencoding: ascii\n\n" + disk(),
      ".nrrd", "a");
  const std::string vti =
      R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 23 0 23 0 0" Origin="0.25 0.125 0" Spacing="0.5 0.25 1">
<Piece Extent="0 23 0 23 0 0"><PointData><DataArray type="UInt8" Name="label" format="ascii">)" +
      disk() + "</DataArray></PointData></Piece></ImageData></VTKFile>";
  const std::string signed_vti = std::string(vti).replace(vti.find("UInt8"), 5, "Int16");
  const Result<Input> points = parse_input(signed_vti, ".vti", "a");
  ASSERT_TRUE(picture && points) << points.error().message;
  EXPECT_EQ(materials_of(*points), materials_of(*picture));
  EXPECT_EQ(rings_of(*points), rings_of(*picture));
}

TEST(ReadImage, LegendsNameThem) {
  ImageOptions options;
  options.legend = "1,copper\r\n7,iron, cast\n\n0,void\n99,unused";
  options.legend_source = "l.csv";
  const Result<Input> input = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(materials_of(*input), (std::set<std::string>{"copper", "iron, cast"}));
  EXPECT_EQ(input->warnings.back(),
            "1 label of the legend is of no pixel: '99'; the picture has '0', '1', '7'");
  options.legend =
      "\xef\xbb\xbf"
      "1,copper\n# by hand\n#\n7,iron\n";
  const Result<Input> marked = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(marked) << marked.error().message;
  EXPECT_EQ(materials_of(*marked), (std::set<std::string>{"0", "copper", "iron"}));
  options.legend = "1,copper\n1,tin";
  EXPECT_EQ(parse_image(kPicture, ".nrrd", "a", options).error().message,
            "l.csv:2: the label '1' stands there a second time");
  options.legend = "copper";
  EXPECT_EQ(parse_image(kPicture, ".nrrd", "a", options).error().message,
            "l.csv:1: expected a label and a name, as #ff0000,copper or 7,grain");
}

TEST(ReadImage, APictureOfNothingIsTold) {
  ImageOptions options;
  options.legend = "0,void\n1,void\n7,void";
  const Result<Input> input = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_TRUE(input->polygons.empty());
  ASSERT_FALSE(input->warnings.empty());
  EXPECT_EQ(input->warnings[0], "all pixels are transparent, or void by the legend");
}

TEST(ReadImage, SpecklesAreToldOf) {
  ImageOptions options;
  options.speckle = 4;
  const Result<Input> input = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(input->warnings, std::vector<std::string>{
                                 "2 sets of fewer than 4 pixels became part of what is around"});
  EXPECT_EQ(materials_of(*input).size(), 1U);
}

TEST(ReadImage, TifHasTwoMeanings) {
  EXPECT_EQ(parse_input("h TIF V1.2.1\n", ".tif", "a.tif").error().message,
            "a.tif: no triangles in it");
  EXPECT_EQ(parse_input(std::string("II*\0\x08\0\0\0\0\0", 10), ".tif", "a.tif").error().message,
            "a.tif: the picture has no pixels");
  EXPECT_EQ(parse_input("h TIF V1.2.1\n", ".tiff", "a.tiff").error().message,
            "a.tiff: this is no TIFF");
}

}  // namespace
}  // namespace cover
