// Our own JSON form; apps/cover/input.schema.json says it in full.
//
// The document is walked twice: first all arcs are shown to the CurveCutter, which must know every
// end on a circle before it cuts it; then everything is read in order.
// Tested by read_json_test.cpp.
#include <cover/text.hpp>
#include <cover/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "base/containers/give_back.hpp"
#include "base/run_all.hpp"
#include "geom/ulp.hpp"
#include "io/input/drawings/curves.hpp"
#include "io/input/drawings/read_geojson.hpp"
#include "io/input/formats.hpp"
#include "io/text/json/json_reader.hpp"
#include "io/text/json/read_pairs.hpp"
#include "io/text/json/split_json.hpp"

namespace cover {
namespace {

/// More points than this from the curves of one file are taken for a mistake.
constexpr std::size_t kMostCurvePoints = std::size_t{1} << 22;

const std::vector<std::string_view> kTopKeys{
    "name",  "source",  "license", "notes",    "field",   "unit",        "points",   "segments",
    "holes", "regions", "lines",   "polygons", "$schema", "chord_error", "periodic", "layers"};

constexpr long kMostLayers = 1000;

/// Spacings of doubles by which two radii of one arc differ where its points were computed.
constexpr double kRoundings = 16;
/// Of these nothing is asked.
const std::vector<std::string_view> kFreeKeys{"name",  "source", "license",
                                              "notes", "field",  "$schema"};

/// Long arrays of a document whose own are empty.
struct TakenOut {
  Pairs<double> points{};
  Pairs<long> ends{};  ///< of the first segments
  std::vector<std::string_view> segments{}, polygons{};
};

class InputReader {
 public:
  InputReader(const Json& document, const std::string& source, TakenOut elements = {},
              const Team& team = {})
      : document_(document), json_(document, source), elements_(std::move(elements)), team_(team) {
    input_.source = source;
    input_.void_rule = VoidRule::unseeded_faces;
    input_.seeds_may_miss = true;
  }

  Result<Input> read() {
    if (json_.expect_keys(document_, kTopKeys, kFreeKeys)) {
      read_header();
      for_each_path([this](const Json& path) { note_arcs(path); });
      read_points();
      read_segments();
      read_holes();
      read_regions();
      read_polygons();
      read_lines();
      read_periodic();
      read_layers();
    }
    if (json_.failed()) return json_.error();
    for (std::string& sentence : cutter_.finer_than_asked())
      input_.warnings.push_back(std::move(sentence));
    if (uneven_arcs_ > 0) input_.warnings.push_back(uneven_arcs_text());
    return std::move(input_);
  }

 private:
  void read_header() {
    if (const Json* unit = JsonReader::member(document_, "unit")) {
      input_.unit = json_.text(*unit);
      if (!is_length_unit(input_.unit))
        json_.fail(*unit, "expected a unit of length: nm, um, mm, cm or m");
    }
    if (const Json* error = JsonReader::member(document_, "chord_error"))
      chord_error_ = json_.positive(*error);
    bool geometry = false;
    for (const char* key : {"points", "segments", "polygons", "lines"})
      geometry |= JsonReader::member(document_, key) != nullptr;
    if (!geometry) json_.fail(document_, "found no \"points\", \"segments\" or \"polygons\"");
  }

  /// Calls `f` with every array in which points and curves may stand.
  template <class F>
  void for_each_path(F f) {
    const auto elements = [](const Json* array) -> const Json& {
      static const Json none = Json::array();
      return array && array->is_array() ? *array : none;
    };
    f(elements(JsonReader::member(document_, "segments")));
    for (const Json& line : elements(JsonReader::member(document_, "lines")))
      f(elements(JsonReader::member(line, "points")));
    for (const Json& polygon : elements(JsonReader::member(document_, "polygons")))
      for (const Json& ring : elements(JsonReader::member(polygon, "rings"))) f(elements(&ring));
  }

  void note_arcs(const Json& path) {
    for (const Json& item : path) {
      if (!item.is_object() || JsonReader::member(item, "points")) continue;
      if (const std::optional<Arc> arc = read_curve(item)) cutter_.add(*arc);
    }
  }

