#include <cover/read_gdal.hpp>

#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include <cover/cover_mesh.hpp>
#include <cover/read_input.hpp>
#include <cover/units.hpp>
#include <cover/verify.hpp>

#include "support/inputs/soups.hpp"
#include "support/read_result.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

namespace fs = std::filesystem;

/// Two parcels, one with a courtyard and one of two parts, and a field; in degrees.
const char* const kParcels = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"material": "house", "name": "7/1", "priority": 2, "size": 0.125, "landuse": "built", "nr": 12, "value": 1.5},
   "geometry": {"type": "Polygon", "coordinates": [[[8.5, 49.25], [8.75, 49.25], [8.75, 49.5], [8.5, 49.5], [8.5, 49.25]],
                                                   [[8.5625, 49.3125], [8.5625, 49.375], [8.625, 49.375], [8.625, 49.3125], [8.5625, 49.3125]]]}},
  {"type": "Feature", "properties": {"material": null, "name": "7/2", "priority": 1, "landuse": "green", "nr": 13, "value": 2},
   "geometry": {"type": "MultiPolygon", "coordinates": [[[[8.75, 49.25], [9, 49.25], [9, 49.5], [8.75, 49.5], [8.75, 49.25]]],
                                                        [[[9.25, 49.25], [9.5, 49.25], [9.5, 49.5], [9.25, 49.25]]]]}},
  {"type": "Feature", "properties": {"material": null, "name": null, "priority": null, "landuse": null, "nr": null, "value": null},
   "geometry": {"type": "Polygon", "coordinates": [[[8.25, 49], [9.75, 49], [9.75, 49.75], [8.25, 49.75], [8.25, 49]]]}}]})";

class ReadGdal : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { GDALAllRegister(); }

  std::string parcels() { return folder_.write("parcels.geojson", kParcels); }

  /// The parcels in another format, with further arguments as of ogr2ogr.
  std::string converted(const std::string& name, std::vector<std::string> more = {}) {
    const std::string from = parcels(), to = (folder_.path() / name).string();
    std::vector<char*> words;
    for (std::string& word : more) words.push_back(word.data());
    words.push_back(nullptr);
    GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(words.data(), nullptr);
    GDALDatasetH source = GDALOpenEx(from.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr);
    int failed = 0;
    GDALDatasetH made = GDALVectorTranslate(to.c_str(), nullptr, 1, &source, options, &failed);
    EXPECT_EQ(failed, 0) << name;
    GDALClose(made);
    GDALClose(source);
    GDALVectorTranslateOptionsFree(options);
    return to;
  }

  Input read(const std::string& path, const ReadOptions& options = {}) {
    return testing::must_read(read_gdal(path, options));
  }
  static std::string message(const std::string& path, const ReadOptions& options = {}) {
    SCOPED_TRACE(path);
    return testing::must_refuse(read_gdal(path, options));
  }

  testing::TemporaryFolder folder_;
};

/// Corners of all triangles with their regions' names and materials, sorted.
using Triangles = std::vector<std::tuple<std::string, std::string, std::array<Point, 3>>>;
Triangles mesh_of(const Input& input) {
  const Result<Output> out = cover_mesh(input);
  EXPECT_TRUE(out) << out.error().message;
  if (!out) return {};
  const TriangleSoup soup = triangle_soup(out->mesh);
  Triangles all;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners.at(k) = soup.points[soup.triangles[t][k]];
    std::sort(corners.begin(), corners.end());
    const Region& region = out->table.regions[static_cast<std::size_t>(soup.region[t]) - 1];
    all.emplace_back(region.name, region.material_name, corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST_F(ReadGdal, AGeoJsonIsWhatOurOwnReaderMakesOfIt) {
  const Result<Input> own = read_input(parcels());
  ASSERT_TRUE(own);
  const Input input = read(parcels());
  ASSERT_EQ(input.polygons.size(), own->polygons.size());
  for (std::size_t k = 0; k < input.polygons.size(); ++k) {
    EXPECT_EQ(input.polygons[k].rings, own->polygons[k].rings);
    EXPECT_EQ(input.polygons[k].material, own->polygons[k].material);
    EXPECT_EQ(input.polygons[k].region, own->polygons[k].region);
    EXPECT_EQ(input.polygons[k].priority, own->polygons[k].priority);
    EXPECT_EQ(input.polygons[k].size, own->polygons[k].size);
    EXPECT_EQ(input.polygons[k].id, own->polygons[k].id);
  }
  EXPECT_EQ(input.polygons[0].size, 0.125);
  EXPECT_EQ(mesh_of(input), mesh_of(*own));
}

TEST_F(ReadGdal, EveryFormatGivesTheSameMesh) {
  const Triangles expected = mesh_of(*read_input(parcels()));
  for (const char* name : {"p.gpkg", "p.shp", "p.fgb", "p.gml"}) {
    SCOPED_TRACE(name);
    // FlatGeobuf is read in the order of its index otherwise.
    const std::string path = converted(
        name, std::string(name) == "p.fgb" ? std::vector<std::string>{"-lco", "SPATIAL_INDEX=NO"}
                                           : std::vector<std::string>{});
    const auto before = std::distance(fs::directory_iterator(folder_.path()), {});
    EXPECT_EQ(mesh_of(read(path)), expected);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), before)
        << "files were made";
  }
}

