#include <cover/picture.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

#include "base/numbers.hpp"
#include "io/images/raster.hpp"
#include "io/text/text.hpp"
#include "picture/compose.hpp"
#include "picture/parts/palette.hpp"
#include "picture/parts/shown_values.hpp"
#include "picture/raster.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

/// Two unit squares side by side, of two materials, with a contact on the left.
PictureMesh two_squares() {
  PictureMesh mesh;
  mesh.mesh.soup.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  mesh.mesh.soup.triangles = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  mesh.mesh.soup.region = {1, 1, 2, 2};
  mesh.mesh.soup.material = {7, 7, 3, 3};
  mesh.mesh.arrays = {{"load", {0, 1, 2, 3}}};
  mesh.region_names = {{1, "core"}, {2, "a < b"}};
  mesh.material_names = {{7, "silicon"}, {3, "oxide"}};
  mesh.lines = {{"anode", true, {{0, 5}}}};
  return mesh;
}

Colour at(const Image& image, double x, double y) {
  const auto i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

TEST(Picture, SvgNamesRegionsMaterialsAndContacts) {
  const auto svg = svg_text(two_squares(), {});
  ASSERT_TRUE(svg);
  EXPECT_EQ(count(*svg, ">core (silicon)<"), 1U);
  EXPECT_EQ(count(*svg, ">a &lt; b (oxide)<"), 1U);
  EXPECT_EQ(count(*svg, ">anode<"), 1U);
  EXPECT_EQ(count(*svg, "90.0°"), 3U) << "the three largest angles are marked";
  EXPECT_TRUE(svg->starts_with("<svg "));
  EXPECT_TRUE(svg->ends_with("</svg>\n"));
}

TEST(Picture, EdgesOfSecondOrderAreDrawnAsTheyCurve) {
  PictureMesh mesh = two_squares();
  PictureOptions options;
  options.worst = 0;
  const std::string straight = *svg_text(mesh, options);
  for (const auto& [a, b, c] : mesh.mesh.soup.triangles) {
    const auto middle = [&](std::uint32_t p, std::uint32_t q) {
      const Point u = mesh.mesh.soup.points[p], v = mesh.mesh.soup.points[q];
      return Point{(u.x + v.x) / 2, (u.y + v.y) / 2};
    };
    mesh.mesh.middles.push_back({middle(a, b), middle(b, c), middle(c, a)});
  }
  EXPECT_EQ(*svg_text(mesh, options), straight);
  mesh.mesh.middles[0][0].y -= 0.25;  // of the edge below the first square, on the outline
  const std::string curved = *svg_text(mesh, options);
  EXPECT_EQ(count(curved, "M"), count(straight, "M") + 7 + 63);  // of the line, of the triangle
}

TEST(Picture, VerticesWithPartnersHaveRings) {
  PictureMesh mesh = two_squares();
  const std::size_t before = count(*svg_text(mesh, {}), "<circle");
  mesh.periodic = {{0, 2, 5, 3}, {0, 5}};
  EXPECT_EQ(count(*svg_text(mesh, {}), "<circle"), before + 6);
  PictureOptions part;
  part.worst = 0;
  part.window = Window{{-0.5, -0.5}, {0.5, 0.5}};
  EXPECT_EQ(count(*svg_text(mesh, part), "<circle"), 2U);  // those of one vertex
}

TEST(Picture, PixelsHaveTheColourOfTheirRegion) {
  PictureOptions options;
  options.edges = false;
  options.worst = 0;
  const auto drawing = compose(two_squares(), options);
  ASSERT_TRUE(drawing);
  const Image image = paint(*drawing);
  const PixelBox& plot = drawing->plot;
  const double y = (plot.y0 + plot.y1) / 2, w = plot.x1 - plot.x0;
  // Materials get colours in the order of their numbers: oxide (3) first.
  EXPECT_EQ(at(image, plot.x0 + 0.3 * w, y), material_colour(1));
  EXPECT_EQ(at(image, plot.x0 + 0.7 * w, y), material_colour(0));
  EXPECT_LT(at(image, plot.x0 + 0.5 * w, y).r, 100) << "the interface is strong";
}

TEST(Picture, NoSeamBetweenTrianglesOfOneColour) {
  Drawing drawing{40, 40, {0, 0, 40, 40}, {}};
  const Point o{3.3, 4.1}, p{37.2, 6.6}, q{33.3, 36.9}, r{5.2, 31.4}, c{20.11, 19.77};
  const Colour red{200, 10, 10};
  drawing.items.emplace_back(PaintedPatch{red, true, {{o, p, c}, {p, q, c}, {q, r, c}, {r, o, c}}});
  const Image image = paint(drawing);
  for (int y = 10; y < 30; ++y) {
    for (int x = 10; x < 30; ++x) ASSERT_EQ(at(image, x, y), red) << x << ' ' << y;
  }
}

TEST(Picture, ClippedItemsStayInThePlot) {
  Drawing drawing{30, 30, {10, 10, 20, 20}, {}};
  const std::array<Point, 3> all{Point{-100, -100}, Point{200, -100}, Point{0, 300}};
  drawing.items.emplace_back(PaintedPatch{{0, 0, 0}, true, {all}});
  const Image image = paint(drawing);
  EXPECT_EQ(at(image, 15, 15), (Colour{0, 0, 0}));
  EXPECT_EQ(at(image, 9, 15), (Colour{255, 255, 255}));
  EXPECT_EQ(at(image, 15, 20), (Colour{255, 255, 255}));
}

TEST(Picture, ValuesGetALegendFromLowToHigh) {
  PictureOptions options;
  options.color = "load";
  const auto svg = svg_text(two_squares(), options);
  ASSERT_TRUE(svg);
  for (const char* tick : {">0<", ">1<", ">1.5<", ">2<", ">2.5<", ">3<", ">load<"}) {
    EXPECT_EQ(count(*svg, tick), 1U) << tick;
  }
}

TEST(Picture, ColoursShowTheRangeAskedFor) {
  PictureOptions options;
  options.color = "load";
  options.range = {-4, 1};
  const auto svg = svg_text(two_squares(), options);
  ASSERT_TRUE(svg);
  for (const char* tick : {">-4<", ">-3<", ">-2<", ">-1<", ">0<", ">1<"}) {
    EXPECT_EQ(count(*svg, tick), 1U) << tick;
  }
  options.range = {1, -4};
  EXPECT_FALSE(svg_text(two_squares(), options));
}

TEST(Picture, ValuesAtPointsAreThoseOfTheRegion) {
  PictureMesh mesh = two_squares();
  mesh.mesh.arrays.clear();
  mesh.mesh.point_arrays = {{"other", {1, 2, 3, 4, 5, 6}}, {"doping", {9, 9, 0, 0, 9, 9}}};
  mesh.region_values = {{}, {{1, RegionId(2), 0}, {4, RegionId(2), 0}}};
  PictureOptions options;
  options.color = "doping";
  options.edges = false;
  options.worst = 0;
  const Result<Drawing> drawing = compose(mesh, options);
  ASSERT_TRUE(drawing) << drawing.error().message;
  const Image image = paint(*drawing);
  const PixelBox& plot = drawing->plot;
  const double middle = (plot.y0 + plot.y1) / 2;
  for (const double part : {0.1, 0.4, 0.6, 0.9}) {
    EXPECT_EQ(at(image, plot.x0 + part * (plot.x1 - plot.x0), middle - 7),
              value_colour(part < 0.5 ? 1 : 0));
  }
}

TEST(Picture, ExpressionsOfArraysAreShown) {
  PictureMesh mesh = two_squares();
  mesh.mesh.point_arrays = {{"doping", {9, 9, 0, 0, 9, 9}}};
  mesh.region_values = {{{1, RegionId(2), 0}, {4, RegionId(2), 0}}};
  PictureOptions options;
  const auto values = [&](const char* text) { return shown_values(mesh, text).value(); };
  EXPECT_EQ(values("-doping/3 + load"), (std::vector<double>{-3, -2, 2, 3}));
  EXPECT_EQ(values("doping - RegionId"), (std::vector<double>{8, 8, -2, -2}));
  EXPECT_EQ(values("x*0 + material"), (std::vector<double>{7, 7, 3, 3}));
  EXPECT_EQ(values("load"), (std::vector<double>{0, 1, 2, 3}));
  options.color = "abs(doping)";
  EXPECT_EQ(count(svg_text(mesh, options).value(), ">abs(doping)<"), 1U);
  options.color = "abs(dopin)";
  const std::string unknown = svg_text(mesh, options).error().message;
  EXPECT_TRUE(unknown.starts_with("the mesh has no array 'abs(dopin)'; it has load, "));
  EXPECT_NE(unknown.find("; as an expression: "), std::string::npos);
  mesh.mesh.point_arrays[0].values.pop_back();
  options.color = "abs(doping)";
  EXPECT_EQ(svg_text(mesh, options).error().code, ErrorCode::id_out_of_range);
}

TEST(Picture, ManyRegionsAreListedByMaterial) {
  PictureMesh mesh = two_squares();
  mesh.mesh.soup = {};
  mesh.region_names.clear();
  for (std::uint32_t i = 0; i < 300; ++i) {
    const double x = i;
    mesh.mesh.soup.points.insert(mesh.mesh.soup.points.end(), {{x, 0}, {x + 1, 0}, {x, 90}});
    mesh.mesh.soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    mesh.mesh.soup.region.push_back(i + 1);
    mesh.mesh.soup.material.push_back(i % 2 == 0 ? 7 : 3);
  }
  const auto svg = svg_text(mesh, {});
  ASSERT_TRUE(svg);
  EXPECT_EQ(count(*svg, ">silicon, 150 regions<"), 1U);
  EXPECT_EQ(count(*svg, ">oxide, 150 regions<"), 1U);
}

TEST(Picture, AnglesAreFoundWhereTheFileHasNone) {
  PictureMesh mesh = two_squares();
  mesh.mesh.soup.points[5] = {0, 0.5};
  PictureMesh with_array = mesh;
  with_array.mesh.arrays = {{"max_angle", {90, 0, 90, 90}}};
  with_array.mesh.arrays[0].values[1] = 180 - 2 * Angle::radians(std::atan(0.5)).in_degrees();
  PictureOptions options;
  options.color = "max_angle";
  EXPECT_NE(*svg_text(mesh, options), *svg_text(with_array, options)) << "an array comes first";
  with_array.mesh.arrays[0].values[1] = 90 + Angle::radians(std::atan(0.5)).in_degrees();
  EXPECT_EQ(*svg_text(mesh, options), *svg_text(with_array, options));
  options.color = "min_angle";
  EXPECT_TRUE(svg_text(mesh, options));
}

TEST(Picture, MistakesAreExplained) {
  PictureOptions options;
  options.color = "stress";
  auto svg = svg_text(two_squares(), options);
  ASSERT_FALSE(svg);
  EXPECT_EQ(svg.error().code, ErrorCode::bad_option);
  EXPECT_EQ(svg.error().message,
            "the mesh has no array 'stress'; it has load, RegionId, material, max_angle, "
            "min_angle");
  options = {};
  options.window = {{1, 1}, {1, 2}};
  svg = svg_text(two_squares(), options);
  ASSERT_FALSE(svg);
  EXPECT_EQ(svg.error().code, ErrorCode::bad_option);
}

TEST(Picture, ANarrowOneIsAllPlot) {
  const testing::TemporaryFolder folder;
  for (const int width : {200, 257, 258, 259, 399, 400}) {
    PictureOptions options;
    options.width = width;
    for (const char* color : {"", "max_angle"}) {
      options.color = color;
      const auto drawing = compose(two_squares(), options);
      if (!drawing) continue;  // no such array
      EXPECT_GT(drawing->plot.x1 - drawing->plot.x0, 100) << width;
      EXPECT_GT(drawing->plot.y1 - drawing->plot.y0, 100) << width;
      EXPECT_LT(drawing->plot.x1, width);
      EXPECT_TRUE(write_png(two_squares(), options, folder.path() / "narrow.png")) << width;
    }
  }
}

TEST(Picture, PngTellsLettersApartThatItsFontLacks) {
  const testing::TemporaryFolder folder;
  const auto bytes_with = [&](const char* name) {
    PictureMesh mesh = two_squares();
    mesh.region_names[1] = name;
    const std::string path = folder.path() / "letters.png";
    EXPECT_TRUE(write_png(mesh, {}, path));
    std::ifstream file(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  EXPECT_NE(bytes_with("\u03b1"), bytes_with("\u03b2"));
  EXPECT_EQ(bytes_with("\u03b1"), bytes_with("<U+03B1>"));
  EXPECT_NE(bytes_with("\u00f6"), bytes_with("<U+00F6>"));  // which it has
}

TEST(Picture, PngCutsNamesThatLeaveIt) {
  const testing::TemporaryFolder folder;
  PictureMesh mesh = two_squares();
  mesh.region_names[1].clear();
  for (int k = 0; k < 12; ++k) mesh.region_names[1] += "\u2083";  // each as wide as six letters
  const std::string path = folder.path() / "long.png";
  ASSERT_TRUE(write_png(mesh, {}, path));
  const auto text = read_file(path);
  ASSERT_TRUE(text);
  const auto picture = decode_png(*text, path);
  ASSERT_TRUE(picture) << picture.error().message;
  for (std::size_t y = 0; y < picture->height; ++y)
    EXPECT_EQ(picture->pixels[(y + 1) * picture->width - 1], picture->pixels[0]) << y;
}

TEST(Picture, PngHasTheSizeOfTheDrawing) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path() / "picture.png";
  PictureOptions options;
  options.width = 640;
  const auto drawing = compose(two_squares(), options);
  ASSERT_TRUE(drawing);
  ASSERT_TRUE(write_png(two_squares(), options, path));
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  ASSERT_GT(bytes.size(), 24U);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  const auto number = [&](std::size_t i) {  // big-endian, in the header chunk
    int value = 0;
    for (std::size_t k = i; k < i + 4; ++k)
      value = 256 * value + static_cast<unsigned char>(bytes[k]);
    return value;
  };
  EXPECT_EQ(number(16), 640);
  EXPECT_EQ(number(20), drawing->height);
}

TEST(Picture, RefusesWhatIsNotThere) {
  const auto refusal = [](auto change) {
    PictureMesh mesh = two_squares();
    PictureOptions options;
    change(mesh, options);
    const auto svg = svg_text(mesh, options);
    return svg ? std::string() : svg.error().message;
  };
  using Mesh = PictureMesh;
  using Opt = PictureOptions;
  EXPECT_EQ(refusal([](Mesh& m, Opt&) { m.mesh.soup.triangles[1][2] = 6; }),
            "triangle 1 has a point that is not there");
  EXPECT_EQ(refusal([](Mesh& m, Opt&) { m.lines[0].edges[0][1] = 99; }),
            "the line 'anode' has a point that is not there");
  EXPECT_EQ(refusal([](Mesh& m, Opt&) {
              m.periodic = {{0, 6}};
            }),
            "a vertex on a periodic side is not there");
  EXPECT_EQ(refusal([](Mesh& m, Opt& o) {
              m.mesh.arrays[0].values.pop_back();
              o.color = "load";
            }),
            "the array 'load' has 3 values for 4 triangles");
  EXPECT_EQ(refusal([](Mesh& m, Opt& o) {
              m.mesh.point_arrays = {{"doping", {1, 2}}};
              o.color = "doping";
            }),
            "the array 'doping' has 2 values for 6 points");
  EXPECT_NE(refusal([](Mesh& m, Opt&) { m.mesh.soup.region.pop_back(); }), "");
  EXPECT_NE(refusal([](Mesh& m, Opt&) { m.mesh.soup.material.pop_back(); }), "");
  EXPECT_NE(refusal([](Mesh& m, Opt&) { m.mesh.middles.resize(1); }), "");
  EXPECT_EQ(refusal([](Mesh&, Opt& o) { o.color = "load"; }), "");
}

TEST(Picture, IdsAreNamesInXml) {
  for (const char* id : {"", "1", "a b", "a\"><script>", "a)", "-a"}) {
    PictureOptions options;
    options.id = id;
    const auto svg = svg_text(two_squares(), options);
    ASSERT_FALSE(svg) << id;
    EXPECT_EQ(svg.error().code, ErrorCode::bad_option);
  }
  for (const char* id : {"plot", "close-up-3", "_a.b:c", "gr\u00f6\u00dfe"}) {
    PictureOptions options;
    options.id = id;
    EXPECT_TRUE(svg_text(two_squares(), options)) << id;
  }
}

TEST(Picture, RefusesWhatHasNoPlaceInThePlane) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {kNaN, HUGE_VAL, -HUGE_VAL}) {
    PictureMesh mesh = two_squares();
    mesh.mesh.soup.points[4].y = wrong;
    Result<std::string> svg = svg_text(mesh, {});
    ASSERT_FALSE(svg);
    EXPECT_EQ(svg.error().code, ErrorCode::non_finite_coordinate);
    EXPECT_EQ(svg.error().message, "point 4 is not finite");
    mesh = two_squares();
    mesh.mesh.middles.assign(4, {Point{0, 0}, {0, 0}, {0, 0}});
    mesh.mesh.middles[2][1].x = wrong;
    svg = svg_text(mesh, {});
    ASSERT_FALSE(svg);
    EXPECT_EQ(svg.error().message, "a node of triangle 2 is not finite");
    PictureOptions options;
    options.color = "load";
    options.range = {{0, wrong}};
    EXPECT_FALSE(svg_text(two_squares(), options));
    options = {};
    options.window = {{0, 0}, {1, wrong}};
    EXPECT_FALSE(svg_text(two_squares(), options));
  }
  PictureMesh wide = two_squares();
  wide.mesh.soup.points[0] = {-1.5e308, 0};
  wide.mesh.soup.points[3] = {1.5e308, 1};
  EXPECT_FALSE(svg_text(wide, {}));
}