  /// The curve `{"circle": {...}}` or `{"arc": {...}}`.
  std::optional<Arc> read_curve(const Json& item) {
    const Json* circle = JsonReader::member(item, "circle");
    const Json* arc_of_item = JsonReader::member(item, "arc");
    const Json* curve = circle ? circle : arc_of_item;
    if (circle && arc_of_item) json_.fail(item, "give an \"arc\" or a \"circle\", not both");
    if (!curve) {
      json_.fail(item, "expected a point [x, y], an \"arc\" or a \"circle\"");
      return std::nullopt;
    }
    const bool known =
        circle ? json_.expect_keys(*curve, {"centre", "radius", "chords", "chord_error"})
               : json_.expect_keys(*curve,
                                   {"centre", "radius", "from", "to", "chords", "chord_error"});
    if (!known) return std::nullopt;
    Arc arc;
    arc.centre = json_.point(json_.required(*curve, "centre"));
    arc.radius = json_.positive(json_.required(*curve, "radius"));
    if (!circle) {
      arc.from = json_.number(json_.required(*curve, "from"));
      arc.to = json_.number(json_.required(*curve, "to"));
    }
    const double sweep = arc.full() ? 360 : std::abs(arc.to - arc.from);
    if (!(sweep > 0 && sweep <= 360))
      json_.fail(*curve, "an arc spans more than 0 and at most 360 degrees");
    arc.step = read_step(*curve, arc.radius, sweep, circle ? 3 : 1);
    if (const Json* chords = JsonReader::member(*curve, "chords"))
      arc.chords = json_.integer(*chords);
    if (json_.failed()) return std::nullopt;
    return arc;
  }

  /// The largest angle of a chord, from "chords" or "chord_error", here or for the whole file.
  double read_step(const Json& curve, double radius, double sweep, long fewest) {
    const Json* chords = JsonReader::member(curve, "chords");
    const Json* error = JsonReader::member(curve, "chord_error");
    if (chords && error) json_.fail(curve, "give \"chords\" or \"chord_error\", not both");
    if (chords) {
      const long n = json_.integer(*chords);
      if (n < fewest) json_.fail(*chords, fmt::format("expected {} or more chords", fewest));
      return std::min(120.0, sweep / static_cast<double>(std::max(n, 1L)));
    }
    if (!error && !chord_error_)
      json_.fail(curve, "give \"chords\" or \"chord_error\" (or \"chord_error\" for all curves)");
    return step_for_chord_error(radius, error ? json_.positive(*error) : chord_error_.value_or(1));
  }

  /// Counts points against the limit; fails where a curve has too many.
  std::vector<Point> limited(const Json& item, std::optional<std::vector<Point>> points) {
    if (!points) {
      json_.fail(item, fmt::format("the curves of this file have more than {} points; "
                                   "is the chord error given in the unit of the coordinates?",
                                   kMostCurvePoints));
      return {};
    }
    curve_points_ += points->size();
    return std::move(*points);
  }

  /// Points one after the other, and circles of the chords from each to the next, as in
  /// InputSegment.
  struct Path {
    std::vector<Point> points;
    std::vector<std::uint32_t> circles;
  };

  static Path chords(std::vector<Point> points, std::uint32_t circle) {
    Path path{std::move(points), {}};
    path.circles.assign(path.points.size(), circle);
    if (!path.circles.empty()) path.circles.back() = 0;
    return path;
  }

  Path read_curve_points(const Json& item) {
    const std::optional<Arc> arc = read_curve(item);
    if (!arc) return {};
    return chords(limited(item, cutter_.points(*arc, kMostCurvePoints - curve_points_)),
                  circles_.of({arc->centre, arc->radius}));
  }

  /// A path of points and curves. Where two pieces meet in the same point it is taken once.
  Path read_path(const Json& value) {
    Path path;
    const auto add = [&](Point p, std::uint32_t circle) {
      path.points.push_back(p);
      path.circles.push_back(circle);
    };
    for (const Json& item : json_.array(value, "points and curves")) {
      if (json_.failed()) break;
      if (item.is_object()) {
        if (!json_.expect_keys(item, {"arc", "circle"})) break;
        const Path curve = read_curve_points(item);
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
          if (!path.points.empty() && path.points.back() == curve.points[k]) {
            path.circles.back() = curve.circles[k];
          } else {
            add(curve.points[k], curve.circles[k]);
          }
        }
      } else {
        add(json_.point(item), 0);
      }
    }
    return path;
  }

  /// Calls `f` with each element, and its index, of an array of the document, if it is there.
  template <class F>
  void for_each(std::string_view key, F f) {
    const Json* list = JsonReader::member(document_, key);
    if (!list) return;
    long index = 0;
    for (const Json& item : json_.array(*list, key)) {
      if (json_.failed()) return;
      f(item, index++);
    }
  }

