// Features are read one after the other and become polygons and lines at once.
// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include <cover/read_gdal.hpp>

#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cover/units.hpp>

#include "gdal/map_projection.hpp"
#include "gdal/quiet_gdal.hpp"

namespace cover {
namespace {

/// Only these are tried: others would open whatever looks like theirs.
constexpr const char* kDrivers[] = {"ESRI Shapefile", "GPKG", "FlatGeobuf", "GML",
                                    "LIBKML",         "KML",  "GeoJSON",    nullptr};

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    RegisterOGRShape();
    RegisterOGRGeoPackage();
    RegisterOGRFlatGeobuf();
    RegisterOGRGML();
    RegisterOGRLIBKML();
    RegisterOGRKML();
    RegisterOGRGeoJSON();
  });
}

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Dataset open_dataset(const std::string& path) {
  // Those of GML: neither a file beside the input nor a schema from the network.
  const char* const gml[] = {"WRITE_GFS=NO", "DOWNLOAD_SCHEMA=NO", nullptr};
  const bool is_gml = std::filesystem::path(path).extension() == ".gml";
  return Dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, kDrivers,
                                   is_gml ? gml : nullptr, nullptr));
}

/// What a feature says of its geometry.
struct FeatureWords {
  std::string material;
  std::string name;
  std::optional<double> priority;
};

class MapReader {
 public:
  MapReader(const std::string& path, const ReadOptions& options) : options_(options) {
    input_.source = path;
  }

  Result<Input> read() {
    const Dataset dataset = open_dataset(input_.source);
    if (!dataset) return failed(quiet_.failure().empty() ? "no map in it" : quiet_.failure());
    quiet_.forget();
    const std::vector<OGRLayer*> layers = choose(*dataset);
    for (OGRLayer* layer : layers) {
      if (!error_) read_layer(*layer);
    }
    if (!error_ && input_.polygons.empty() && input_.lines.empty())
      fail(ErrorCode::syntax, "no polygon or line in it");
    if (error_) return *std::move(error_);
    tell();
    return std::move(input_);
  }