TEST_F(ReadGdal, AttributesAreChosen) {
  ReadOptions options;
  options.material_field = "LANDUSE";
  options.name_field = "nr";
  options.priority_field = "value";
  const Input input = read(converted("p.gpkg"), options);
  ASSERT_EQ(input.polygons.size(), 4U);
  EXPECT_EQ(input.polygons[0].material, "built");
  EXPECT_EQ(input.polygons[1].material, "green");
  EXPECT_EQ(input.polygons[2].region, "13");
  EXPECT_EQ(input.polygons[0].priority, 1.5);
  EXPECT_EQ(input.polygons[3].material, "feature_2");
  EXPECT_FALSE(input.polygons[3].priority.has_value());
  options.name_field = "value";
  EXPECT_EQ(read(converted("p.shp"), options).polygons[1].region, "2.0");
  options.material_field = "use";
  EXPECT_NE(message(converted("p.fgb"), options).find("has no attribute 'use'; its attributes: "),
            std::string::npos);
}

TEST_F(ReadGdal, AttributesAreKept) {
  ReadOptions options;
  options.keep_fields = {"landuse", "value", "fid"};
  for (const char* name : {"p.gpkg", "p.shp", "p.gml"}) {
    SCOPED_TRACE(name);
    const Input input = read(converted(name), options);
    ASSERT_EQ(input.attributes.size(), 3U);
    ASSERT_EQ(input.polygons.size(), 4U);
    EXPECT_EQ(input.attributes[0].words, (std::vector<std::string>{"built", "green"}));
    EXPECT_EQ(input.attributes[0].values, (std::vector<double>{1, 2, 0}));
    EXPECT_FALSE(input.attributes[1].is_text);
    EXPECT_EQ(input.attributes[1].values[0], 1.5);
    EXPECT_TRUE(std::isnan(input.attributes[1].values[2]));
    const double first = input.attributes[2].values[0];
    EXPECT_EQ(input.attributes[2].values, (std::vector<double>{first, first + 1, first + 2}));
    // Both parts of the second feature.
    EXPECT_EQ(input.polygons[1].feature, 2U);
    EXPECT_EQ(input.polygons[2].feature, 2U);
  }
  const Result<Output> output = cover_mesh(read(converted("p.fgb"), options));
  ASSERT_TRUE(output) << output.error().message;
  const RegionTable& table = output->table;
  ASSERT_EQ(table.attributes.size(), 3U);
  for (const Region& region : table.regions) {
    const double word = table.attributes[0].values[place_of(region.id)];
    const std::string use =
        word == 0 ? "none" : table.attributes[0].words[static_cast<std::size_t>(word) - 1];
    EXPECT_EQ(use, region.name == "7/1"   ? "built"
                   : region.name == "7/2" ? "green"
                                          : "none")
        << region.name;
  }
  options.keep_fields = {"use"};
  EXPECT_NE(message(converted("q.gpkg"), options)
                .find("keep_field: the layer 'parcels' has no attribute 'use'; its attributes: "),
            std::string::npos);
}