  /// Calls `f` as for_each() does, each time with a tree of one element. What goes wrong here is
  /// told by reading the whole document.
  template <class F>
  void for_each_taken_out(std::span<const std::string_view> elements, F f) {
    for (std::size_t k = 0; k < elements.size() && !json_.failed(); ++k)
      as_tree(elements[k], static_cast<long>(k), f);
  }

  template <class F>
  void as_tree(std::string_view element, long index, F f) {
    const Result<JsonDocument> tree = parse_json_text(element, "");
    if (!tree) return json_.fail(document_, tree.error().message);
    f(tree->root(), index);
  }

  void read_points() {
    for_each("points", [&](const Json& p, long) { input_.points.push_back(json_.point(p)); });
    const std::size_t first = input_.points.size();
    input_.points.resize(first + elements_.points.size);
    elements_.points.for_each(team_, [&](std::size_t k, const std::array<double, 2>& pair) {
      input_.points[first + k] = {pair[0], pair[1]};
    });
    give_back(elements_.points.ranges);
    given_points_ = input_.points.size();
  }

  /// The index of one of the points that the file gives.
  std::uint32_t read_index(const Json& value) { return checked_index(json_.integer(value), value); }

  std::uint32_t checked_index(long index, const Json& value) {
    if (index >= 0 && static_cast<std::size_t>(index) < given_points_)
      return static_cast<std::uint32_t>(index);
    json_.fail(value,
               fmt::format("there is no point {}: the points are 0 to {}", index,
                           static_cast<long>(given_points_) - 1),
               ErrorCode::id_out_of_range);
    return 0;
  }

  /// The index of a point of a curve: an equal point of the file or of another curve, or a new one.
  std::uint32_t index_of(Point p) {
    if (indices_.empty())
      for (std::size_t i = 0; i < input_.points.size(); ++i)
        indices_.emplace(input_.points[i], static_cast<std::uint32_t>(i));
    const auto [at, is_new] = indices_.emplace(p, static_cast<std::uint32_t>(input_.points.size()));
    if (is_new) input_.points.push_back(p);
    return at->second;
  }

  void read_segments() {
    const auto read = [&](const Json& item, long id) {
      InputSegment segment;
      segment.id = id;
      if (item.is_object())
        read_named_segment(item, segment);
      else
        add_segment(segment, item);
    };
    for_each("segments", read);
    if (!read_ends()) return json_.fail(document_, "no point", ErrorCode::id_out_of_range);
    input_.segments.reserve(input_.segments.size() + elements_.segments.size());
    for (std::size_t k = 0; k < elements_.segments.size() && !json_.failed(); ++k) {
      const auto id = static_cast<long>(elements_.ends.size + k);
      const auto ends = read_integer_pair(elements_.segments[k]);
      if (!ends) {
        as_tree(elements_.segments[k], id, read);
        continue;
      }
      InputSegment segment;
      segment.id = id;
      segment.a = checked_index((*ends)[0], document_);
      segment.b = checked_index((*ends)[1], document_);
      input_.segments.push_back(std::move(segment));
    }
  }

  /// Segments that are pairs of numbers; false where one of these is of no point.
  bool read_ends() {
    std::atomic<bool> are_points = true;
    const std::size_t first = input_.segments.size();
    input_.segments.resize(first + elements_.ends.size);
    elements_.ends.for_each(team_, [&](std::size_t k, const std::array<long, 2>& ends) {
      InputSegment& segment = input_.segments[first + k];
      segment.id = static_cast<long>(k);
      for (const long end : ends) {
        if (end < 0 || static_cast<std::size_t>(end) >= given_points_) are_points = false;
      }
      segment.a = static_cast<std::uint32_t>(ends[0]);
      segment.b = static_cast<std::uint32_t>(ends[1]);
    });
    give_back(elements_.ends.ranges);
    return are_points;
  }

  /// The segment whose ends are the pair of indices `ends`.
  void add_segment(InputSegment segment, const Json& ends) {
    if (!ends.is_array() || ends.size() != 2)
      return json_.fail(ends, "expected a segment [i, j] of two point indices");
    segment.a = read_index(ends[0]);
    segment.b = read_index(ends[1]);
    input_.segments.push_back(std::move(segment));
  }

