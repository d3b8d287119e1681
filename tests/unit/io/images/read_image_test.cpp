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
  EXPECT_EQ(
      input->warnings,
      std::vector<std::string>{"2 regions of fewer than 4 pixels: is the picture a photograph, or "
                               "were its edges softened?"});
  ImageOptions options;
  options.smooth = false;
  const Result<Input> stairs = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(stairs);
  EXPECT_EQ(stairs->polygons[0].rings[0], (std::vector<Point>{{0, 0}, {1, 0}, {1, 4}, {0, 4}}));
}

TEST(ReadImage, LegendsNameThem) {
  ImageOptions options;
  options.legend = "1,copper\r\n7,iron, cast\n\n0,void\n99,unused";
  options.legend_source = "l.csv";
  const Result<Input> input = parse_image(kPicture, ".nrrd", "a.nrrd", options);
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(materials_of(*input), (std::set<std::string>{"copper", "iron, cast"}));
  options.legend = "1,copper\n1,tin";
  EXPECT_EQ(parse_image(kPicture, ".nrrd", "a", options).error().message,
            "l.csv:2: the label '1' stands there a second time");
  options.legend = "copper";
  EXPECT_EQ(parse_image(kPicture, ".nrrd", "a", options).error().message,
            "l.csv:1: expected a label and a name, as #ff0000,copper or 7,grain");
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