TEST(Picture, ValuesMayBeMissingOrFarApart) {
  PictureMesh mesh = two_squares();
  mesh.mesh.arrays[0].values = {-1.7e308, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL,
                                1.7e308};
  PictureOptions options;
  options.color = "load";
  options.worst = 0;
  const Result<std::string> svg = svg_text(mesh, options);
  ASSERT_TRUE(svg) << svg.error().message;
  EXPECT_EQ(count(*svg, "nan") + count(*svg, "inf"), 0U);
}

TEST(Picture, WhatHasNoValueIsGrey) {
  PictureMesh mesh = two_squares();
  PictureOptions options;
  options.color = "load";
  options.edges = false;
  options.worst = 0;
  const Result<std::string> whole = svg_text(mesh, options);
  ASSERT_TRUE(whole);
  EXPECT_EQ(count(*whole, "no value"), 0U);
  mesh.mesh.arrays[0].values = {kNoNumber, kNoNumber, 2, 3};
  for (const bool has_range : {false, true}) {
    if (has_range) options.range = {2, 3};
    const Result<std::string> svg = svg_text(mesh, options);
    ASSERT_TRUE(svg) << svg.error().message;
    EXPECT_EQ(count(*svg, ">no value<"), 1U);
    const Result<Drawing> drawing = compose(mesh, options);
    ASSERT_TRUE(drawing);
    const Image image = paint(*drawing);
    const PixelBox& plot = drawing->plot;
    const double middle = (plot.y0 + plot.y1) / 2;
    EXPECT_EQ(at(image, plot.x0 + 0.25 * (plot.x1 - plot.x0), middle - 7), kNoValueColour);
    EXPECT_NE(at(image, plot.x0 + 0.75 * (plot.x1 - plot.x0), middle - 7), kNoValueColour);
  }
}

}  // namespace
}  // namespace cover
