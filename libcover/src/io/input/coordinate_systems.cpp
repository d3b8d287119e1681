// Systems are compared by their numbers in the registry of EPSG, which readers know: this library
// is built without PROJ. Tested by tests/unit/io/input/coordinate_systems_test.cpp.
#include "io/input/coordinate_systems.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/words/characters.hpp"

namespace cover {
namespace {

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

bool is_code(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
  });
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

/// A number that means the system of another one: of another authority, or with what does not count
/// here, heights and the order of axes.
struct OtherNumber {
  std::string_view other;
  const char* number;
};
constexpr std::array kOtherNumbers{
    OtherNumber{"OGC:CRS84", kLongitudeLatitude}, OtherNumber{"OGC:CRS84H", kLongitudeLatitude},
    OtherNumber{"CRS:84", kLongitudeLatitude},    OtherNumber{"EPSG:4979", kLongitudeLatitude},
    OtherNumber{"EPSG:900913", "EPSG:3857"},      OtherNumber{"ESRI:102100", "EPSG:3857"},
    OtherNumber{"ESRI:102113", "EPSG:3857"}};

std::string numbered(std::string_view authority, std::string_view code) {
  std::string system = upper(authority) + ":" + upper(code);
  for (const OtherNumber& known : kOtherNumbers)
    if (known.other == system) return known.number;
  return system;
}

bool is_numbered(std::string_view system) {
  const std::vector<std::string_view> parts = split_at(system, ':');
  return parts.size() == 2 && is_code(parts[0]) && is_code(parts[1]);
}

bool is_of_epsg(std::string_view system) { return system.starts_with("EPSG:"); }

bool is_of_degrees(const Input& input) { return could_be_degrees(box_of_input(input)); }

/// "a.shp (EPSG:25832)"
std::string with_system(const Input& input) {
  return fmt::format("{} ({})", input.source,
                     input.system.empty() ? std::string("no system is said") : input.system);
}

/// How one of two inputs gets into the system of the other, a plane one if one is.
std::string advice(const Input& one, const Input& other) {
  const bool takes_other = one.system.empty() || one.system == kLongitudeLatitude ||
                           (one.unit.empty() && !other.unit.empty());
  const Input& to = takes_other ? other : one;
  const Input& from = takes_other ? one : other;
  const std::string system = is_numbered(to.system) ? to.system : "EPSG:...";
  const bool is_known = !from.system.empty() && !from.system.starts_with(kUnknownSystem);
  const std::string said = is_known              ? std::string()
                           : is_of_degrees(from) ? fmt::format("-s_srs {} ", kLongitudeLatitude)
                                                 : std::string("-s_srs EPSG:... ");
  return fmt::format(
      "'ogr2ogr {0}-t_srs {1} OUT{2} {3}' makes a file in the system of {4}, and --crs {1} "
      "projects all maps that say theirs",
      said, system, extension_of(from.source), from.source, to.source);
}

/// Whether one of two maps is on the globe and the other not, and far from it.
bool lie_apart(const Input& one, const Input& other) {
  if (one.scale != 1 || other.scale != 1) return false;
  return is_of_degrees(one) != is_of_degrees(other) &&
         !box_of_input(one).meets(box_of_input(other));
}

std::string sentence_of_apart(const Input& one, const Input& other) {
  const bool first = is_of_degrees(one);
  return fmt::format(
      "coordinates of {} could be longitudes and latitudes, those of {} are none, so they may be "
      "in different systems",
      with_system(first ? one : other), with_system(first ? other : one));
}

/// The input whose system is compared with those of the others: one with a number, if any has.
const Input* find_known(const std::vector<Input>& inputs) {
  const Input* known = nullptr;
  for (const Input& input : inputs) {
    if (is_of_epsg(input.system)) return &input;
    if (known == nullptr && !input.system.empty()) known = &input;
  }
  return known;
}

/// A picture that lies nowhere near a map: pixels know no place on one.
std::string sentence_of_picture(const Input& one, const Input& other) {
  const Input& picture = one.is_picture ? one : other;
  const Box box = box_of_input(picture);
  return fmt::format(
      "{} is a picture, whose pixels have no place on the map {}: they lie from ({}, {}) to "
      "({}, {}), apart from it; 'gdal_polygonize.py {} -f GeoJSON OUT.geojson' makes a map of one "
      "that says its place",
      picture.source, with_system(one.is_picture ? other : one), box.low.x, box.low.y, box.high.x,
      box.high.y, picture.source);
}

/// Looks at one pair in the order of the inputs.
Status check_pair(const Input& one, const Input& other, std::vector<std::string>& warnings) {
  if (one.system == other.system) return ok();
  const auto refused = [&](const std::string& what) {
    return bad_option(fmt::format("{} and {} cannot be taken together: {}: {}", one.source,
                                  other.source, what, advice(one, other)));
  };
  if (surely_differ(one.system, other.system))
    return refused(fmt::format("their coordinates are in different systems, {} and {}", one.system,
                               other.system));
  if (!one.system.empty() && !other.system.empty()) {
    warnings.push_back(
        fmt::format("{} and {} name their coordinate systems differently: if they are not one, {}",
                    with_system(one), with_system(other), advice(one, other)));
    return ok();
  }
  if (one.is_picture != other.is_picture) {
    if (box_of_input(one).meets(box_of_input(other))) return ok();
    const std::string sentence = sentence_of_picture(one, other);
    if (one.unit != other.unit)
      return bad_option(fmt::format("{} and {} cannot be taken together: {}", one.source,
                                    other.source, sentence));
    warnings.push_back(sentence);
    return ok();
  }
  if (!lie_apart(one, other)) return ok();
  if (one.unit != other.unit) return refused(sentence_of_apart(one, other));
  warnings.push_back(sentence_of_apart(one, other));
  return ok();
}

}  // namespace