TEST_F(ReadGdal, DegreesAreToldAndProjected) {
  const Input degrees = read(converted("p.gpkg"));
  ASSERT_EQ(degrees.warnings.size(), 1U);
  EXPECT_NE(degrees.warnings[0].find("longitudes and latitudes"), std::string::npos);
  ReadOptions options;
  options.crs = "EPSG:25832";
  const Input metres = read(converted("p.gpkg"), options);
  EXPECT_TRUE(metres.warnings.empty());
  EXPECT_EQ(metres.unit, "m");
  // On the middle meridian of zone 32, nine degrees, x is 500 km; a degree is some 111 km.
  EXPECT_NEAR(metres.polygons[1].rings[0][1].x, 500000, 1e-3);
  EXPECT_NEAR(metres.polygons[1].rings[0][2].y - metres.polygons[1].rings[0][1].y, 0.25 * 111200,
              50);
  EXPECT_NEAR(metres.polygons[1].rings[0][1].y, 5455250, 2000);
  const Input again = read(converted("q.gpkg", {"-t_srs", "EPSG:25832"}));
  EXPECT_EQ(again.unit, "m");
  EXPECT_NEAR(again.polygons[0].rings[0][2].x, metres.polygons[0].rings[0][2].x, 1e-6);
  const std::string map = converted("r.gpkg");
  // Nor is a system looked for in a file or on a network.
  for (const std::string& unknown : {std::string("EPSG:0"), folder_.write("a.prj", "EPSG:25832"),
                                     std::string("http://localhost:1/crs")}) {
    options.crs = unknown;
    EXPECT_EQ(message(map, options), "crs: PROJ does not know '" + unknown + "'; as EPSG:25832");
  }
  // A height, one below sea, x, y and z from the middle of the earth.
  for (const std::string other : {"EPSG:5773", "EPSG:5783", "EPSG:4978"}) {
    options.crs = other;
    EXPECT_EQ(message(map, options), "crs: '" + other +
                                         "' is a system of heights, or in space, and no plane one; "
                                         "as EPSG:25832");
  }
  options.crs = "EPSG:25832+5783";  // with a height
  EXPECT_EQ(read(map, options).unit, "m");
}

TEST_F(ReadGdal, WithoutASystemNothingIsProjected) {
  const std::string path = converted("p.shp");
  fs::remove(folder_.path() / "p.prj");
  EXPECT_TRUE(read(path).warnings.empty());
  ReadOptions options;
  options.crs = "EPSG:25832";
  EXPECT_EQ(message(path, options),
            "crs: the layer does not say in which system its coordinates are");
}

TEST_F(ReadGdal, TextsThatAreNoUtf8AreTold) {
  const std::string path = converted("p.shp");
  const fs::path table = folder_.path() / "p.dbf";
  fs::remove(folder_.path() / "p.cpg");
  std::fstream file(table, std::ios::in | std::ios::out | std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  constexpr std::size_t kCodePage = 29;
  bytes[kCodePage] = 0;
  const std::size_t name = bytes.find("7/1");
  ASSERT_NE(name, std::string::npos);
  bytes[name] = '\xe4';
  file.seekp(0).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  ReadOptions options;
  options.keep_fields = {"landuse"};
  const std::vector<std::string> told = read(path, options).warnings;
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told[0].find("1 text is no UTF-8, '\\xe4/1' of feature 0: a .cpg beside the .shp, or "
                         "the environment variable SHAPE_ENCODING, says in which code page"),
            0U)
      << told[0];
  std::ofstream(folder_.path() / "p.cpg") << "ISO-8859-1";
  const Input known = read(path, options);
  EXPECT_EQ(known.polygons[0].region, "\xc3\xa4/1");
  EXPECT_EQ(known.warnings, (std::vector<std::string>{told.begin() + 1, told.end()}));
}

