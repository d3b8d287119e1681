// GeoJSON (RFC 7946): each Polygon and MultiPolygon a painted area, each LineString a named line,
// each Point a point of the drawing.
//
// Properties: `material` (else `name`, else the feature is a material of its own), `name` (of the
// region or line), `priority`, `size` (the wished edge length inside); the first three may be
// called otherwise, and those that are to be kept become attributes. Coordinates are taken as they
// are, plane, heights left out; so is whatever else a file carries, which the RFC allows.
// Tested by read_geojson_test.cpp.
#include "io/input/drawings/read_geojson.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>

#include <cover/text.hpp>

#include "geom/box.hpp"
#include "geom/rings/place_in_ring.hpp"
#include "io/input/attribute_table.hpp"
#include "io/input/coordinate_systems.hpp"
#include "io/input/formats.hpp"
#include "io/input/map_words.hpp"

namespace cover {
namespace {

constexpr long kFeaturesForNames = 100;              ///< whose properties one may have meant
constexpr std::size_t kMostCrossings = 100'000'000;  ///< of rays, looked for in one file

class GeoReader {
 public:
  GeoReader(const Json& document, const std::string& source, const ReadOptions& options)
      : document_(document),
        json_(document, source),
        options_(options),
        material_("material_field", options.material_field, "material"),
        name_("name_field", options.name_field, "name"),
        priority_("priority_field", options.priority_field, "priority"),
        attributes_(options.keep_fields) {
    input_.source = source;
  }

  Result<Input> read() {
    read_all(document_);
    return finish();
  }

  /// The same, where `elements` stand in the collection of features that the document is; nothing
  /// where something is wrong, of which the place is not known.
  std::optional<Input> read(const std::vector<std::string_view>& elements) {
    if (JsonReader::member(document_, "type") == nullptr ||
        *JsonReader::member(document_, "type") != "FeatureCollection")
      return std::nullopt;
    for (const std::string_view element : elements) {
      const Result<JsonDocument> feature = parse_json_text(element, "");
      if (!feature) return std::nullopt;
      read_all(feature->root());
      if (json_.failed()) return std::nullopt;
    }
    Result<Input> input = finish();
    return input ? std::optional(*std::move(input)) : std::nullopt;
  }

 private:
  /// An object with all that lies in it.
  void read_all(const Json& root) {
    push(root, Properties{});
    while (!waiting_.empty() && !json_.failed()) {
      const auto [object, properties] = std::move(waiting_.back());
      waiting_.pop_back();
      const std::size_t before = waiting_.size();
      read_object(*object, properties);
      // What lies in the object comes next, and in its order: later polygons win over earlier ones.
      std::reverse(waiting_.begin() + static_cast<std::ptrdiff_t>(before), waiting_.end());
    }
  }

  Result<Input> finish() {
    if (!json_.failed() && !options_.is_one_of_several && input_.polygons.empty() &&
        input_.lines.empty() && input_.points.empty())
      json_.fail(document_, "no Polygon, MultiPolygon, LineString or Point in it");
    if (json_.failed()) return json_.error();
    left_out_.tell("property", input_);
    if (outside_ > 0)
      input_.warnings.push_back(
          fmt::format("{} outside of the outer ring of {}, the first at {}: inside is what rings "
                      "go round an odd number of times, so there is no hole there but an area",
                      counted(outside_, "inner ring") + (outside_ == 1 ? " lies" : " lie"),
                      outside_ == 1 ? "its polygon" : "their polygons", describe(first_outside_)));
    input_.fields.assign(known_.begin(), known_.end());
    note_system();
    warn_of_capitals();
    if (auto missing = missing_property()) return *std::move(missing);
    input_.attributes = attributes_.attributes();
    attributes_.tell_mixed(input_.warnings);
    if (!options_.is_one_of_several) tell_spelled_numbers(input_.attributes, input_.warnings);
    tell_renamed(input_.attributes, input_.warnings);
    return std::move(input_);
  }

  /// What a feature says of its geometry.
  struct Properties {
    std::string material;
    std::string name;
    std::optional<double> priority;
    std::optional<double> size;
    std::uint32_t feature = 0;  ///< as InputPolygon has it
    bool is_void = false;       ///< by the word that drawings have for it
  };

  /// A property that means something; what the caller called it has to be there.
  struct Meaning {
    Meaning(const char* its_option, const std::string& asked, const char* usual)
        : option(its_option), name(asked.empty() ? usual : asked), is_asked(!asked.empty()) {}

