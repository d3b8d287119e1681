// Systems by their numbers, and what is said where maps are laid over each other that are not in
// one.
#include "io/input/coordinate_systems.hpp"

#include <gtest/gtest.h>

#include <cover/join_inputs.hpp>

namespace cover {
namespace {

/// A map of one square.
Input square_map(const char* source, const char* system, Point low, double side) {
  Input input;
  input.source = source;
  input.system = system;
  InputPolygon polygon;
  polygon.rings = {
      {low, {low.x + side, low.y}, {low.x + side, low.y + side}, {low.x, low.y + side}}};
  input.polygons.push_back(polygon);
  return input;
}
Input on_globe(const char* source, const char* system) {
  return square_map(source, system, {9, 48}, 0.125);
}
Input in_plane(const char* source, const char* system) {
  return square_map(source, system, {500000, 5300000}, 1000);
}

TEST(CoordinateSystems, NumbersAreKnownHoweverTheyAreWritten) {
  for (const char* name : {"urn:ogc:def:crs:EPSG::25832", "urn:ogc:def:crs:EPSG:9.8:25832",
                           "urn:x-ogc:def:crs:EPSG:25832", "epsg:25832", "EPSG:25832",
                           "http://www.opengis.net/def/crs/EPSG/0/25832"})
    EXPECT_EQ(system_of_name(name), "EPSG:25832") << name;
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "OGC:CRS84", "EPSG:4326"})
    EXPECT_EQ(system_of_name(name), kLongitudeLatitude) << name;
  for (const char* name :
       {"ETRS89 / UTM zone 32N", "", "urn:ogc:def:crs,crs:EPSG::25832,EPSG::7837"})
    EXPECT_EQ(system_of_name(name), name);
  EXPECT_EQ(system_of_name("EPSG:4979"), kLongitudeLatitude);
  EXPECT_EQ(system_of_name("ESRI:102100"), system_of_name("urn:ogc:def:crs:EPSG::900913"));
  EXPECT_TRUE(surely_differ("EPSG:25832", "EPSG:4326"));
  EXPECT_FALSE(surely_differ("EPSG:25832", "IGNF:UTM32"));
  EXPECT_FALSE(surely_differ("EPSG:25832", "EPSG:25832"));
  EXPECT_FALSE(surely_differ("EPSG:25832", "ETRS89 / UTM zone 32N"));
  EXPECT_FALSE(surely_differ("EPSG:25832", ""));
}

TEST(CoordinateSystems, DifferentOnesAreRefusedWithBothFiles) {
  Input plane = in_plane("b.shp", "EPSG:25832");
  plane.unit = "m";
  const Result<Input> joined =
      join_inputs({on_globe("plain.geojson", ""), on_globe("a.gpkg", "EPSG:4326"), plane});
  ASSERT_FALSE(joined);
  EXPECT_EQ(joined.error().code, ErrorCode::bad_option);
  EXPECT_EQ(
      joined.error().message,
      "a.gpkg and b.shp cannot be taken together: their coordinates are in different "
      "systems, EPSG:4326 and EPSG:25832: 'ogr2ogr -t_srs EPSG:25832 OUT.gpkg a.gpkg' makes "
      "a file in the system of b.shp, and --crs EPSG:25832 projects all maps that say theirs");
}

TEST(CoordinateSystems, MapsOfOneHaveOneUnit) {
  Input with_unit = in_plane("b.shp", "EPSG:25832");
  with_unit.unit = "m";
  for (const bool first : {true, false}) {
    std::vector<Input> inputs{in_plane("a.geojson", "EPSG:25832"), with_unit};
    if (first) std::swap(inputs[0], inputs[1]);
    const Result<Input> joined = join_inputs(inputs);
    ASSERT_TRUE(joined) << joined.error().message;
    EXPECT_EQ(joined->unit, "m");
    EXPECT_EQ(joined->system, "EPSG:25832");
    EXPECT_TRUE(joined->warnings.empty());
  }
}

TEST(CoordinateSystems, WhereOneIsNotKnownTheExtentsTell) {
  const Result<Input> apart =
      join_inputs({on_globe("a.geojson", ""), in_plane("b.geojson", "EPSG:25832")});
  ASSERT_TRUE(apart) << apart.error().message;
  ASSERT_EQ(apart->warnings.size(), 1U);
  EXPECT_EQ(apart->warnings[0],
            "coordinates of a.geojson (no system is said) could be longitudes and latitudes, those "
            "of b.geojson (EPSG:25832) are none, so they may be in different systems");
  const Result<Input> other =
      join_inputs({in_plane("a.geojson", ""), on_globe("b.geojson", "EPSG:4326")});
  ASSERT_TRUE(other) << other.error().message;
  ASSERT_EQ(other->warnings.size(), 1U);

  Input metres = in_plane("b.shp", "EPSG:25832");
  metres.unit = "m";
  const Result<Input> refused = join_inputs({on_globe("a.geojson", ""), metres});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("'ogr2ogr -s_srs EPSG:4326 -t_srs EPSG:25832 OUT.geojson "
                                         "a.geojson'"),
            std::string::npos)
      << refused.error().message;

  // Nothing is said of any, or they lie where the other does.
  for (const auto& [one, two] :
       {std::pair(on_globe("a.json", ""), in_plane("b.json", "")),
        std::pair(on_globe("a.json", ""), on_globe("b.json", "EPSG:4326")),
        std::pair(in_plane("a.json", ""), in_plane("b.json", "EPSG:25832")),
        std::pair(square_map("a.json", "", {0, 0}, 10),
                  square_map("b.json", "EPSG:25832", {5, 5}, 400))}) {
    const Result<Input> joined = join_inputs({one, two});
    ASSERT_TRUE(joined) << joined.error().message;
    EXPECT_TRUE(joined->warnings.empty()) << joined->warnings[0];
  }
}

TEST(CoordinateSystems, PixelsOfAPictureHaveNoPlaceOnAMap) {
  Input picture = square_map("a.tif", "", {0, 0}, 60);
  picture.is_picture = true;
  const std::string sentence =
      "a.tif is a picture, whose pixels have no place on the map b.shp (EPSG:25832): they lie from "
      "(0, 0) to (60, 60), apart from it; 'gdal_polygonize.py a.tif -f GeoJSON OUT.geojson' makes "
      "a map of one that says its place";
  Input map = in_plane("b.shp", "EPSG:25832");
  const Result<Input> apart = join_inputs({picture, map});
  ASSERT_TRUE(apart) << apart.error().message;
  EXPECT_EQ(apart->warnings, std::vector<std::string>{sentence});
  EXPECT_FALSE(apart->is_picture);
  map.unit = "m";
  const Result<Input> refused = join_inputs({map, picture});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "b.shp and a.tif cannot be taken together: " + sentence);
  const Result<Input> beside =
      join_inputs({picture, square_map("b.json", "EPSG:25832", {5, 5}, 400)});
  ASSERT_TRUE(beside) << beside.error().message;
  EXPECT_TRUE(beside->warnings.empty());
}

TEST(CoordinateSystems, NamesAloneAreTold) {
  const Result<Input> joined =
      join_inputs({in_plane("a.shp", "Soldner Berlin"), in_plane("b.shp", "EPSG:25832")});
  ASSERT_TRUE(joined) << joined.error().message;
  ASSERT_EQ(joined->warnings.size(), 1U);
  EXPECT_NE(joined->warnings[0].find("a.shp (Soldner Berlin) and b.shp (EPSG:25832) name their "
                                     "coordinate systems differently"),
            std::string::npos)
      << joined->warnings[0];
}

}  // namespace
}  // namespace cover
