#include <gtest/gtest.h>

#include "io/input/formats.hpp"

namespace cover {
namespace {

std::string geojson_message(std::string_view text) {
  const Result<Input> input = parse_geojson(text, "map.geojson");
  EXPECT_FALSE(input.has_value());
  return input ? "" : input.error().message;
}

TEST(ReadGeojson, ReadsFeaturesInTheOrderOfTheFile) {
  const Result<Input> input =
      parse_geojson(R"({"type": "FeatureCollection", "crs": {}, "features": [
    {"type": "Feature", "properties": {"material": "Si", "name": "bulk", "priority": 2}, "geometry":
      {"type": "GeometryCollection", "geometries": [
        {"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [1, 1], [0, 0]]],
                                                 [[[5, 0], [6, 0], [6, 1], [5, 0]]]]},
        {"type": "LineString", "coordinates": [[0, 0, 7.5], [1, 0, 7.5]]}]}},
    {"type": "Feature", "properties": {"name": 4, "population": 3},  "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]], [[7, 1], [8, 1], [8, 2], [7, 1]]]}},
    {"type": "Feature", "properties": null, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}},
    {"type": "Feature", "properties": {}, "geometry": null},
    {"type": "Feature", "properties": {"size": 1}, "geometry": {"type": "Point", "coordinates": [1, 1, 4]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "MultiPoint", "coordinates": [[2, 1], [], [3, 1]]}}]})",
                    "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->polygons.size(), 4u);
  EXPECT_EQ(input->polygons[0].material, "Si");
  EXPECT_EQ(input->polygons[1].region, "bulk");
  EXPECT_EQ(input->polygons[1].priority, 2);
  EXPECT_EQ(input->polygons[1].rings[0][0], (Point{5, 0}));
  EXPECT_EQ(input->polygons[2].material, "4");
  EXPECT_EQ(input->polygons[2].rings.size(), 2u);
  EXPECT_EQ(input->polygons[3].material, "feature_2");
  ASSERT_EQ(input->lines.size(), 1u);
  EXPECT_EQ(input->lines[0].name, "bulk");
  EXPECT_EQ(input->points, (std::vector<Point>{{1, 1}, {2, 1}, {3, 1}}));
  EXPECT_EQ(
      input->warnings,
      (std::vector<std::string>{"2 geometries are null or empty: left out",
                                "3 points are not in the plane: z is dropped",
                                "the property 'size' of 1 point is left out: it is one of areas"}));
}

TEST(ReadGeojson, PointsHaveNames) {
  const Result<Input> input = parse_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"type": "Feature", "properties": {"name": "well1"}, "geometry":
      {"type": "Point", "coordinates": [1, 1]}},
    {"type": "Feature", "properties": {"name": 7}, "geometry":
      {"type": "MultiPoint", "coordinates": [[2, 1], [], [3, 1]]}}]})",
                                            "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->point_names.size(), 3u);
  EXPECT_EQ(input->point_names[0].point, 1u);
  EXPECT_EQ(input->point_names[0].name, "well1");
  EXPECT_EQ(input->point_names[2].point, 3u);
  EXPECT_EQ(input->point_names[2].name, "7");
}

TEST(ReadGeojson, WarnsOfPropertiesThatDifferInCapitals) {
  const auto warnings = [](const char* properties, const ReadOptions& options = {}) {
    const Result<Input> input = parse_geojson(
        std::string(R"({"type": "Feature", "properties": )") + properties +
            R"(, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [500, 0], [0, 9], [0, 0]]]}})",
        "map.geojson", options);
    EXPECT_TRUE(input.has_value()) << input.error().message;
    return input->warnings;
  };
  using Warnings = std::vector<std::string>;
  EXPECT_EQ(warnings(R"({"Material": "Si", "SIZE": 2, "Sizes": 3})"),
            (Warnings{"no feature has the property 'material', and 'Material' with capitals counts "
                      "for nothing: --material-field Material takes it",
                      "no feature has the property 'size', and 'SIZE' with capitals counts for "
                      "nothing"}));
  EXPECT_EQ(warnings(R"({"material": "Si", "Material": "Ge"})"), Warnings{});
  EXPECT_EQ(warnings(R"({"name": null, "NAME": "x"})"),
            (Warnings{"the property 'name' is null in every feature, and 'NAME' with capitals "
                      "counts for nothing: --name-field NAME takes it"}));
  EXPECT_EQ(warnings(R"({"material": "Si", "NAME": "x"})"), Warnings{});  // it needs no name
  ReadOptions options;
  options.material_field = "Material";
  options.keep_fields = {"NAME"};
  EXPECT_EQ(warnings(R"({"Material": "Si", "NAME": "a"})", options), Warnings{});
}