    const char* option;
    std::string name;
    bool is_asked;          ///< an option names it
    bool is_there = false;  ///< a feature has it

    /// Its value, or nullptr where there is none.
    const Json* of(const Json& properties) {
      const Json* value = JsonReader::member(properties, name);
      if (value) is_there = true;
      return value;
    }
  };

  void push(const Json& object, const Properties& properties) {
    waiting_.emplace_back(&object, properties);
  }

  void read_object(const Json& object, const Properties& properties) {
    if (!object.is_object()) return json_.fail(object, "expected a GeoJSON object");
    const std::string type = json_.text(json_.required(object, "type"));
    if (json_.failed()) return;
    const auto coordinates = [&]() -> const Json& {
      return json_.array(json_.required(object, "coordinates"), "coordinates");
    };
    const auto parts = [&]() -> const Json& {
      const Json& all = coordinates();
      if (!json_.failed()) is_empty(all);
      return all;
    };
    if (type == "FeatureCollection") {
      for (const Json& f : json_.array(json_.required(object, "features"), "features"))
        push(f, properties);
    } else if (type == "Feature") {
      const Json* geometry = JsonReader::member(object, "geometry");
      const Properties own = read_properties(object);
      if (geometry)
        push(*geometry, own);
      else
        left_out_.add_empty();
    } else if (type == "GeometryCollection") {
      const Json& all = json_.array(json_.required(object, "geometries"), "geometries");
      if (is_empty(all)) return;
      for (const Json& g : all) push(g, properties);
    } else if (type == "Polygon") {
      read_polygon(coordinates(), properties);
    } else if (type == "MultiPolygon") {
      for (const Json& polygon : parts()) read_polygon(polygon, properties);
    } else if (type == "LineString") {
      read_line(coordinates(), properties);
    } else if (type == "MultiLineString") {
      for (const Json& line : parts()) read_line(line, properties);
    } else if (type == "Point") {
      read_point(coordinates(), properties);
    } else if (type == "MultiPoint") {
      for (const Json& point : parts()) read_point(point, properties);
    } else {
      json_.fail(object, fmt::format("the type \"{}\" is not one of GeoJSON{}", type,
                                     type == "Topology" ? ": ogr2ogr makes that of TopoJSON" : ""));
    }
  }

  Properties read_properties(const Json& feature) {
    Properties own;
    const long number = features_++;
    if (const Json* properties = JsonReader::member(feature, "properties")) {
      if (number < kFeaturesForNames && properties->is_object())
        for (const auto& property : properties->items()) known_.insert(property.key());
      if (const Json* m = material_.of(*properties)) own.material = read_name(*m);
      own.is_void = is_word_for_void(own.material);
      if (const Json* n = name_.of(*properties)) own.name = read_name(*n);
      if (const Json* p = priority_.of(*properties)) own.priority = read_number(*p);
      if (const Json* s = size_.of(*properties)) own.size = read_size(*s, number);
    }
    if (own.material.empty()) {
      has_made_up_ |= own.name.empty();
      own.material = own.name.empty() ? fmt::format("feature_{}", number) : own.name;
    }
    own.feature = attributes_.add_feature(number);
    for (std::size_t k = 0; k < attributes_.names().size(); ++k)
      attributes_.set(k, read_attribute(feature, attributes_.names()[k], number));
    return own;
  }

  static bool fits_whole(const Json& value) {
    return !value.is_number_unsigned() ||
           value.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<std::int64_t>::max()};
  }

