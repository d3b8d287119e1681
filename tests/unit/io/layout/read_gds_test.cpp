#include "io/layout/read_gds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include <cover/read_input.hpp>

#include "support/inputs/gds_writer.hpp"
#include "support/inputs/soups.hpp"
#include "support/read_result.hpp"

namespace cover {
namespace {

using testing::GdsWriter;
using Points = std::vector<Point>;

Input read(const std::string& bytes, const ReadOptions& options = {}) {
  return testing::must_read(parse_gds(bytes, "a.gds", options));
}

std::string message(const std::string& bytes, const ReadOptions& options = {}) {
  return testing::must_refuse(parse_gds(bytes, "a.gds", options));
}

double area_of(const Input& input, const std::string& material) {
  const auto out = testing::clean(input);
  EXPECT_TRUE(out) << out.error().message;
  return out ? out->area(material) : -1;
}

TEST(ReadGds, CoordinatesAreTheDoublesThatPeopleWrite) {
  const Input input = read(GdsWriter()
                               .begin("top")
                               .polygon(68, 20, {{100, 0}, {333, 7}, {-1, 2000000001}})
                               .end()
                               .finish());
  EXPECT_EQ(input.unit, "um");
  ASSERT_EQ(input.polygons.size(), 1U);
  EXPECT_EQ(input.polygons[0].material, "L68D20");
  EXPECT_EQ(input.polygons[0].region, "L68D20");
  EXPECT_EQ(input.polygons[0].rings[0], (Points{{0.1, 0}, {0.333, 0.007}, {-0.001, 2000000.001}}));
  EXPECT_EQ(read(GdsWriter(0.25, 1e-9).begin("a").box(1, 0, 0, 0, 3, 3).end().finish())
                .polygons[0]
                .rings[0][2],
            (Point{0.75, 0.75}));
  EXPECT_EQ(read(GdsWriter(1, 1e-9).begin("a").box(1, 0, 0, 0, 3, 3).end().finish()).unit, "nm");
}

TEST(ReadGds, ShapesOfOneLayerUniteAndHigherOnesLieOnTop) {
  GdsWriter file;
  file.begin("top")
      .box(2, 0, 4000, 0, 6000, 2000)
      .box(1, 0, 0, 0, 5000, 2000)
      .box(1, 0, 3000, 0, 8000, 2000);
  const auto out = testing::clean(read(file.end().finish()));
  ASSERT_TRUE(out) << out.error().message;
  EXPECT_DOUBLE_EQ(out->area("L2D0"), 4);
  EXPECT_DOUBLE_EQ(out->area("L1D0"), 12);
  EXPECT_EQ(out->table.regions.size(), 3U);  // the strip of layer 1 is cut in two
}

TEST(ReadGds, TheLayerMapNamesAndOrdersAndTellsWhatIsMissing) {
  GdsWriter file;
  file.begin("top").box(2, 0, 0, 0, 1000, 1000).box(1, 0, 0, 0, 5000, 2000).box(9, 9, 0, 0, 1, 1);
  ReadOptions options;
  options.layer_map = {"2=fin", "1=oxide"};
  const Input input = read(file.end().finish(), options);
  EXPECT_EQ(input.polygons.size(), 2U);
  EXPECT_DOUBLE_EQ(area_of(input, "oxide"), 10);  // which lies on top now
  ASSERT_EQ(input.warnings.size(), 1U);
  EXPECT_EQ(input.warnings[0], "layers that the layer map does not have are left out: 9/9");
  options.layers = {"fin", "fins"};
  const Input chosen = read(file.bytes(), options);
  EXPECT_EQ(chosen.polygons.size(), 1U);
  EXPECT_EQ(chosen.warnings, (std::vector<std::string>{
                                 "no shape is on the layer 'fins'",
                                 "layers that the layer map does not have are left out: 9/9"}));
}

TEST(ReadGds, CellsAreTurnedMirroredMagnifiedAndNested) {
  // An L without symmetry, so that each placement differs.
  GdsWriter file;
  file.begin("part")
      .polygon(1, 0, {{0, 0}, {3000, 0}, {3000, 1000}, {1000, 1000}, {1000, 2000}, {0, 2000}})
      .end();
  file.begin("top").reference("part", 10000, 0, 90).reference("part", 0, 0, 0, 2, true);
  file.reference("part", 0, 0, 270, 1, true).end();
  file.begin("all").reference("top", 1000, 1000, 180).end();
  const Input input = read(file.finish());
  ASSERT_EQ(input.polygons.size(), 3U);
  // (x, y) -> (10 - y, x) -> (1 - 10 + y, 1 - x)
  EXPECT_EQ(input.polygons[0].rings[0],
            (Points{{-9, 1}, {-9, -2}, {-8, -2}, {-8, 0}, {-7, 0}, {-7, 1}}));
  // (x, y) -> (2 x, -2 y) -> (1 - 2 x, 1 + 2 y)
  EXPECT_EQ(input.polygons[1].rings[0],
            (Points{{1, 1}, {-5, 1}, {-5, 3}, {-1, 3}, {-1, 5}, {1, 5}}));
  // (x, y) -> (x, -y) -> (-y, -x) -> (1 + y, 1 + x)
  EXPECT_EQ(input.polygons[2].rings[0], (Points{{1, 1}, {1, 4}, {2, 4}, {2, 2}, {3, 2}, {3, 1}}));

  GdsWriter slanted;
  slanted.begin("part").box(1, 0, 0, 0, 1000, 1000).end();
  slanted.begin("top").reference("part", 0, 0, 30, 0.5).end();
  const Point corner = read(slanted.finish()).polygons[0].rings[0][1];
  EXPECT_NEAR(corner.x, 0.5 * std::cos(M_PI / 6), 1e-15);
  EXPECT_NEAR(corner.y, 0.25, 1e-15);
}

TEST(ReadGds, ArraysHaveRowsAndColumns) {
  GdsWriter file;
  file.begin("dot").box(1, 0, 0, 0, 10, 10).end();
  file.begin("top").array("dot", 3, 2, {{0, 0}, {300, 0}, {0, 100}}).end();
  const Input input = read(file.finish());
  ASSERT_EQ(input.polygons.size(), 6U);
  EXPECT_EQ(input.polygons[5].rings[0][0], (Point{0.2, 0.05}));
  EXPECT_NEAR(area_of(input, "L1D0"), 6 * 1e-4, 1e-18);
  // A slanted one: columns along (1, 1), rows along (-1, 1).
  GdsWriter slanted;
  slanted.begin("dot").box(1, 0, 0, 0, 10, 10).end();
  slanted.begin("top").array("dot", 2, 2, {{0, 0}, {200, 200}, {-200, 200}}).end();
  EXPECT_EQ(read(slanted.finish()).polygons[3].rings[0][0], (Point{0, 0.2}));
}

TEST(ReadGds, PathsHaveWidthAndEnds) {
  GdsWriter file;
  file.begin("top").path(1, 0, 200, 0, {{0, 0}, {1000, 0}, {1000, 1000}});
  file.path(2, 0, 200, 2, {{0, 5000}, {1000, 5000}})
      .path(3, 0, 0, 0, {{0, 9000}, {500, 9000}, {900, 9100}})
      .end();
  const Input input = read(file.finish());
  EXPECT_NEAR(area_of(input, "L1D0"), 0.2 * 1.1 + 0.2 * 0.9, 1e-12);
  EXPECT_NEAR(area_of(input, "L2D0"), 0.2 * 1.2, 1e-12);
  ASSERT_EQ(input.lines.size(), 1U);
  EXPECT_EQ(input.lines[0].name, "L3D0");
  EXPECT_EQ(input.lines[0].points, (Points{{0, 9}, {0.5, 9}, {0.9, 9.1}}));
}

TEST(ReadGds, TheWindowCutsAndSparesTheRest) {
  GdsWriter file;
  file.begin("dot").box(1, 0, 0, 0, 10, 10).end();
  file.begin("row").array("dot", 30000, 30000, {{0, 0}, {600000, 0}, {0, 600000}}).end();
  file.begin("top").array("row", 1000, 1000, {{0, 0}, {600000000, 0}, {0, 600000000}}).end();
  ReadOptions options;
  options.window = Window{{599.985, 599.985}, {600.065, 600.045}};
  const Input input = read(file.finish(), options);
  // Dots of 0.01 every 0.02: from x = 599.98, cut off, on to 600.06, cut off; so are rows.
  EXPECT_NEAR(area_of(input, "L1D0"), (0.005 + 3 * 0.01 + 0.005) * (0.005 + 2 * 0.01 + 0.005),
              1e-12);
  for (const InputPolygon& polygon : input.polygons)
    for (const Point p : polygon.rings[0]) {
      EXPECT_TRUE(p.x >= 599.985 && p.x <= 600.065 && p.y >= 599.985 && p.y <= 600.045);
    }
  EXPECT_NE(message(file.bytes()).find("choose a part by --window or --cell"), std::string::npos);
}

TEST(ReadGds, AWindowShowsWhatAllShows) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> at(-50, 50), angle(0, 7), size(1, 20);
  for (int run = 0; run < 20; ++run) {
    GdsWriter file;
    file.begin("part")
        .box(1, 0, at(random), at(random), 60 + size(random), 60 + size(random))
        .end();
    file.begin("two").reference("part", at(random), at(random), 45 * angle(random), 1,
                                run % 2 == 0);
    file.array("part", 2, 3, {{at(random), at(random)}, {200, 10}, {-10, 300}}, 45 * angle(random))
        .end();
    file.begin("top").array("two", 3, 2, {{0, 0}, {900, 30}, {0, 800}}, 45 * angle(random)).end();
    ReadOptions options;
    options.window = Window{{at(random) / 100.0, 0.1}, {0.6, 0.7}};
    const Input whole = read(file.finish()), part = read(file.bytes(), options);
    Input cut = whole;  // what the window shows of it, by painting the rest over
    const auto [low, high] = *options.window;
    const double far = 10;
    for (const auto& [x0, y0, x1, y1] :
         {std::array{-far, -far, low.x, far}, std::array{high.x, -far, far, far},
          std::array{-far, -far, far, low.y}, std::array{-far, high.y, far, far}})
      testing::add_polygon(cut, testing::rectangle(x0, y0, x1, y1), "outside").priority = 1e9;
    EXPECT_NEAR(area_of(part, "L1D0"), area_of(cut, "L1D0"), 1e-9) << run;
  }
}

TEST(ReadGds, TextsNameRegions) {
  GdsWriter file;
  file.begin("top")
      .box(1, 0, 0, 0, 10, 10)
      .box(1, 0, 20, 0, 30, 10)
      .label(1, 5, 25, 5, "source")
      .label(2, 5, 5, 5, "x")
      .end();
  EXPECT_TRUE(read(file.finish()).seeds.empty());
  ReadOptions options;
  options.label_layer = "1/5";
  const auto out = testing::clean(read(file.bytes(), options));
  ASSERT_TRUE(out) << out.error().message;
  ASSERT_EQ(out->table.regions.size(), 2U);
  std::set<std::string> names;
  for (const Region& region : out->table.regions) {
    EXPECT_EQ(region.material_name, "L1D0");
    names.insert(region.name);
  }
  EXPECT_EQ(names.count("source"), 1U);

  options.label_layer = "3/5";
  EXPECT_EQ(message(file.bytes(), options),
            "a.gds: label_layer: no text is on the layer '3/5'; texts are on 1/5, 2/5");
  options.label_layer = "names";
  EXPECT_NE(message(file.bytes(), options).find("'names' is not a layer"), std::string::npos);
  options.is_one_of_several = true;  // it is a layer of a drawing
  const Input part = read(file.bytes(), options);
  ASSERT_EQ(part.asked.size(), 1U);
  EXPECT_FALSE(part.asked[0].is_there);
}

TEST(ReadGds, LabelsOnTheBorderOfAWindowAreTold) {
  GdsWriter file;
  file.begin("top").box(1, 0, 0, 0, 10, 10);
  file.label(1, 5, 5, 5, "edge").label(1, 5, 5, 10, "corner").label(1, 5, 7, 7, "in");
  file.label(1, 5, 2, 7, "out").label(1, 5, 5, 12, "above").end();
  ReadOptions options;
  options.label_layer = "1/5";
  options.window = Window{{0.005, 0.005}, {0.01, 0.01}};
  const Input input = read(file.finish(), options);
  ASSERT_EQ(input.seeds.size(), 1U);
  EXPECT_EQ(input.seeds[0].region, "in");
  EXPECT_EQ(input.warnings,
            std::vector<std::string>{"2 labels are on the border of the window, where faces end, "
                                     "and left out: the first is 'edge' at (0.005, 0.005)"});
  options.window = Window{{0.003, 0.001}, {0.004, 0.002}};
  EXPECT_EQ(read(file.bytes(), options).warnings,
            std::vector<std::string>{"no text on the layer '1/5' is in what is drawn: no region "
                                     "has a name of it"});
}

TEST(ReadGds, LabelsOnSegmentsAreCalledAsTheyAreWritten) {
  GdsWriter file;
  file.begin("top").box(1, 0, 0, 0, 10, 10).label(63, 5, 0, 5, "onedge").end();
  ReadOptions options;
  options.label_layer = "63/5";
  const auto out = testing::clean(read(file.finish(), options));
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().message.find("a.gds: the text 'onedge' of layer 63/5 at (0, "), 0U)
      << out.error().message;
}