TEST_F(ReadGdal, CoordinatesOfNoKnownSystemAreRefusedOrTold) {
  const auto map = [&](const std::string& crs, const std::string& ring) {
    return folder_.write("m.geojson", R"({"type": "FeatureCollection",)" + crs +
                                          R"("features": [{"type": "Feature", "properties": {},
      "geometry": {"type": "Polygon", "coordinates": [[)" +
                                          ring + R"(]]}}]})");
  };
  ReadOptions utm;
  utm.crs = "EPSG:25832";
  const std::string unknown = R"("crs": {"type": "name", "properties": {"name": "EPSG:123456"}},)";
  const std::string degrees = "[9, 48], [9.1, 48], [9.1, 48.1], [9, 48]";
  EXPECT_NE(message(map(unknown, degrees), utm).find("coordinates is not known"),
            std::string::npos);
  const Input input = read(map(unknown, degrees));
  ASSERT_FALSE(input.warnings.empty());
  EXPECT_NE(input.warnings[0].find("coordinates is not known"), std::string::npos);
  // Metres where degrees should be.
  const std::string metres =
      "[500000, 5300000], [500100, 5300000], [500100, 5300100], [500000, 5300000]";
  EXPECT_NE(message(map("", metres), utm).find("(500000, 5300000) is no longitude and latitude"),
            std::string::npos);
}

/// Gives a GeoPackage a layer more, with an attribute `name` and one feature.
void add_layer(const std::string& path, const char* layer, const char* wkt, int epsg = 0) {
  GDALDatasetH dataset =
      GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE, nullptr, nullptr, nullptr);
  OGRSpatialReference system;
  if (epsg != 0) system.importFromEPSG(epsg);
  OGRGeometry* geometry = nullptr;
  ASSERT_EQ(OGRGeometryFactory::createFromWkt(wkt, nullptr, &geometry), OGRERR_NONE);
  OGRLayer* made = GDALDataset::FromHandle(dataset)->CreateLayer(
      layer, epsg != 0 ? &system : nullptr, geometry->getGeometryType(), nullptr);
  OGRFieldDefn field("name", OFTString);
  ASSERT_EQ(made->CreateField(&field), OGRERR_NONE);
  OGRFeature feature(made->GetLayerDefn());
  feature.SetField("name", "B 3");
  feature.SetGeometryDirectly(geometry);
  ASSERT_EQ(made->CreateFeature(&feature), OGRERR_NONE);
  GDALClose(dataset);
}

TEST_F(ReadGdal, LayersAreChosen) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "roads", "LINESTRING (8.5 49.4, 9 49.4)");
  EXPECT_EQ(message(path),
            path + ": it has 2 layers (parcels, roads): name those to be read by --layer");
  ReadOptions options;
  options.layers = {"roads", "parcels"};
  const Input input = read(path, options);
  EXPECT_EQ(input.polygons.size(), 4U);
  ASSERT_EQ(input.lines.size(), 1U);
  EXPECT_EQ(input.lines[0].name, "B 3");
  options.layers = {"rails"};
  EXPECT_EQ(message(path, options),
            path + ": there is no layer 'rails'; its layers: parcels, roads");
}

TEST_F(ReadGdal, OfSeveralFilesOneHasTheLayer) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  ReadOptions options;
  options.is_one_of_several = true;
  options.layers = {"rails"};
  // It has but one layer: that is meant.
  const Input whole = read(path, options);
  EXPECT_EQ(whole.polygons.size(), 4U);
  ASSERT_EQ(whole.asked.size(), 1U);
  EXPECT_FALSE(whole.asked[0].is_there);
  EXPECT_EQ(whole.asked[0].missing, "there is no layer 'rails'; its layers: parcels");
  add_layer(path, "roads", "LINESTRING (8.5 49.4, 9 49.4)");
  EXPECT_EQ(message(path, options), path + ": --layer names none of its layers: parcels, roads");
  options.layers = {"rails", "roads"};
  const Input chosen = read(path, options);
  EXPECT_TRUE(chosen.polygons.empty());
  EXPECT_FALSE(chosen.asked[0].is_there);
  EXPECT_TRUE(chosen.asked[1].is_there);
}

TEST_F(ReadGdal, AttributesAreAskedOfAllLayersTogether) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "roads", "LINESTRING (8.5 49.4, 9 49.4)");
  ReadOptions options;
  options.layers = {"roads", "parcels"};
  options.material_field = "landuse";
  options.keep_fields = {"nr"};
  const Input input = read(path, options);
  EXPECT_EQ(input.polygons[0].material, "built");
  EXPECT_EQ(input.attributes[0].values[0], 12);
  options.material_field = "use";
  const std::string refused = message(path, options);
  EXPECT_EQ(refused.find(path + ": material_field: the layer 'parcels' has no attribute 'use'; its "
                                "attributes: "),
            0U)
      << refused;
  EXPECT_NE(refused.find("; the layer 'roads' has no attribute 'use'; its attributes: name"),
            std::string::npos)
      << refused;
  options.is_one_of_several = true;
  const Input one = read(path, options);
  ASSERT_EQ(one.asked.size(), 4U);
  EXPECT_EQ(one.asked[2].name, "use");
  EXPECT_FALSE(one.asked[2].is_there);
  EXPECT_TRUE(one.asked[3].is_there);
}