  void read_named_segment(const Json& item, InputSegment& segment) {
    if (!json_.expect_keys(item, {"points", "arc", "circle", "name", "marker", "layers"})) return;
    segment.name = name_of(item, "name");
    if (const Json* marker = JsonReader::member(item, "marker")) {
      const long m = json_.integer(*marker);
      if (m < std::numeric_limits<int>::min() || m > std::numeric_limits<int>::max())
        json_.fail(*marker, "a marker has at most 32 bits");
      segment.marker = static_cast<int>(m);
    }
    read_layers_of(item, segment.name);
    const Json* ends = JsonReader::member(item, "points");
    if (!ends) return add_chain(segment, read_curve_points(item));
    if (JsonReader::member(item, "circle"))
      return json_.fail(item, "give \"points\" or a \"circle\", not both");
    if (const Json* arc = JsonReader::member(item, "arc"))
      return add_arc_between(segment, *ends, *arc);
    add_segment(segment, *ends);
  }

  /// `{"points": [i, j], "arc": {"centre": ..}}`: an arc between two points of the file.
  void add_arc_between(const InputSegment& segment, const Json& ends, const Json& arc) {
    if (!json_.expect_keys(arc, {"centre", "clockwise", "chords", "chord_error"})) return;
    if (!ends.is_array() || ends.size() != 2)
      return json_.fail(ends, "expected a pair [i, j] of point indices");
    const Point a = input_.points.empty() ? Point{} : input_.points[read_index(ends[0])];
    const Point b = input_.points.empty() ? Point{} : input_.points[read_index(ends[1])];
    const Point centre = json_.point(json_.required(arc, "centre"));
    const Json* clockwise = JsonReader::member(arc, "clockwise");
    const bool turn = clockwise && json_.boolean(*clockwise);
    const double from_a = std::hypot(a.x - centre.x, a.y - centre.y);
    const double from_b = std::hypot(b.x - centre.x, b.y - centre.y);
    if (!(from_a > 0 && std::abs(from_a - from_b) <= 1e-3 * from_a))
      json_.fail(arc, fmt::format("the ends ({}, {}) and ({}, {}) are not equally far from the "
                                  "centre: {} and {}",
                                  a.x, a.y, b.x, b.y, from_a, from_b));
    note_uneven(centre, from_a, from_b);
    const double step = read_step(arc, std::max(from_a, std::numeric_limits<double>::min()),
                                  std::abs(sweep_between(a, b, centre, turn)), 1);
    if (json_.failed()) return;
    std::vector<Point> points =
        limited(arc, cut_arc_between(a, b, centre, turn, step, kMostCurvePoints - curve_points_));
    add_chain(segment,
              chords(std::move(points), circles_.of({centre, from_a + (from_b - from_a) / 2})));
  }

  void note_uneven(Point centre, double from_a, double from_b) {
    const double rounding = spacing_at(std::max({std::abs(centre.x), std::abs(centre.y), from_a}));
    const double apart = std::abs(from_a - from_b);
    if (!(apart > kRoundings * rounding)) return;
    ++uneven_arcs_;
    most_uneven_ = std::max(most_uneven_, apart);
  }

  [[nodiscard]] std::string uneven_arcs_text() const {
    return fmt::format(
        "{} between two points {} ends that are not equally far from the centre, by up to {:.3g}: "
        "the radius is the mean of both",
        counted(uneven_arcs_, "arc"), uneven_arcs_ == 1 ? "has" : "have", most_uneven_);
  }

  void add_chain(InputSegment segment, const Path& path) {
    for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
      segment.a = index_of(path.points[k]);
      segment.b = index_of(path.points[k + 1]);
      segment.circle = path.circles[k];
      input_.segments.push_back(segment);
    }
  }

  void read_holes() {
    for_each("holes", [&](const Json& hole, long id) {
      input_.holes.push_back({json_.point(hole), id, 0});
    });
  }

  void read_regions() {
    for_each("regions", [&](const Json& item, long id) {
      if (!json_.expect_keys(item, {"x", "y", "material", "region", "size"})) return;
      RegionSeed seed;
      seed.at = {json_.number(json_.required(item, "x")), json_.number(json_.required(item, "y"))};
      seed.material = name_of(item, "material");
      seed.region = name_of(item, "region");
      if (const Json* size = JsonReader::member(item, "size")) seed.size = json_.positive(*size);
      seed.id = id;
      input_.seeds.push_back(std::move(seed));
    });
  }