TEST(ReadGeojson, TakesNumbersForNamesAndEmptyCoordinatesForNull) {
  const Result<Input> input = parse_geojson(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": 12.5}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}},
    {"type": "Feature", "properties": {"name": true, "material": false}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": []}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": []}}]})",
                                            "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->polygons.size(), 2u);
  EXPECT_EQ(input->polygons[0].material, "12.5");
  EXPECT_EQ(input->polygons[1].region, "true");
  EXPECT_EQ(input->polygons[1].material, "false");
  EXPECT_TRUE(input->lines.empty());
  EXPECT_EQ(input->warnings[0], "2 geometries are null or empty: left out");
}

TEST(ReadGeojson, NullAndEmptyGeometriesAreCounted) {
  const auto told = [](const std::string& geometry) {
    const Result<Input> input = parse_geojson(
        R"({"type": "FeatureCollection", "crs": null, "features": [
          {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 1]}},
          {"type": "Feature", "geometry": )" +
            geometry + "}]}",
        "map.geojson");
    EXPECT_TRUE(input.has_value()) << input.error().message;
    return input ? input->warnings : std::vector<std::string>{"refused"};
  };
  const std::vector<std::string> one{"1 geometry is null or empty: left out"};
  EXPECT_EQ(told("null"), one);
  for (const char* type :
       {"Point", "LineString", "Polygon", "MultiPoint", "MultiLineString", "MultiPolygon"})
    EXPECT_EQ(told(std::string(R"({"type": ")") + type + R"(", "coordinates": []})"), one) << type;
  EXPECT_EQ(told(R"({"type": "GeometryCollection", "geometries": []})"), one);
  EXPECT_EQ(told(R"({"type": "MultiPoint", "coordinates": [[3, 3], []]})"), one);
  EXPECT_TRUE(told(R"({"type": "Point", "coordinates": [2, 2]})").empty());
}

TEST(ReadGeojson, HeightsAreDroppedAndTold) {
  const auto told = [](const char* line) {
    const Result<Input> input = parse_geojson(
        std::string(R"({"type": "LineString", "crs": null, "coordinates": )") + line + "}",
        "map.geojson");
    EXPECT_TRUE(input.has_value()) << input.error().message;
    return input ? input->warnings : std::vector<std::string>{"refused"};
  };
  EXPECT_EQ(told("[[0, 0, 5], [1, 0, 0], [2, 0, -3.5]]"),
            std::vector<std::string>{"2 points are not in the plane: z is dropped"});
  EXPECT_EQ(told("[[0, 0, 1], [1, 0]]"),
            std::vector<std::string>{"1 point is not in the plane: z is dropped"});
  EXPECT_TRUE(told("[[0, 0, 0], [1, 0, 0]]").empty());
}

TEST(ReadGeojson, PropertiesAreKnownByName) {
  const Result<Input> input = parse_geojson(
      R"({"type": "FeatureCollection", "crs": null, "features": [
        {"type": "Feature", "properties": {"USE": "wood", "AREA": 3}, "geometry":
          {"type": "Point", "coordinates": [1, 1]}},
        {"type": "Feature", "properties": {"USE": "field"}, "geometry":
          {"type": "Point", "coordinates": [2, 1]}}]})",
      "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->fields, (std::vector<std::string>{"AREA", "USE"}));
}