TEST(ReadGds, ATopCellIsChosen) {
  GdsWriter file;
  file.begin("a").box(1, 0, 0, 0, 10, 10).end().begin("b").box(2, 0, 0, 0, 10, 10).end();
  EXPECT_EQ(message(file.finish()), "a.gds: it has 2 top cells (a, b): name one by --cell");
  ReadOptions options;
  options.cell = "b";
  EXPECT_EQ(read(file.bytes(), options).polygons[0].material, "L2D0");
  options.cell = "c";
  EXPECT_EQ(message(file.bytes(), options), "a.gds: there is no cell 'c'");
}

TEST(ReadGds, HostileFilesAreRefused) {
  EXPECT_EQ(message(""), "a.gds: byte 0: the file ends before its record ENDLIB");
  EXPECT_EQ(message(std::string("\0\3\0\2", 4)),
            "a.gds: byte 0: a record announces 3 bytes, fewer than its head has");
  EXPECT_EQ(message(std::string("\xff\xff\0\2", 4)),
            "a.gds: byte 0: a record announces 65535 bytes where 4 are left");
  EXPECT_EQ(message(std::string("\0\4\5\2", 4)),
            "a.gds: byte 0: a GDSII file begins with the record HEADER");
  EXPECT_NE(message(GdsWriter().finish()).find("there is no cell in it"), std::string::npos);
  GdsWriter self;
  self.begin("a").reference("a", 0, 0).end();
  EXPECT_NE(message(self.finish()).find("cells contain themselves"), std::string::npos);
  GdsWriter ring;
  ring.begin("top").reference("a", 0, 0).end().begin("a").reference("b", 0, 0).end();
  ring.begin("b").reference("a", 0, 0).end();
  EXPECT_EQ(message(ring.finish()), "a.gds: the cell 'a' contains itself");
  GdsWriter lost;
  lost.begin("a").reference("nowhere", 0, 0).end();
  EXPECT_NE(message(lost.finish()).find("there is no cell 'nowhere', which 'a' refers to"),
            std::string::npos);
  EXPECT_NE(message(GdsWriter(0, 1).begin("a").end().finish()).find("UNITS"), std::string::npos);
  GdsWriter twice;
  twice.begin("a").end().begin("a").end();
  EXPECT_NE(message(twice.finish()).find("there are two cells 'a'"), std::string::npos);
  GdsWriter rows;
  rows.begin("a").end().begin("b").array("a", 0, 3, {{0, 0}, {1, 0}, {0, 1}}).end();
  EXPECT_NE(message(rows.finish()).find("an array of 0 columns and 3 rows"), std::string::npos);
}