  void read_polygons() {
    const auto read = [&](const Json& item, long id) {
      if (!json_.expect_keys(item, {"material", "region", "priority", "size", "rings"})) return;
      InputPolygon polygon;
      polygon.material = json_.name(json_.required(item, "material"));
      polygon.region = name_of(item, "region");
      if (const Json* p = JsonReader::member(item, "priority")) polygon.priority = json_.number(*p);
      if (const Json* size = JsonReader::member(item, "size")) polygon.size = json_.positive(*size);
      for (const Json& ring : json_.array(json_.required(item, "rings"), "rings"))
        add_ring(read_path(ring), polygon);
      polygon.id = id;
      input_.polygons.push_back(std::move(polygon));
    };
    for_each("polygons", read);
    for_each_taken_out(elements_.polygons, read);
  }

  static void add_ring(Path path, InputPolygon& polygon) {
    polygon.rings.push_back(std::move(path.points));
    polygon.circles.push_back(std::move(path.circles));
  }

  void read_lines() {
    for_each("lines", [&](const Json& item, long id) {
      if (!json_.expect_keys(item, {"name", "points", "closed", "layers"})) return;
      InputLine line;
      line.name = name_of(item, "name");
      Path path = read_path(json_.required(item, "points"));
      line.points = std::move(path.points);
      line.circles = std::move(path.circles);
      const Json* closed = JsonReader::member(item, "closed");
      if (closed && json_.boolean(*closed) && !line.points.empty())
        line.points.push_back(line.points.front());
      if (line.points.size() < 2) json_.fail(item, "a line needs two points or more");
      line.id = id;
      read_layers_of(item, line.name);
      input_.lines.push_back(std::move(line));
    });
  }

  /// ["left", "right"], or {"from", "to"} with "rotation": {"centre", "angle"} or "mirror": true.
  void read_periodic() {
    for_each("periodic", [&](const Json& item, long) {
      PeriodicRule rule;
      if (item.is_array()) {
        if (item.size() != 2) return json_.fail(item, "expected the names of two lines");
        rule.from = json_.name(item[0]);
        rule.to = json_.name(item[1]);
      } else {
        if (!json_.expect_keys(item, {"from", "to", "rotation", "mirror"})) return;
        rule.from = json_.name(json_.required(item, "from"));
        rule.to = json_.name(json_.required(item, "to"));
        const Json* rotation = JsonReader::member(item, "rotation");
        const Json* mirror = JsonReader::member(item, "mirror");
        if (rotation && mirror)
          return json_.fail(item, "give a \"rotation\" or a \"mirror\", not both");
        if (mirror && json_.boolean(*mirror)) rule.map = PeriodicRule::Map::mirror;
        if (rotation && json_.expect_keys(*rotation, {"centre", "angle"})) {
          rule.map = PeriodicRule::Map::rotation;
          rule.centre = json_.point(json_.required(*rotation, "centre"));
          rule.angle = Angle::degrees(json_.number(json_.required(*rotation, "angle")));
        }
      }
      input_.periodic.push_back(std::move(rule));
    });
  }

  void read_layers() {
    for_each("layers", [&](const Json& item, long) {
      if (!json_.expect_keys(item, {"line", "region", "first", "growth", "count"})) return;
      add_layers(item, json_.name(json_.required(item, "line")));
    });
  }

  /// The layers of a named line, or of one that a segment belongs to.
  void read_layers_of(const Json& item, const std::string& name) {
    const Json* layers = JsonReader::member(item, "layers");
    if (!layers || !json_.expect_keys(*layers, {"region", "first", "growth", "count"})) return;
    if (name.empty()) return json_.fail(item, "layers need a \"name\" of the line");
    add_layers(*layers, name);
  }

  void add_layers(const Json& item, const std::string& line) {
    LayerRule rule{line, name_of(item, "region"), 0, 1, 0};
    rule.first = json_.positive(json_.required(item, "first"));
    rule.growth = json_.number(json_.required(item, "growth"));
    if (!(rule.growth >= 1)) json_.fail(item, "the growth of layers is at least 1");
    const Json* count = JsonReader::member(item, "count");
    const long number = count ? json_.integer(*count) : 0;
    if (number < 0 || number > kMostLayers)
      json_.fail(item, fmt::format("the number of layers is 0 to {}", kMostLayers));
    rule.count = static_cast<int>(number);
    if (rule.count == 0 && rule.growth == 1)
      json_.fail(item, "without a number of layers the growth must be above 1");
    input_.layers.push_back(std::move(rule));
  }