TEST(ReadGeojson, SizesAreLengthsAboveZero) {
  const auto feature = [](const std::string& size) {
    return R"({"type": "Feature", "properties": {"size": )" + size + R"(}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})";
  };
  const Result<Input> input = parse_geojson(
      R"({"type": "FeatureCollection", "crs": null, "features": [)" + feature("0.25") + "," +
          feature("0") + "," + feature("\"XL\"") + "," + feature("null") + "]}",
      "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->polygons.size(), 4u);
  EXPECT_EQ(input->polygons[0].size, 0.25);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_FALSE(input->polygons[k].size) << k;
  EXPECT_EQ(input->warnings,
            std::vector<std::string>{"the property 'size' of 2 features is no length above 0: left "
                                     "out, the first of feature 1"});
}

TEST(ReadGeojson, NumbersMayBeWrittenAsText) {
  const Result<Input> input = parse_geojson(
      R"({"type": "Feature", "crs": null, "properties": {"size": " 0.5", "priority": "7"}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})",
      "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->polygons[0].size, 0.5);
  EXPECT_EQ(input->polygons[0].priority, 7);
  EXPECT_EQ(input->warnings, std::vector<std::string>{});
}

TEST(ReadGeojson, AMaterialCalledVoidIsTold) {
  const auto feature = [](const std::string& material) {
    return R"({"type": "Feature", "properties": {"material": ")" + material + R"("}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})";
  };
  const Result<Input> input =
      parse_geojson(R"({"type": "FeatureCollection", "crs": null, "features": [)" +
                        feature("Void") + "," + feature("voids") + "]}",
                    "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->polygons.size(), 2u);
  EXPECT_EQ(input->warnings,
            std::vector<std::string>{"in a map 'void' is a material like others, here of 1 "
                                     "polygon: what is to be left out has to be an inner ring of "
                                     "what is around it"});
}

TEST(ReadGeojson, OneOfSeveralMayBeEmpty) {
  const char* const text = R"({"type": "FeatureCollection", "features": []})";
  EXPECT_FALSE(parse_geojson(text, "map.geojson"));
  ReadOptions options;
  options.is_one_of_several = true;
  EXPECT_TRUE(parse_geojson(text, "map.geojson", options));
}

TEST(ReadGeojson, ASizeOfALineIsTold) {
  const Result<Input> input = parse_geojson(
      R"({"type": "Feature", "crs": null, "properties": {"size": 1}, "geometry":
      {"type": "LineString", "coordinates": [[0, 0], [1, 0]]}})",
      "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->warnings,
            std::vector<std::string>{"the property 'size' of 1 line is left out: it is one of "
                                     "areas; along a line, --size-at NAME=... asks for sizes"});
}

TEST(ReadGeojson, AnArrayOfAnotherNameIsTold) {
  ReadOptions options;
  options.keep_fields = {"RegionId"};
  const Result<Input> input = parse_geojson(
      R"({"type": "Feature", "crs": null, "properties": {"RegionId": 3}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})",
      "map.geojson", options);
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->warnings.size(), 1U);
  EXPECT_EQ(input->warnings[0].find("the attribute 'RegionId' is the array 'RegionId_2'"), 0U);
  options.keep_fields = {"q\"<"};
  const Result<Input> odd = parse_geojson(
      R"({"type": "Feature", "crs": null, "properties": {"q\"<": 3}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})",
      "map.geojson", options);
  ASSERT_TRUE(odd.has_value()) << odd.error().message;
  EXPECT_EQ(odd->warnings,
            std::vector<std::string>{"the attribute 'q\"<' is the array 'q_<' of mesh "
                                     "files: not every name can be that of an "
                                     "array"});
}

ReadOptions keeping(std::vector<std::string> fields) {
  ReadOptions options;
  options.keep_fields = std::move(fields);
  return options;
}