TEST_F(ReadGdal, KeptAttributesOfPointsAloneAreRefused) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "wells", "POINT (8.6 49.45)");
  ReadOptions options;
  options.layers = {"parcels", "wells"};
  options.keep_fields = {"name", "fid"};
  EXPECT_EQ(read(path, options).attributes[0].words.size(), 3U);
  options.layers = {"wells"};
  options.is_one_of_several = true;
  const Input wells = read(path, options);
  ASSERT_EQ(wells.asked.size(), 3U);
  for (const AskedName& asked : wells.asked) EXPECT_EQ(asked.is_there, asked.name != "name");
  options.is_one_of_several = false;
  EXPECT_EQ(message(path, options),
            path +
                ": keep_field: only points have the attribute 'name', the first of them feature "
                "1: an array of a mesh holds what areas have");
}

TEST_F(ReadGdal, PointsAreVertices) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "wells", "MULTIPOINT (8.6 49.45, 8.9 49.3)");
  ReadOptions options;
  options.layers = {"parcels", "wells"};
  const Input input = read(path, options);
  EXPECT_EQ(input.points, (std::vector<Point>{{8.6, 49.45}, {8.9, 49.3}}));
  const Result<Output> out = cover_mesh(input);
  ASSERT_TRUE(out) << out.error().message;
  const std::vector<Point> vertices = triangle_soup(out->mesh).points;
  for (const Point p : input.points)
    EXPECT_NE(std::find(vertices.begin(), vertices.end(), p), vertices.end()) << p.x;
}

TEST_F(ReadGdal, SurfacesInSpaceAreLeftOutUnlessStrict) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "roofs", "TIN Z (((0 0 0, 1 0 0, 0 1 1, 0 0 0)))");
  ReadOptions options;
  options.layers = {"parcels", "roofs"};
  const Input input = read(path, options);
  ASSERT_EQ(input.changes.size(), 1U);
  EXPECT_EQ(input.changes[0].message, "1 geometry is a surface in space: left out");
  Options strict;
  EXPECT_TRUE(cover_mesh(input, strict));
  strict.strict = true;
  const Result<Output> refused = cover_mesh(input, strict);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::changed_input);
}

TEST_F(ReadGdal, WhatIsLeftOutIsCounted) {
  const std::string path = folder_.write("z.geojson", R"({"type": "FeatureCollection",
    "crs": {"type": "name", "properties": {"name": "EPSG:25832"}}, "features": [
    {"type": "Feature", "properties": {"USE": 1}, "geometry": null},
    {"type": "Feature", "properties": {"USE": 2}, "geometry":
      {"type": "MultiPoint", "coordinates": []}},
    {"type": "Feature", "properties": {"USE": 3}, "geometry":
      {"type": "LineString", "coordinates": [[0, 0, 0], [1, 0, 5], [2, 0, 6]]}}]})");
  const Input input = read(path);
  EXPECT_EQ(input.warnings,
            (std::vector<std::string>{"2 geometries are null or empty: left out",
                                      "2 points are not in the plane: z is dropped"}));
  EXPECT_EQ(input.fields, std::vector<std::string>{"USE"});
}

TEST_F(ReadGdal, TheUnitOfAMapOfAnotherReaderIsThatOfItsSystem) {
  const auto described = [](const std::string& unit, double scale) {
    Input input;
    input.system = "EPSG:25832";
    ReadOptions options;
    options.unit = unit;
    options.scale = scale;
    EXPECT_TRUE(apply_units(input, options));
    describe_system(input, options);
    return std::pair(input.unit, input.warnings);
  };
  using Found = std::pair<std::string, std::vector<std::string>>;
  EXPECT_EQ(described("", 1), Found("m", {}));
  EXPECT_EQ(described("m", 1), Found("m", {}));
  EXPECT_EQ(described("mm", 1000), Found("mm", {}));
  EXPECT_EQ(described("mm", 1),
            Found("mm", {"the option unit says mm, and the input m: mm is taken"}));
  EXPECT_EQ(described("m", 0.001), Found("m", {"the option unit says m, and lengths in m times "
                                               "0.001 are not in it: m is taken"}));
}