 private:
  Error failed(const std::string& what) const {
    return {ErrorCode::syntax, fmt::format("{}: GDAL: {}", input_.source, what), {}, {}};
  }
  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}: {}", input_.source, what), {}, {}};
  }
  /// Turns what GDAL complained of into an error.
  void note_failure() {
    if (!error_ && !quiet_.failure().empty()) error_ = failed(quiet_.failure());
  }

  std::vector<OGRLayer*> choose(GDALDataset& dataset) {
    std::vector<OGRLayer*> all, chosen;
    std::vector<std::string> names;
    for (int k = 0; k < dataset.GetLayerCount(); ++k) {
      OGRLayer* layer = dataset.GetLayer(k);
      if (layer->GetGeomType() == wkbNone) continue;
      all.push_back(layer);
      names.emplace_back(layer->GetName());
      if (std::find(options_.layers.begin(), options_.layers.end(), names.back()) !=
          options_.layers.end())
        chosen.push_back(layer);
    }
    constexpr std::size_t kMostNamed = 12;
    const std::size_t count = names.size();
    if (count > kMostNamed) names.resize(kMostNamed);
    const std::string known =
        fmt::format("{}{}", fmt::join(names, ", "), count > kMostNamed ? ", ..." : "");
    if (options_.layers.empty() && count > 1)
      fail(ErrorCode::bad_option,
           fmt::format("it has {} layers ({}): name those to be read by --layer", count, known));
    for (const std::string& wanted : options_.layers) {
      const bool there = std::any_of(chosen.begin(), chosen.end(),
                                     [&](OGRLayer* layer) { return wanted == layer->GetName(); });
      if (!there)
        fail(ErrorCode::bad_option,
             fmt::format("there is no layer '{}'; its layers: {}", wanted, known));
    }
    return options_.layers.empty() ? all : chosen;
  }

  /// The number of an attribute, or -1. One that an option names has to be there.
  int field_of(OGRLayer& layer, const std::string& wanted, const char* usual, const char* option) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    const int field = definition.GetFieldIndex(wanted.empty() ? usual : wanted.c_str());
    if (field >= 0 || wanted.empty()) return field;
    std::vector<std::string> names;
    for (int k = 0; k < definition.GetFieldCount(); ++k)
      names.emplace_back(definition.GetFieldDefn(k)->GetNameRef());
    fail(ErrorCode::bad_option,
         fmt::format("{}: the layer '{}' has no attribute '{}'; its attributes: {}", option,
                     layer.GetName(), wanted, fmt::join(names, ", ")));
    return -1;
  }

  void read_layer(OGRLayer& layer) {
    material_ = field_of(layer, options_.material_field, "material", "material_field");
    name_ = field_of(layer, options_.name_field, "name", "name_field");
    priority_ = field_of(layer, options_.priority_field, "priority", "priority_field");
    Result<MapProjection> projection = projection_of(layer.GetSpatialRef(), options_.crs);
    if (!projection) {
      if (!error_) error_ = std::move(projection).error();
      return;
    }
    projection_ = std::move(*projection);
    degrees_ |= projection_.degrees;
    if (!projection_.unit.empty()) input_.unit = projection_.unit;
    quiet_.forget();
    layer.ResetReading();
    while (!error_) {
      const OGRFeatureUniquePtr feature(layer.GetNextFeature());
      note_failure();
      if (!feature) break;
      read_feature(*feature);
    }
  }

  /// The text of an attribute as GeoJSON would have it; empty if there is none.
  static std::string text_of(const OGRFeature& feature, int field) {
    if (field < 0 || feature.IsFieldSetAndNotNull(field) == 0) return "";
    if (feature.GetFieldDefnRef(field)->GetType() != OFTReal)
      return const_cast<OGRFeature&>(feature).GetFieldAsString(field);
    std::string text = fmt::format("{}", feature.GetFieldAsDouble(field));
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  }

  FeatureWords words_of(const OGRFeature& feature) {
    FeatureWords words;
    words.material = text_of(feature, material_);
    words.name = text_of(feature, name_);
    if (priority_ >= 0 && feature.IsFieldSetAndNotNull(priority_) != 0)
      words.priority = feature.GetFieldAsDouble(priority_);
    if (words.priority && !std::isfinite(*words.priority))
      fail(ErrorCode::syntax,
           fmt::format("feature {}: the priority is no number", feature.GetFID()));
    if (words.material.empty())
      words.material = words.name.empty() ? fmt::format("feature_{}", features_) : words.name;
    return words;
  }

  void read_feature(OGRFeature& feature) {
    words_ = words_of(feature);
    fid_ = feature.GetFID();
    ++features_;
    OGRGeometryUniquePtr geometry(feature.StealGeometry());
    if (!geometry) return;
    if (geometry->hasCurveGeometry() != 0)
      geometry.reset(geometry->getLinearGeometry(options_.chord_angle));
    if (!geometry) return fail(ErrorCode::syntax, fmt::format("feature {}: a broken curve", fid_));
    read_geometry(*geometry);
  }

  void read_geometry(const OGRGeometry& geometry) {
    switch (wkbFlatten(geometry.getGeometryType())) {
      case wkbPolygon:
      case wkbTriangle:
        return add_polygon(*geometry.toPolygon());
      case wkbLineString:
        return add_line(*geometry.toLineString());
      case wkbMultiPolygon:
      case wkbMultiLineString:
      case wkbGeometryCollection:
        for (const OGRGeometry* part : *geometry.toGeometryCollection())
          if (!error_) read_geometry(*part);
        return;
      case wkbPoint:
      case wkbMultiPoint:
        ++points_;
        return;
      default:
        ++others_;
    }
  }

  std::vector<Point> points_of(const OGRSimpleCurve& curve) {
    const auto n = static_cast<std::size_t>(curve.getNumPoints());
    std::vector<double> x(n), y(n);
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = curve.getX(static_cast<int>(k));
      y[k] = curve.getY(static_cast<int>(k));
    }
    if (projection_.transform)
      projection_.transform->Transform(static_cast<int>(n), x.data(), y.data());
    std::vector<Point> points(n);
    for (std::size_t k = 0; k < n; ++k) {
      if (!std::isfinite(x[k]) || !std::isfinite(y[k])) {
        const int place = static_cast<int>(k);
        fail(ErrorCode::non_finite_coordinate,
             projection_.transform
                 ? fmt::format("feature {}: ({}, {}) is not where {} reaches", fid_,
                               curve.getX(place), curve.getY(place), options_.crs)
                 : fmt::format("feature {}: a coordinate is not finite", fid_));
        break;
      }
      points[k] = {x[k], y[k]};
    }
    quiet_.forget();  // PROJ's own words on the same
    return points;
  }

  void add_polygon(const OGRPolygon& polygon) {
    if (polygon.IsEmpty() != 0) return;
    InputPolygon out;
    for (const OGRLinearRing* ring : polygon) out.rings.push_back(points_of(*ring));
    out.material = words_.material;
    out.region = words_.name;
    out.priority = words_.priority;
    out.id = static_cast<long>(input_.polygons.size());
    input_.polygons.push_back(std::move(out));
  }

  void add_line(const OGRLineString& line) {
    if (line.IsEmpty() != 0) return;
    InputLine out{words_.name, points_of(line), static_cast<long>(input_.lines.size())};
    if (out.points.size() < 2)
      return fail(ErrorCode::syntax,
                  fmt::format("feature {}: a line needs two points or more", fid_));
    input_.lines.push_back(std::move(out));
  }

  void tell() {
    if (points_ > 0)
      input_.warnings.push_back(points_ == 1
                                    ? std::string("1 geometry is a point: left out")
                                    : fmt::format("{} geometries are points: left out", points_));
    if (others_ > 0)
      input_.warnings.push_back(
          fmt::format("{} geometries are surfaces in space: left out", others_));
    if (degrees_)
      input_.warnings.emplace_back(
          "coordinates are longitudes and latitudes: lengths and angles are those of a plane of "
          "degrees; --crs EPSG:... projects them");
  }

  const ReadOptions& options_;
  QuietGdal quiet_;
  Input input_;
  MapProjection projection_;
  int material_ = -1, name_ = -1, priority_ = -1;  ///< numbers of attributes
  FeatureWords words_;
  GIntBig fid_ = 0;
  long features_ = 0;
  std::size_t points_ = 0, others_ = 0;
  bool degrees_ = false;
  std::optional<Error> error_;
};

}  // namespace

bool is_map(std::string_view extension) {
  constexpr std::array<std::string_view, 5> kMaps{".shp", ".gpkg", ".fgb", ".gml", ".kml"};
  return std::find(kMaps.begin(), kMaps.end(), extension) != kMaps.end();
}

Result<Input> read_gdal(const std::string& path, const ReadOptions& options) {
  if (const Status status = check_read_options(options); !status) return status.error();
  std::error_code ignored;
  // GDAL knows names that are no files: those of archives, servers, databases.
  if (!std::filesystem::is_regular_file(path, ignored))
    return Error{ErrorCode::cannot_open, fmt::format("cannot open {}: no such file", path), {}, {}};
  register_drivers();
  Result<Input> input = MapReader(path, options).read();
  if (!input) return input;
  if (Status status = apply_units(*input, options); !status) return std::move(status).error();
  return input;
}

}  // namespace cover