TEST(ReadGeojson, PropertiesAreKept) {
  const auto feature = [](const std::string& id, const std::string& properties) {
    return R"({"type": "Feature", )" + id + R"("properties": )" + properties +
           R"(, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})";
  };
  const std::string map =
      R"({"type": "FeatureCollection", "features": [)" +
      feature("\"id\": 17, ", R"({"use": "field", "height": 2.5, "tags": ["a"]})") + "," +
      feature("", R"({"use": null, "open": true})") + "," + feature("", "null") + "]}";
  const Result<Input> input =
      parse_geojson(map, "map.geojson", keeping({"use", "height", "fid", "tags", "open"}));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->attributes.size(), 5U);
  EXPECT_EQ(input->attributes[0].words, std::vector<std::string>{"field"});
  EXPECT_EQ(input->attributes[0].values, (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(input->attributes[1].values[0], 2.5);
  EXPECT_EQ(input->attributes[2].values, (std::vector<double>{17, 1, 2}));
  EXPECT_EQ(input->attributes[3].words, std::vector<std::string>{"[\"a\"]"});
  EXPECT_EQ(input->attributes[4].words, std::vector<std::string>{"true"});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(input->polygons[k].feature, k + 1);

  const Result<Input> missing = parse_geojson(map, "map.geojson", keeping({"usage"}));
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::bad_option);
  EXPECT_EQ(missing.error().message,
            "map.geojson: keep_field: no feature has the property 'usage'");
}

TEST(ReadGeojson, APropertyWithoutValuesIsNoMisspeltOne) {
  const Result<Input> input =
      parse_geojson(R"({"type": "Feature", "properties": {"soil": null}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})",
                    "map.geojson", keeping({"soil"}));
  ASSERT_FALSE(input.has_value());
  EXPECT_EQ(input.error().message,
            "map.geojson: keep_field: the property 'soil' is null in every feature");
}

TEST(ReadGeojson, KeptTextsAndPlacesAreTold) {
  const std::string area =
      R"("geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})";
  const std::string map =
      R"({"type": "FeatureCollection", "crs": null, "features": [
      {"type": "Feature", "properties": {"K": 1e-4, "use": 3, "por": "0.2", "code": "01"}, )" +
      area + R"(, {"type": "Feature", "properties": {"K": "1e-5", "use": "wood"}, )" + area +
      R"(, {"type": "Feature", "properties": {"Q": 2, "K": 7},
          "geometry": {"type": "Point", "coordinates": [0.5, 0.25]}}]})";
  const Result<Input> input =
      parse_geojson(map, "map.geojson", keeping({"K", "use", "por", "code"}));
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->attributes[0].values, (std::vector<double>{1e-4, 1e-5, 7}));
  ASSERT_EQ(input->warnings.size(), 2U);
  EXPECT_NE(input->warnings[0].find("'use' is a number in some features, as 3 in feature 0, and a "
                                    "word in others, as 'wood' in feature 1"),
            std::string::npos);
  EXPECT_NE(input->warnings[1].find("'por' is text wherever it is, as '0.2'"), std::string::npos);

  const Result<Input> of_points = parse_geojson(map, "map.geojson", keeping({"K", "Q"}));
  ASSERT_FALSE(of_points.has_value());
  EXPECT_EQ(of_points.error().message,
            "map.geojson: keep_field: only points have the property 'Q', the first of them feature "
            "2: an array of a mesh holds what areas have");
  // Another file may have areas with it.
  ReadOptions several = keeping({"Q"});
  several.is_one_of_several = true;
  const Result<Input> part = parse_geojson(map, "map.geojson", several);
  ASSERT_TRUE(part.has_value()) << part.error().message;
  EXPECT_FALSE(part->asked.at(0).is_there);
}