TEST_F(ReadGdal, TheSystemIsKnownByItsNumber) {
  for (const char* name : {"p.gpkg", "p.shp", "p.fgb", "p.gml"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(read(converted(name)).system, "EPSG:4326");
    fs::remove(folder_.path() / name);
    fs::remove((folder_.path() / name).replace_extension(".xsd"));
    EXPECT_EQ(read(converted(name, {"-t_srs", "EPSG:25832"})).system, "EPSG:25832");
  }
  ReadOptions options;
  options.crs = "EPSG:25833";
  EXPECT_EQ(read(converted("q.gpkg"), options).system, "EPSG:25833");
  // Heights are left out.
  EXPECT_EQ(read(converted("r.gpkg", {"-a_srs", "EPSG:4979"})).system, "EPSG:4326");
}

TEST_F(ReadGdal, LayersOfTwoSystemsAreRefused) {
  const std::string path = converted("p.gpkg", {"-nln", "parcels"});
  add_layer(path, "roads", "LINESTRING (500000 5400000, 500100 5400000)", 25832);
  ReadOptions options;
  options.layers = {"roads", "parcels"};
  EXPECT_EQ(message(path, options),
            path +
                ": its layers are in different coordinate systems, 'parcels' in EPSG:4326 and "
                "'roads' in EPSG:25832: --crs EPSG:25832 projects them");
  options.crs = "EPSG:25832";
  EXPECT_EQ(read(path, options).lines.size(), 1U);
}

TEST_F(ReadGdal, CurvesBecomeChords) {
  const std::string path = (folder_.path() / "c.gpkg").string();
  GDALDataset* made = GetGDALDriverManager()->GetDriverByName("GPKG")->Create(path.c_str(), 0, 0, 0,
                                                                              GDT_Unknown, nullptr);
  OGRLayer* layer = made->CreateLayer("c", nullptr, wkbCurvePolygon, nullptr);
  OGRFeature feature(layer->GetLayerDefn());
  OGRGeometry* disk = nullptr;
  ASSERT_EQ(OGRGeometryFactory::createFromWkt("CURVEPOLYGON(CIRCULARSTRING(1 0, -1 0, 1 0))",
                                              nullptr, &disk),
            OGRERR_NONE);
  feature.SetGeometryDirectly(disk);
  ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  GDALClose(made);
  for (const double angle : {5.0, 30.0}) {
    ReadOptions options;
    options.chord_angle = angle;
    const Input input = read(path, options);
    const std::vector<Point>& ring = input.polygons[0].rings[0];
    const double chords = static_cast<double>(ring.size()) - 1;
    EXPECT_TRUE(chords >= 360 / angle && chords <= 360 / angle + 1) << chords;
    for (const Point p : ring) EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-12);
  }
}

TEST_F(ReadGdal, KmlIsReadToo) {
  const Input input = read(folder_.write(
      "a.kml", R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document>
    <Placemark><name>lake</name><Polygon><outerBoundaryIs><LinearRing><coordinates>8,49 9,49 9,50 8,49</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>
    <Placemark><name>spot</name><Point><coordinates>8,49</coordinates></Point></Placemark></Document></kml>)"));
  ASSERT_EQ(input.polygons.size(), 1U);
  EXPECT_EQ(input.polygons[0].material, "lake");
  EXPECT_EQ(input.points, (std::vector<Point>{{8, 49}}));
  ASSERT_EQ(input.point_names.size(), 1U);
  EXPECT_EQ(input.point_names[0].point, 0U);
  EXPECT_EQ(input.point_names[0].name, "spot");
  EXPECT_EQ(input.warnings.size(), 1U);
}

TEST_F(ReadGdal, BrokenFilesAreRefused) {
  EXPECT_NE(message("/nonexistent.gpkg").find("cannot open"), std::string::npos);
  EXPECT_NE(message(folder_.path().string()).find("not a regular file"), std::string::npos);
  EXPECT_NE(message("/vsicurl/http://localhost/a.gpkg").find("cannot open"), std::string::npos);
  EXPECT_NE(message(folder_.write("text.shp", "hello")).find("GDAL: "), std::string::npos);
  for (const char* name : {"p.gpkg", "p.shp", "p.fgb", "p.gml", "p.kml"}) {
    SCOPED_TRACE(name);
    const std::string path = converted(name);
    std::ifstream whole(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
    int refused = 0;
    for (const std::size_t part : {0, 1, 2, 4, 8, 9}) {
      std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() * part / 10);
      const Result<Input> input = read_gdal(path);
      refused += input ? 0 : 1;
      if (!input) {
        EXPECT_FALSE(input.error().message.empty());
      }
    }
    EXPECT_GE(refused, 5);
  }
}

}  // namespace
}  // namespace cover