  /// A property as it is; for `fid`, where none is called so, the feature's id or its place.
  static AttributeValue read_attribute(const Json& feature, const std::string& name, long number) {
    const Json* properties = JsonReader::member(feature, "properties");
    const Json* value = properties ? JsonReader::member(*properties, name) : nullptr;
    if (!value && name == kFeatureId) {
      value = JsonReader::member(feature, "id");
      if (!value) return std::int64_t{number};
    }
    if (!value) return {};
    if (value->is_number_integer() && fits_whole(*value)) return value->get<std::int64_t>();
    if (value->is_number_float()) return value->get<double>();
    if (value->is_string()) return value->get<std::string>();
    return value->dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  /// Takes over which system the document names. RFC 7946 knows but longitudes and latitudes, which
  /// need no name; drawings of any kind are written as GeoJSON, though, so without one the
  /// coordinates and what is asked for have to agree.
  void note_system() {
    const Json* crs = JsonReader::member(document_, "crs");
    const Json* properties = crs ? JsonReader::member(*crs, "properties") : nullptr;
    const Json* name = properties ? JsonReader::member(*properties, "name") : nullptr;
    if (name && name->is_string()) input_.system = system_of_name(name->get<std::string>());
    if (input_.polygons.empty() && input_.lines.empty()) return;  // no lengths and no angles
    if (input_.system == kLongitudeLatitude) tell_degrees(input_);
    const bool is_said =
        document_.is_object() && document_.contains("crs");  // if only that none is
    if (!is_said && options_.unit.empty() && options_.scale == 1 &&
        could_be_degrees(box_of_input(input_)))
      input_.warnings.emplace_back(kMayBeDegrees);
  }

  /// Capitals make a difference, but one who wrote them mostly meant the property of that name.
  void warn_of_capitals() {
    for (const Meaning* meaning : {&material_, &name_, &priority_, &size_}) {
      if (meaning->is_there || meaning->is_asked) continue;
      if (meaning == &name_ && !has_made_up_) continue;  // no name is missed
      const auto meant = std::find_if(known_.begin(), known_.end(), [&](const std::string& name) {
        return name != meaning->name && is_alike(name, meaning->name) && !is_read(name);
      });
      if (meant == known_.end()) continue;
      std::string option = meaning->option;
      std::replace(option.begin(), option.end(), '_', '-');
      input_.warnings.push_back(fmt::format(
          "{}, and '{}' with capitals counts for nothing{}", lack_of(meaning->name), *meant,
          option.empty() ? "" : fmt::format(": --{} {} takes it", option, *meant)));
    }
  }

  /// But for capitals.
  static bool is_alike(std::string_view one, std::string_view other) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [&](char c, char d) { return small(c) == small(d); });
  }

  /// Whether an option takes the property, for whatever it is.
  [[nodiscard]] bool is_read(const std::string& property) const {
    const std::vector<std::string>& kept = attributes_.names();
    return property == material_.name || property == name_.name || property == priority_.name ||
           std::find(kept.begin(), kept.end(), property) != kept.end();
  }

  [[nodiscard]] std::string lack_of(const std::string& property) const {
    return known_.contains(property)
               ? fmt::format("the property '{}' is null in every feature", property)
               : fmt::format("no feature has the property '{}'", property);
  }

  /// A property that was asked for and that no feature has.
  std::optional<Error> missing_property() {
    AskedNames asked;
    const auto note = [&](const char* option, const std::string& name, bool is_there) {
      asked.note(
          option, name, is_there,
          known_.contains(name)
              ? lack_of(name)
              : lack_of(name) + did_you_mean(name, std::vector(known_.begin(), known_.end())));
    };
    for (const Meaning* meaning : {&material_, &name_, &priority_})
      if (meaning->is_asked) note(meaning->option, meaning->name, meaning->is_there);
    for (std::size_t k = 0; k < attributes_.names().size(); ++k) {
      const std::string& name = attributes_.names()[k];
      const std::optional<std::string> beside = attributes_.beside_areas(k, "property");
      if (beside && name != kFeatureId)
        asked.note("keep_field", name, false, *beside);
      else
        note("keep_field", name, !attributes_.is_empty(k));
    }
    return asked.settle(options_, input_);
  }

  /// A number, or a text that spells one: in many tables all columns are text.
  double read_number(const Json& value) {
    if (value.is_string())
      if (const auto number = number_in_words(value.get_ref<const std::string&>())) return *number;
    return json_.number(value);
  }

  /// A length; whatever else a table calls so is left out.
  std::optional<double> read_size(const Json& value, long feature) {
    const std::optional<double> number = value.is_number() ? std::optional(json_.number(value))
                                         : value.is_string()
                                             ? number_in_words(value.get_ref<const std::string&>())
                                             : std::nullopt;
    if (number && *number > 0) return number;
    left_out_.add_size(feature);
    return std::nullopt;
  }

  /// Tables that maps are made from have numbers and truth values for names too.
  std::string read_name(const Json& value) {
    return value.is_number_float() || value.is_boolean() ? value.dump() : json_.name(value);
  }

  /// Counts what has no coordinates, which by the RFC is as null.
  bool is_empty(const Json& coordinates) {
    if (!coordinates.is_array() || !coordinates.empty()) return false;
    left_out_.add_empty();
    return true;
  }