TEST(ReadGeojson, DegreesAreToldWhereTheFileSaysSo) {
  const auto warnings = [](const std::string& crs) {
    return parse_geojson(R"({"type": "Polygon", )" + crs +
                             R"("coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]})",
                         "map.geojson")
        ->warnings;
  };
  const auto named = [](const std::string& name) {
    return R"("crs": {"type": "name", "properties": {"name": ")" + name + R"("}}, )";
  };
  EXPECT_TRUE(warnings(R"("crs": null, )").empty());
  EXPECT_TRUE(warnings(named("urn:ogc:def:crs:EPSG::25832")).empty());
  for (const char* name : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"}) {
    ASSERT_EQ(warnings(named(name)).size(), 1U) << name;
    EXPECT_NE(warnings(named(name))[0].find("longitudes and latitudes"), std::string::npos);
  }
}

TEST(ReadGeojson, DegreesThatAreNoneAreTold) {
  const auto warnings = [](const std::string& corner) {
    return parse_geojson(R"({"type": "Polygon",
                             "crs": {"type": "name", "properties": {"name": "EPSG:4326"}},
                             "coordinates": [[[0, 0], [1, 0], )" +
                             corner + ", [0, 0]]]}",
                         "map.geojson")
        ->warnings;
  };
  EXPECT_EQ(warnings("[3500000, 1]"),
            std::vector<std::string>{
                "coordinates should be longitudes and latitudes, as the file says, but they reach "
                "from (0, 0) to (3500000, 1): if they are those of a plane already, 'ogr2ogr "
                "-a_srs EPSG:... OUT.geojson map.geojson' makes a file that says of which system"});
  EXPECT_EQ(warnings("[1, 91]")[0].find("coordinates should be"), 0U);
  EXPECT_EQ(warnings("[360, 90]")[0].find("coordinates are longitudes and latitudes:"), 0U);
}

TEST(ReadGeojson, DegreesAreToldWhereNothingIsSaidThatSpeaksAgainstThem) {
  const auto warnings = [](const std::string& corner, const ReadOptions& options = {}) {
    return parse_geojson(
               R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], )" + corner + ", [0, 0]]]}",
               "map.geojson", options)
        ->warnings;
  };
  ASSERT_EQ(warnings("[180, 90]").size(), 1U);
  EXPECT_EQ(warnings("[180, 90]")[0].find("no coordinate system is said, so by RFC 7946"), 0U);
  EXPECT_TRUE(warnings("[181, 1]").empty());
  EXPECT_TRUE(warnings("[1, 91]").empty());
  ReadOptions micrometres;
  micrometres.unit = "um";
  EXPECT_TRUE(warnings("[1, 1]", micrometres).empty());
}

TEST(ReadGeojson, TheSystemIsKept) {
  const auto system = [](const std::string& crs) {
    return parse_geojson(R"({"type": "Polygon", "crs": )" + crs +
                             R"(, "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]})",
                         "map.geojson")
        ->system;
  };
  EXPECT_EQ(system(R"({"properties": {"name": "urn:ogc:def:crs:EPSG::25832"}})"), "EPSG:25832");
  EXPECT_EQ(system(R"({"properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}})"), "EPSG:4326");
  EXPECT_EQ(system(R"({"properties": {"name": 4}})"), "");
  EXPECT_EQ(system("null"), "");
}

TEST(ReadGeojson, OneOfSeveralNeedNotHaveWhatIsAsked) {
  ReadOptions options = keeping({"use"});
  options.material_field = "soil";
  options.is_one_of_several = true;
  const Result<Input> input =
      parse_geojson(R"({"type": "Feature", "crs": null, "properties": {"use": "lake"}, "geometry":
      {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})",
                    "map.geojson", options);
  ASSERT_TRUE(input.has_value()) << input.error().message;
  ASSERT_EQ(input->asked.size(), 2U);
  EXPECT_EQ(input->asked[0].option, "material_field");
  EXPECT_FALSE(input->asked[0].is_there);
  EXPECT_EQ(input->asked[0].missing, "no feature has the property 'soil'");
  EXPECT_TRUE(input->asked[1].is_there);
}

