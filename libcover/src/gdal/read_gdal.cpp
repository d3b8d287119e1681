// Features are read one after the other and become polygons, lines and points at once.
// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include <cover/files.hpp>
#include <cover/read_gdal.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include <cover/text.hpp>
#include <cover/units.hpp>

#include "base/faults/out_of_memory.hpp"
#include "gdal/gdal_library.hpp"
#include "gdal/map_projection.hpp"
#include "gdal/quiet_gdal.hpp"
#include "io/input/attribute_table.hpp"
#include "io/input/coordinate_systems.hpp"
#include "io/input/map_words.hpp"

namespace cover {
namespace {

/// Only these are tried: others would open whatever looks like theirs.
constexpr const char* kDrivers[] = {"ESRI Shapefile", "GPKG", "FlatGeobuf", "GML",
                                    "LIBKML",         "KML",  "GeoJSON",    nullptr};

using Dataset = GdalHandle<&GdalLibrary::GDALClose>;
using Feature = GdalHandle<&GdalLibrary::OGR_F_Destroy>;
using Geometry = GdalHandle<&GdalLibrary::OGR_G_DestroyGeometry>;

Dataset open_dataset(const GdalLibrary& gdal, const std::string& path) {
  // Those of GML: neither a file beside the input nor a schema from the network.
  const char* const gml[] = {"WRITE_GFS=NO", "DOWNLOAD_SCHEMA=NO", nullptr};
  const bool is_gml = extension_of(path) == ".gml";
  return Dataset(gdal.GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, kDrivers,
                                 is_gml ? gml : nullptr, nullptr));
}

/// What a feature says of its geometry.
struct FeatureWords {
  std::string material;
  std::string name;
  std::optional<double> priority;
  std::optional<double> size;
  bool is_void = false;  ///< by the word that drawings have for it
};

class MapReader {
 public:
  MapReader(const GdalLibrary& gdal, const std::string& path, const ReadOptions& options)
      : gdal_(gdal), options_(options), attributes_(options.keep_fields) {
    input_.source = path;
  }