  Point read_position(const Json& position) {
    const Point p = json_.point(position, true);
    if (!json_.failed() && position.size() > 2 && position[2].is_number() &&
        position[2].get<double>() != 0)
      left_out_.add_height();
    return p;
  }

  std::vector<Point> read_path(const Json& coordinates) {
    std::vector<Point> path;
    for (const Json& position : json_.array(coordinates, "positions")) {
      if (json_.failed()) break;
      path.push_back(read_position(position));
    }
    return path;
  }

  void read_polygon(const Json& coordinates, const Properties& properties) {
    if (json_.failed()) return;
    if (is_empty(coordinates)) return;
    attributes_.add_shape(properties.feature, FeatureShape::area);
    if (properties.is_void) left_out_.add_void();
    InputPolygon polygon;
    for (const Json& ring : json_.array(coordinates, "rings"))
      polygon.rings.push_back(read_path(ring));
    look_for_holes_outside(polygon.rings);
    polygon.material = properties.material.empty() ? "feature_0" : properties.material;
    polygon.region = properties.name;
    polygon.priority = properties.priority;
    polygon.size = properties.size;
    polygon.feature = properties.feature;
    polygon.id = static_cast<long>(input_.polygons.size());
    input_.polygons.push_back(std::move(polygon));
  }

  void read_point(const Json& position, const Properties& properties) {
    if (json_.failed()) return;
    if (is_empty(position)) return;
    if (properties.size) left_out_.add_size_of_point();
    attributes_.add_shape(properties.feature, FeatureShape::point);
    if (!properties.name.empty())
      input_.point_names.push_back(
          {static_cast<std::uint32_t>(input_.points.size()), properties.name});
    input_.points.push_back(read_position(position));
  }

  void look_for_holes_outside(const std::vector<std::vector<Point>>& rings) {
    if (rings.size() < 2 || rings.front().empty()) return;
    const Box box = box_of(rings.front());
    for (std::size_t r = 1; r < rings.size(); ++r) {
      const auto is_within = [&](Point p) {
        if (!box.holds(p)) return false;
        crossings_ += rings.front().size();
        return crossings_ > kMostCrossings || place_in(rings.front(), p) != Place::outside;
      };
      if (rings[r].empty() || std::any_of(rings[r].begin(), rings[r].end(), is_within)) continue;
      if (outside_++ == 0) first_outside_ = rings[r].front();
    }
  }

  void read_line(const Json& coordinates, const Properties& properties) {
    if (json_.failed()) return;
    if (is_empty(coordinates)) return;
    if (properties.size) left_out_.add_size_of_line();
    attributes_.add_shape(properties.feature, FeatureShape::line);
    InputLine line{properties.name, read_path(coordinates), static_cast<long>(input_.lines.size())};
    if (line.points.size() < 2) json_.fail(coordinates, "a line needs two positions or more");
    input_.lines.push_back(std::move(line));
  }

  const Json& document_;
  JsonReader json_;
  const ReadOptions& options_;
  Input input_;
  std::vector<std::pair<const Json*, Properties>> waiting_;  // a stack
  long features_ = 0;
  std::set<std::string> known_;  ///< properties of the first features
  LeftOut left_out_;
  std::size_t crossings_ = 0;  ///< that were looked for
  std::size_t outside_ = 0;    ///< inner rings
  Point first_outside_;
  Meaning material_, name_, priority_;
  Meaning size_{"", "", "size"};
  bool has_made_up_ = false;  ///< a material that no property names
  AttributeTable attributes_;
};

}  // namespace

bool is_geojson(const Json& document) {
  const Json* type = JsonReader::member(document, "type");
  return type && type->is_string();
}

Result<Input> read_geojson(const Json& document, const std::string& source,
                           const ReadOptions& options) {
  return GeoReader(document, source, options).read();
}

std::optional<Input> read_geojson(const SplitJson& split, const std::string& source,
                                  const ReadOptions& options) {
  const Result<JsonDocument> rest = parse_json_text(split.rest, source);
  return rest ? GeoReader(rest->root(), source, options).read(split.find("features")->elements)
              : std::nullopt;
}

Result<Input> parse_geojson(std::string_view text, const std::string& source,
                            const ReadOptions& options) {
  if (const auto split = split_json(text, {"features"})) {
    if (std::optional<Input> input = read_geojson(*split, source, options))
      return *std::move(input);
  }
  const Result<JsonDocument> document = parse_json_text(text, source);
  if (!document) return document.error();
  return read_geojson(document->root(), source, options);
}

}  // namespace cover