TEST(ReadGeojson, ReadsABareGeometry) {
  const Result<Input> input = parse_geojson(
      R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]})", "map.geojson");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->polygons[0].material, "feature_0");
}

TEST(ReadGeojson, IsKnownByItsTypeInAJsonFile) {
  const std::string_view square =
      R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]})";
  const Result<Input> input = parse_json(square, "map.json");
  ASSERT_TRUE(input.has_value()) << input.error().message;
  EXPECT_EQ(input->polygons.size(), 1u);
  EXPECT_EQ(
      parse_json(R"({"type": "Topology"})", "map.json").error().message,
      "map.json: the type \"Topology\" is not one of GeoJSON: ogr2ogr makes that of TopoJSON");
  EXPECT_EQ(parse_json(R"({"type": "Box"})", "map.json").error().message,
            "map.json: the type \"Box\" is not one of GeoJSON");
}

TEST(ReadGeojson, PropertiesAreChosenWhateverTheFileIsCalled) {
  const std::string map = R"({"type": "FeatureCollection", "crs": null, "features": [
      {"type": "Feature", "properties": {"use": "field", "nr": 7, "rank": 3, "material": "x"},
       "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}},
      {"type": "Feature", "properties": {"use": null},
       "geometry": {"type": "Polygon", "coordinates": [[[2, 0], [3, 0], [3, 1], [2, 0]]]}}]})";
  ReadOptions options = keeping({"use"});
  options.material_field = "use";
  options.name_field = "nr";
  options.priority_field = "rank";
  for (const bool is_json : {false, true}) {
    SCOPED_TRACE(is_json);
    const auto parse = [&] {
      return is_json ? parse_json(map, "map.json", options)
                     : parse_geojson(map, "map.geojson", options);
    };
    const Result<Input> input = parse();
    ASSERT_TRUE(input.has_value()) << input.error().message;
    ASSERT_EQ(input->polygons.size(), 2U);
    EXPECT_EQ(input->polygons[0].material, "field");
    EXPECT_EQ(input->polygons[0].region, "7");
    EXPECT_EQ(input->polygons[0].priority, 3.0);
    EXPECT_EQ(input->polygons[1].material, "feature_1");
    ASSERT_EQ(input->attributes.size(), 1U);
    EXPECT_EQ(input->attributes[0].values, (std::vector<double>{1, 0}));
    EXPECT_TRUE(input->warnings.empty());
    options.name_field = "number";
    const Result<Input> missing = parse();
    ASSERT_FALSE(missing.has_value());
    EXPECT_EQ(missing.error().code, ErrorCode::bad_option);
    EXPECT_NE(missing.error().message.find("name_field: no feature has the property 'number'"),
              std::string::npos);
    options.name_field = "nr";
  }
  const Result<Input> drawing =
      parse_json(R"({"polygons": [{"material": "Si", "rings": [[[0, 0], [1, 0], [0, 1]]]}]})",
                 "d.json", options);
  ASSERT_TRUE(drawing.has_value()) << drawing.error().message;
  EXPECT_EQ(drawing->warnings.size(), 4U);
}

TEST(ReadGeojson, NamesThePlaceOfEveryError) {
  EXPECT_EQ(geojson_message(R"({"type": "Polygo", "coordinates": []})"),
            "map.geojson: the type \"Polygo\" is not one of GeoJSON");
  EXPECT_EQ(
      geojson_message(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry":
                        {"type": "Polygon", "coordinates": [[[0, 0], [1]]]}}]})"),
      "map.geojson: features[0].geometry.coordinates[0][1]: expected a point [x, y], found 1 "
      "number");
  EXPECT_EQ(geojson_message(R"({"features": []})"), "map.geojson: the key \"type\" is missing");
  EXPECT_EQ(geojson_message(R"({"type": "FeatureCollection", "features": []})"),
            "map.geojson: no Polygon, MultiPolygon, LineString or Point in it");
  EXPECT_EQ(geojson_message("7"), "map.geojson: expected a GeoJSON object");
}

}  // namespace
}  // namespace cover