std::string system_of_name(std::string_view name) {
  const bool is_address = name.starts_with("http://") || name.starts_with("https://");
  const std::vector<std::string_view> parts = split_at(name, is_address ? '/' : ':');
  const std::size_t n = parts.size();
  // As urn:ogc:def:crs:EPSG::25832 and http://www.opengis.net/def/crs/EPSG/0/25832.
  const bool is_long = is_address ? n >= 4 && parts[n - 4] == "crs"
                                  : n >= 6 && lower(parts[0]) == "urn" && lower(parts[3]) == "crs";
  if (is_long) {
    const std::string_view authority = is_address ? parts[n - 3] : parts[4];
    if (is_code(authority) && is_code(parts[n - 1])) return numbered(authority, parts[n - 1]);
  }
  return is_numbered(name) ? numbered(parts[0], parts[1]) : std::string(name);
}

bool surely_differ(std::string_view one, std::string_view other) {
  return one != other && is_of_epsg(one) && is_of_epsg(other);
}

bool is_on_globe(Point p) { return std::abs(p.x) <= 360 && std::abs(p.y) <= 90; }

bool could_be_degrees(const Box& box) {
  return !box.is_empty() && box.low.x >= -180 && box.high.x <= 180 && box.low.y >= -90 &&
         box.high.y <= 90;
}

Box box_of_input(const Input& input) {
  Box box = box_of(input.points);
  for (const InputPolygon& polygon : input.polygons)
    for (const std::vector<Point>& ring : polygon.rings) box.include(box_of(ring));
  for (const InputLine& line : input.lines) box.include(box_of(line.points));
  return box;
}

Status check_systems(const std::vector<Input>& inputs, std::vector<std::string>& warnings) {
  const Input* known = find_known(inputs);
  if (known == nullptr) return ok();
  for (const Input& input : inputs) {
    const bool is_before = &input < known;
    if (Status status =
            check_pair(is_before ? input : *known, is_before ? *known : input, warnings);
        !status)
      return status;
  }
  return ok();
}

}  // namespace cover