  /// The name under `key`, empty if there is none.
  std::string name_of(const Json& item, std::string_view key) {
    const Json* name = JsonReader::member(item, key);
    return name ? json_.name(*name) : std::string();
  }

  const Json& document_;
  JsonReader json_;
  TakenOut elements_;
  Team team_;
  Input input_;
  CurveCutter cutter_;
  std::optional<double> chord_error_;
  std::size_t given_points_ = 0;
  std::size_t curve_points_ = 0;
  std::map<Point, std::uint32_t> indices_;
  CircleNumbers circles_{input_.circles};
  std::size_t uneven_arcs_ = 0;  ///< whose ends are not equally far from the centre
  double most_uneven_ = 0;
};

/// What counts with maps alone does nothing here, which is told; of several files one may be a map.
void warn_of_options(const ReadOptions& o, Input& input) {
  const auto tell = [&](const std::string& name, std::string option) {
    if (name.empty()) return;
    if (o.is_one_of_several)
      return input.asked.push_back({std::move(option), name, false, "it is no map"});
    std::replace(option.begin(), option.end(), '_', '-');
    input.warnings.push_back(fmt::format("--{} does nothing: it counts with maps only", option));
  };
  tell(o.material_field, "material_field");
  tell(o.name_field, "name_field");
  tell(o.priority_field, "priority_field");
  if (o.is_one_of_several)
    for (const std::string& name : o.keep_fields) tell(name, "keep_field");
  else if (!o.keep_fields.empty())
    tell(o.keep_fields.front(), "keep_field");
}

/// Points, segments and polygons without curves, one tree at a time or none at all; nothing where
/// that does not work. Points that are no pairs are left to the whole document.
std::optional<Input> parse_own_in_parts(std::string_view text, const std::string& source,
                                        const ReadOptions& options, const Team& team) {
  TakenOut out;
  const auto pass = [&](std::string_view name, std::size_t from) -> Passed {
    if (name == "points") {
      out.points = read_pairs<double>(text, from, team);
      return {out.points.end, out.points.is_closed};
    }
    if (name == "segments") {
      out.ends = read_pairs<long>(text, from, team);
      return {out.ends.end, out.ends.is_closed};
    }
    return {from, false};
  };
  const auto split = split_json(text, {"features", "points", "segments", "polygons"}, pass);
  if (!split) return std::nullopt;
  if (split->find("features") != nullptr) {
    const auto features = split_json(text, {"features"});
    return features ? read_geojson(*features, source, options) : std::nullopt;
  }
  // Curves are cut alike in all of a document, which is looked at twice for it.
  const auto is_curved = [](std::string_view element) {
    return element.find("\"circle\"") != element.npos || element.find("\"arc\"") != element.npos ||
           element.find('\\') != element.npos;
  };
  const Result<JsonDocument> rest = parse_json_text(split->rest, source);
  if (!rest || is_geojson(rest->root())) return std::nullopt;
  for (const SplitJson::Array& array : split->arrays) {
    if (JsonReader::member(rest->root(), array.name) == nullptr ||
        std::any_of(array.elements.begin(), array.elements.end(), is_curved))
      return std::nullopt;
    if (array.name == "points" && !array.elements.empty()) return std::nullopt;
    if (array.name == "segments") out.segments = array.elements;
    if (array.name == "polygons") out.polygons = array.elements;
  }
  Result<Input> input = InputReader(rest->root(), source, std::move(out), team).read();
  if (input) warn_of_options(options, *input);
  return input ? std::optional(*std::move(input)) : std::nullopt;
}

/// By features, too; nothing where that does not work: then the whole document tells why.
std::optional<Input> parse_in_parts(std::string_view text, const std::string& source,
                                    const ReadOptions& options) {
  std::optional<Input> input;
  with_team(worker_count(options.threads),
            [&](const Team& team) { input = parse_own_in_parts(text, source, options, team); });
  return input;
}

}  // namespace

Result<Input> parse_json(std::string_view text, const std::string& source,
                         const ReadOptions& options) {
  if (std::optional<Input> input = parse_in_parts(text, source, options)) return *std::move(input);
  const Result<JsonDocument> document = parse_json_text(text, source);
  if (!document) return document.error();
  if (is_geojson(document->root())) return read_geojson(document->root(), source, options);
  Result<Input> input = InputReader(document->root(), source).read();
  if (input) warn_of_options(options, *input);
  return input;
}

}  // namespace cover