TEST(ReadGds, BombsAreRefusedAtOnce) {
  // Each cell has the one before it nine times; and an array of arrays, all at one place.
  for (const bool with_shapes : {true, false}) {
    GdsWriter nested;
    nested.begin("c0");
    if (with_shapes) nested.box(1, 0, 0, 0, 10, 10);
    nested.end();
    for (int k = 1; k < 40; ++k) {
      nested.begin("c" + std::to_string(k));
      for (int n = 0; n < 9; ++n) nested.reference("c" + std::to_string(k - 1), n, 0);
      nested.end();
    }
    EXPECT_NE(message(nested.finish()).find("choose a part"), std::string::npos);
    ReadOptions options;
    options.window = Window{{-1, -1}, {1, 1}};
    if (with_shapes) {
      EXPECT_NE(message(nested.bytes(), options).find("too many shapes in the window"),
                std::string::npos);
    } else {
      EXPECT_TRUE(read(nested.bytes(), options).polygons.empty());
    }
  }
  GdsWriter piled;
  piled.begin("dot").box(1, 0, 0, 0, 10, 10).end();
  piled.begin("pile").array("dot", 32767, 32767, {{0, 0}, {0, 0}, {0, 0}}).end();
  piled.begin("top").array("pile", 32767, 32767, {{0, 0}, {0, 0}, {0, 0}}).end();
  ReadOptions options;
  options.window = Window{{-1, -1}, {1, 1}};
  EXPECT_NE(message(piled.finish(), options).find("too many shapes in the window"),
            std::string::npos);
  GdsWriter deep;
  deep.begin("c0").box(1, 0, 0, 0, 10, 10).end();
  for (int k = 1; k < 100000; ++k)
    deep.begin("c" + std::to_string(k)).reference("c" + std::to_string(k - 1), 0, 0).end();
  EXPECT_NE(message(deep.finish()).find("one in the other"), std::string::npos);
}