  Result<Input> read() {
    const Dataset dataset = open_dataset(gdal_, input_.source);
    if (!dataset) return failed(quiet_.failure().empty() ? "no map in it" : quiet_.failure());
    note_unknown_system();
    note_missing_table();
    quiet_.forget();
    const std::vector<OGRLayerH> layers = choose(dataset.get());
    for (OGRLayerH layer : layers) {
      if (!error_) read_layer(layer);
    }
    note_beside_areas();
    if (!error_) error_ = asked_.settle(options_, input_);
    if (!error_ && !options_.is_one_of_several && input_.polygons.empty() && input_.lines.empty() &&
        input_.points.empty())
      fail(ErrorCode::syntax, "no polygon, line or point in it");
    if (error_) return *std::move(error_);
    tell();
    input_.attributes = attributes_.attributes();
    attributes_.tell_mixed(input_.warnings);
    if (!options_.is_one_of_several) tell_spelled_numbers(input_.attributes, input_.warnings);
    tell_renamed(input_.attributes, input_.warnings);
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

  /// Where PROJ does not know the system that a file names, GDAL takes another one for it.
  void note_unknown_system() {
    const std::string said = quiet_.failure();
    if (!said.starts_with("PROJ")) return;
    if (!options_.crs.empty())
      return fail(
          ErrorCode::syntax,
          "the system of its coordinates is not known, so they cannot be projected: " + said);
    input_.warnings.push_back("the system of the file's coordinates is not known: " + said);
  }

  /// A .shp keeps names and materials in a file of its own.
  void note_missing_table() {
    if (extension_of(input_.source) != ".shp") return;
    const auto is_there = [&](const char* extension) {
      std::error_code ignored;
      return std::filesystem::exists(
          std::filesystem::path(input_.source).replace_extension(extension), ignored);
    };
    if (!is_there(".dbf") && !is_there(".DBF"))
      input_.warnings.emplace_back(
          "no .dbf is beside the .shp: features have no names and materials");
  }

  std::vector<OGRLayerH> choose(GDALDatasetH dataset) {
    std::vector<OGRLayerH> all, chosen;
    std::vector<std::string> names;
    for (int k = 0; k < gdal_.GDALDatasetGetLayerCount(dataset); ++k) {
      OGRLayerH layer = gdal_.GDALDatasetGetLayer(dataset, k);
      if (gdal_.OGR_L_GetGeomType(layer) == wkbNone) continue;
      all.push_back(layer);
      names.emplace_back(gdal_.OGR_L_GetName(layer));
      if (std::find(options_.layers.begin(), options_.layers.end(), names.back()) !=
          options_.layers.end())
        chosen.push_back(layer);
    }
    constexpr std::size_t kMostNamed = 12;
    const std::size_t count = names.size();
    if (count > kMostNamed) names.resize(kMostNamed);
    const std::string known = fmt::format("{}{}", listed(names), count > kMostNamed ? ", ..." : "");
    for (const std::string& wanted : options_.layers) {
      const bool there = std::any_of(chosen.begin(), chosen.end(), [&](OGRLayerH layer) {
        return wanted == gdal_.OGR_L_GetName(layer);
      });
      const std::string missing =
          fmt::format("there is no layer '{}'; its layers: {}", wanted, known);
      asked_.note("layer", wanted, there, missing);
      if (!there && !options_.is_one_of_several) fail(ErrorCode::bad_option, missing);
    }
    // Of several files, those with one layer are meant as a whole, whichever others are chosen.
    const bool is_whole = options_.layers.empty() || (options_.is_one_of_several && chosen.empty());
    if (is_whole && count > 1)
      fail(
          ErrorCode::bad_option,
          options_.layers.empty()
              ? fmt::format("it has {} layers ({}): name those to be read by --layer", count, known)
              : fmt::format("--layer names none of its layers: {}", known));
    return is_whole ? all : chosen;
  }

  /// The number of an attribute, or -1. One that an option names has to be in some layer: rivers
  /// have no land use.
  int field_of(OGRLayerH layer, const std::string& wanted, const char* usual, const char* option) {
    OGRFeatureDefnH definition = gdal_.OGR_L_GetLayerDefn(layer);
    const int field =
        gdal_.OGR_FD_GetFieldIndex(definition, wanted.empty() ? usual : wanted.c_str());
    if (wanted.empty()) return field;
    std::vector<std::string> names;
    for (int k = 0; k < gdal_.OGR_FD_GetFieldCount(definition); ++k)
      names.emplace_back(gdal_.OGR_Fld_GetNameRef(gdal_.OGR_FD_GetFieldDefn(definition, k)));
    asked_.note(option, wanted, field >= 0,
                fmt::format("the layer '{}' has no attribute '{}'; its attributes: {}",
                            gdal_.OGR_L_GetName(layer), wanted, listed(names)));
    return field;
  }

  /// Whether a name means the number that every feature has, and no attribute.
  bool is_feature_id(OGRLayerH layer, const std::string& name) {
    return name == kFeatureId &&
           gdal_.OGR_FD_GetFieldIndex(gdal_.OGR_L_GetLayerDefn(layer), kFeatureId) < 0;
  }

  void read_layer(OGRLayerH layer) {
    material_ = field_of(layer, options_.material_field, "material", "material_field");
    name_ = field_of(layer, options_.name_field, "name", "name_field");
    size_ = field_of(layer, "", "size", "");
    priority_ = field_of(layer, options_.priority_field, "priority", "priority_field");
    kept_.clear();
    for (const std::string& name : options_.keep_fields) {
      const bool is_own = is_feature_id(layer, name);
      if (is_own) asked_.note("keep_field", name, true, "");
      kept_.push_back(is_own ? kOwnNumber : field_of(layer, name, "", "keep_field"));
    }
    Result<MapProjection> projection =
        projection_of(gdal_.OGR_L_GetSpatialRef(layer), options_.crs);
    if (!projection) {
      if (!error_) error_ = std::move(projection).error();
      return;
    }
    projection_ = std::move(*projection);
    degrees_ |= projection_.degrees;
    note_fields(layer);
    if (!projection_.unit.empty()) input_.unit = projection_.unit;
    note_system(layer);
    if (error_) return;
    quiet_.forget();
    gdal_.OGR_L_ResetReading(layer);
    while (!error_) {
      const Feature feature(gdal_.OGR_L_GetNextFeature(layer));
      note_failure();
      if (!feature) break;
      read_feature(feature.get());
    }
  }

  void note_fields(OGRLayerH layer) {
    OGRFeatureDefnH definition = gdal_.OGR_L_GetLayerDefn(layer);
    for (int k = 0; k < gdal_.OGR_FD_GetFieldCount(definition); ++k)
      note_field(input_, gdal_.OGR_Fld_GetNameRef(gdal_.OGR_FD_GetFieldDefn(definition, k)));
  }

  /// Layers of one file may be in different systems.
  void note_system(OGRLayerH layer) {
    const std::string& system = projection_.system;
    if (surely_differ(input_.system, system))
      fail(ErrorCode::bad_option,
           fmt::format("its layers are in different coordinate systems, '{}' in {} and '{}' in {}: "
                       "--crs {} projects them",
                       system_layer_, input_.system, gdal_.OGR_L_GetName(layer), system,
                       projection_.unit.empty() ? input_.system : system));
    if (!input_.system.empty() || system.empty()) return;
    input_.system = system;
    system_layer_ = gdal_.OGR_L_GetName(layer);
  }

  /// An attribute that no area has is not there, whatever layers have.
  void note_beside_areas() {
    for (std::size_t k = 0; k < attributes_.names().size(); ++k) {
      const std::string& name = attributes_.names()[k];
      const std::optional<std::string> beside = attributes_.beside_areas(k, "attribute");
      if (beside && name != kFeatureId) asked_.deny("keep_field", name, *beside);
    }
  }

  bool has(OGRFeatureH feature, int field) {
    return field >= 0 && gdal_.OGR_F_IsFieldSetAndNotNull(feature, field) != 0;
  }
  OGRFieldType type_of(OGRFeatureH feature, int field) {
    return gdal_.OGR_Fld_GetType(gdal_.OGR_F_GetFieldDefnRef(feature, field));
  }

  /// A text as GDAL has it, in UTF-8 unless the file does not say in which code page it is.
  std::string words_in(OGRFeatureH feature, int field) {
    std::string words = gdal_.OGR_F_GetFieldAsString(feature, field);
    if (gdal_.CPLIsUTF8(words.c_str(), static_cast<int>(words.size())) == 0 && no_utf8_++ == 0)
      first_no_utf8_ =
          fmt::format("'{}' of feature {}", printable(words), gdal_.OGR_F_GetFID(feature));
    return words;
  }

  /// The text of an attribute as GeoJSON would have it; empty if there is none.
  std::string text_of(OGRFeatureH feature, int field) {
    if (!has(feature, field)) return "";
    if (type_of(feature, field) != OFTReal) return words_in(feature, field);
    std::string text = fmt::format("{}", gdal_.OGR_F_GetFieldAsDouble(feature, field));
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  }

  AttributeValue value_of(OGRFeatureH feature, int field) {
    if (field == kOwnNumber) return std::int64_t{gdal_.OGR_F_GetFID(feature)};
    if (!has(feature, field)) return {};
    const OGRFieldType type = type_of(feature, field);
    if (type == OFTReal) return gdal_.OGR_F_GetFieldAsDouble(feature, field);
    if (type == OFTInteger || type == OFTInteger64)
      return std::int64_t{gdal_.OGR_F_GetFieldAsInteger64(feature, field)};
    return words_in(feature, field);
  }

  /// A length; whatever else a table calls so is left out, as of GeoJSON.
  std::optional<double> size_of(OGRFeatureH feature) {
    const std::optional<double> size = number_of(feature, size_);
    if (size && *size > 0) return size;
    left_out_.add_size(static_cast<long>(gdal_.OGR_F_GetFID(feature)));
    return std::nullopt;
  }

  /// A number, or a text that spells one.
  std::optional<double> number_of(OGRFeatureH feature, int field) {
    const OGRFieldType type = type_of(feature, field);
    if (type != OFTReal && type != OFTInteger && type != OFTInteger64)
      return number_in_words(gdal_.OGR_F_GetFieldAsString(feature, field));
    const double number = gdal_.OGR_F_GetFieldAsDouble(feature, field);
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
  }

  FeatureWords words_of(OGRFeatureH feature) {
    FeatureWords words;
    words.material = text_of(feature, material_);
    words.is_void = is_word_for_void(words.material);
    words.name = text_of(feature, name_);
    if (has(feature, priority_)) words.priority = number_of(feature, priority_);
    if (has(feature, priority_) && !words.priority)
      fail(ErrorCode::syntax,
           fmt::format("feature {}: the priority is no number", gdal_.OGR_F_GetFID(feature)));
    if (has(feature, size_)) words.size = size_of(feature);
    if (words.material.empty())
      words.material = words.name.empty() ? fmt::format("feature_{}", features_) : words.name;
    return words;
  }

  void read_feature(OGRFeatureH feature) {
    words_ = words_of(feature);
    fid_ = gdal_.OGR_F_GetFID(feature);
    feature_ = attributes_.add_feature(static_cast<long>(fid_));
    for (std::size_t k = 0; k < kept_.size(); ++k) attributes_.set(k, value_of(feature, kept_[k]));
    ++features_;
    Geometry geometry(gdal_.OGR_F_StealGeometry(feature));
    if (!geometry) return left_out_.add_empty();
    if (gdal_.OGR_G_HasCurveGeometry(geometry.get(), 0) != 0)
      geometry.reset(gdal_.OGR_G_GetLinearGeometry(geometry.get(), options_.chord_angle, nullptr));
    if (!geometry) return fail(ErrorCode::syntax, fmt::format("feature {}: a broken curve", fid_));
    read_geometry(geometry.get());
  }

  void read_geometry(OGRGeometryH geometry) {
    if (gdal_.OGR_G_IsEmpty(geometry) != 0) return left_out_.add_empty();
    switch (gdal_.OGR_GT_Flatten(gdal_.OGR_G_GetGeometryType(geometry))) {
      case wkbPolygon:
      case wkbTriangle:
        return add_polygon(geometry);
      case wkbLineString:
        return add_line(geometry);
      case wkbMultiPolygon:
      case wkbMultiLineString:
      case wkbMultiPoint:
      case wkbGeometryCollection:
        for (OGRGeometryH part : parts_of(geometry))
          if (!error_) read_geometry(part);
        return;
      case wkbPoint:
        return add_point(geometry);
      default:
        left_out_.add_surface();
    }
  }

  /// Of a collection its geometries, of a polygon its rings.
  std::vector<OGRGeometryH> parts_of(OGRGeometryH geometry) {
    std::vector<OGRGeometryH> parts;
    for (int k = 0; k < gdal_.OGR_G_GetGeometryCount(geometry); ++k)
      parts.push_back(gdal_.OGR_G_GetGeometryRef(geometry, k));
    return parts;
  }

  std::vector<Point> points_of(OGRGeometryH curve) {
    const auto n = static_cast<std::size_t>(gdal_.OGR_G_GetPointCount(curve));
    std::vector<Point> points(n);
    if (n == 0) return points;
    std::vector<double> x(n), y(n), z(n);
    gdal_.OGR_G_GetPoints(curve, x.data(), sizeof(double), y.data(), sizeof(double), z.data(),
                          sizeof(double));
    for (const double height : z)
      if (height != 0) left_out_.add_height();
    const std::vector<double> given_x = projection_.transform ? x : std::vector<double>();
    const std::vector<double> given_y = projection_.transform ? y : std::vector<double>();
    if (projection_.transform)
      gdal_.OCTTransform(projection_.transform.get(), static_cast<int>(n), x.data(), y.data(),
                         nullptr);
    for (std::size_t k = 0; k < n; ++k) {
      if (!std::isfinite(x[k]) || !std::isfinite(y[k])) {
        fail(ErrorCode::non_finite_coordinate,
             projection_.transform ? beyond_projection({given_x[k], given_y[k]})
                                   : fmt::format("feature {}: a coordinate is not finite", fid_));
        break;
      }
      points[k] = {x[k], y[k]};
    }
    quiet_.forget();  // PROJ's own words on the same
    return points;
  }

  std::string beyond_projection(Point given) const {
    if (projection_.from_degrees && !is_on_globe(given))
      return fmt::format(
          "feature {}: ({}, {}) is no longitude and latitude, which its coordinates should be: if "
          "they are those of {} already, leave the option crs out",
          fid_, given.x, given.y, options_.crs);
    return fmt::format("feature {}: ({}, {}) is not where {} reaches", fid_, given.x, given.y,
                       options_.crs);
  }

  void add_polygon(OGRGeometryH polygon) {
    attributes_.add_shape(feature_, FeatureShape::area);
    if (words_.is_void) left_out_.add_void();
    InputPolygon out;
    for (OGRGeometryH ring : parts_of(polygon)) out.rings.push_back(points_of(ring));
    out.material = words_.material;
    out.region = words_.name;
    out.priority = words_.priority;
    out.size = words_.size;
    out.feature = feature_;
    out.id = static_cast<long>(input_.polygons.size());
    input_.polygons.push_back(std::move(out));
  }

  void add_line(OGRGeometryH line) {
    if (words_.size) left_out_.add_size_of_line();
    attributes_.add_shape(feature_, FeatureShape::line);
    InputLine out{words_.name, points_of(line), static_cast<long>(input_.lines.size())};
    if (out.points.size() < 2)
      return fail(ErrorCode::syntax,
                  fmt::format("feature {}: a line needs two points or more", fid_));
    input_.lines.push_back(std::move(out));
  }

  void add_point(OGRGeometryH point) {
    if (words_.size) left_out_.add_size_of_point();
    attributes_.add_shape(feature_, FeatureShape::point);
    for (const Point p : points_of(point)) {
      if (!words_.name.empty())
        input_.point_names.push_back(
            {static_cast<std::uint32_t>(input_.points.size()), words_.name});
      input_.points.push_back(p);
    }
  }

  void tell() {
    left_out_.tell("attribute", input_);
    if (no_utf8_ > 0)
      input_.warnings.push_back(fmt::format(
          "{} no UTF-8, {}{}: {}", counted(no_utf8_, "text") + (no_utf8_ == 1 ? " is" : " are"),
          no_utf8_ == 1 ? "" : "the first of them ", first_no_utf8_,
          extension_of(input_.source) == ".shp"
              ? "a .cpg beside the .shp, or the environment variable SHAPE_ENCODING, says in which "
                "code page they are, as ISO-8859-1"
              : "letters beyond ASCII may be others"));
    if (degrees_) tell_degrees(input_);
  }

  const GdalLibrary& gdal_;
  const ReadOptions& options_;
  QuietGdal quiet_;
  Input input_;
  MapProjection projection_;
  int material_ = -1, name_ = -1, priority_ = -1, size_ = -1;  ///< numbers of attributes
  static constexpr int kOwnNumber = -2;                        ///< instead of that of an attribute
  AttributeTable attributes_;
  std::vector<int> kept_;      ///< numbers of attributes, by ReadOptions::keep_fields
  std::uint32_t feature_ = 0;  ///< as InputPolygon has it
  FeatureWords words_;
  GIntBig fid_ = 0;
  long features_ = 0;
  LeftOut left_out_;
  std::size_t no_utf8_ = 0;  ///< texts
  std::string first_no_utf8_;
  bool degrees_ = false;
  std::string system_layer_;  ///< the first whose system is known
  AskedNames asked_;
  std::optional<Error> error_;
};

}  // namespace

bool is_map(std::string_view extension) {
  constexpr std::array<std::string_view, 5> kMaps{".shp", ".gpkg", ".fgb", ".gml", ".kml"};
  return std::find(kMaps.begin(), kMaps.end(), extension) != kMaps.end();
}

void describe_system(Input& input, const ReadOptions& options) {
  // Names that are no numbers of a registry may be anything.
  if (!input.system.starts_with("EPSG:") || input.system == kLongitudeLatitude || !gdal_library())
    return;
  const QuietGdal quiet;
  if (const auto known = projection_of(input.system)) {
    Input said;
    said.unit = known->unit;
    if (!apply_units(said, options)) return;  // the input was refused by the same before
    input.unit = said.unit;
    input.warnings.insert(input.warnings.end(), said.warnings.begin(), said.warnings.end());
    return;
  }
  // A PROJ without its table knows none.
  if (quiet.failure().find("proj.db") != std::string::npos) return;
  input.warnings.push_back(
      fmt::format("PROJ does not know the system of its coordinates, {}", input.system));
  input.system.insert(0, kUnknownSystem);
}

Result<Input> read_gdal(const std::string& path, const ReadOptions& options) {
  if (const Status status = check_read_options(options); !status) return status.error();
  std::error_code ignored;
  // GDAL knows names that are no files: those of archives, servers, databases.
  if (!std::filesystem::is_regular_file(path, ignored)) {
    const bool is_there = std::filesystem::exists(path, ignored);
    return Error{
        ErrorCode::cannot_open,
        fmt::format("cannot open {}: {}", path, is_there ? "not a regular file" : "no such file"),
        {},
        {}};
  }
  const Result<const GdalLibrary*> gdal = gdal_library();
  if (!gdal)
    return Error{gdal.error().code, fmt::format("{}: {}", path, gdal.error().message), {}, {}};
  Result<Input> input =
      memory_as_value(path, [&] { return MapReader(**gdal, path, options).read(); });
  if (!input) return input;
  if (Status status = apply_units(*input, options); !status) return std::move(status).error();
  return input;
}

}  // namespace cover