TEST(ReadInput, SaysHowToConvertWhatOthersRead) {
  const auto told = [](const char* extension, const ReadOptions& options = {}) {
    const Result<Input> input = parse_input("", extension, "a", options);
    EXPECT_FALSE(input);
    return input ? "" : input.error().message;
  };
  for (const char* map : {".shp", ".gpkg", ".fgb", ".gml", ".KML"})
    EXPECT_NE(told(map).find("ogr2ogr -f GeoJSON OUT.geojson FILE"), std::string::npos) << map;
  EXPECT_NE(told(".dxf").find("ogr2ogr -f GeoJSON"), std::string::npos);
  for (const auto& [extension, component] :
       {std::pair(".dxf", "cover::dxf, <cover/read_dxf.hpp>"),
        std::pair(".shp", "cover::gdal, <cover/read_gdal.hpp>"),
        std::pair(".geo", "cover::gmsh, <cover/read_geo.hpp>")})
    EXPECT_NE(told(extension).find(component), std::string::npos) << extension;
  for (const char* mesh : {".vtm", ".vtkhdf"})
    EXPECT_NE(told(mesh).find("cover convert FILE -o FILE.msh"), std::string::npos) << mesh;
  EXPECT_NE(told(".oas").find("strm2gds"), std::string::npos);
  ReadOptions options;
  options.crs = "EPSG:25832";
  EXPECT_NE(told(".geojson", options).find("takes GDAL"), std::string::npos);
}

TEST(ReadGds, EveryCutOffFileIsAnError) {
  GdsWriter file;
  file.begin("dot")
      .box(1, 0, 0, 0, 10, 10)
      .path(1, 0, 4, 1, {{0, 0}, {9, 9}})
      .label(1, 0, 0, 0, "x")
      .end();
  file.begin("top")
      .array("dot", 2, 2, {{0, 0}, {100, 0}, {0, 100}})
      .reference("dot", 7, 7, 45)
      .end();
  const std::string bytes = file.finish();
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    const Result<Input> input = parse_gds(bytes.substr(0, n), "a.gds", {});
    ASSERT_FALSE(input) << n;
    EXPECT_FALSE(input.error().message.empty());
  }
}

}  // namespace
}  // namespace cover
