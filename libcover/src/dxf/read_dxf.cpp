// The file is checked group by group, dxflib builds a drawing of what is left, blocks are placed,
// and curves are cut: first all arcs are shown to the CurveCutter, then points are asked for.
// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include <cover/read_dxf.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/core.h>

#include <cover/angle.hpp>
#include <cover/text.hpp>
#include <cover/units.hpp>

#include "base/faults/out_of_memory.hpp"
#include "dxf/drawing.hpp"
#include "dxf/dxf_groups.hpp"
#include "dxf/ends.hpp"
#include "dxf/ends_on_lines.hpp"
#include "dxf/place_blocks.hpp"
#include "dxf/spline.hpp"
#include "geom/curves/arc.hpp"
#include "geom/turn.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"
#include "io/input/drawings/curves.hpp"
#include "io/input/map_words.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// More points than this from the curves of one file are taken for a mistake.
constexpr std::size_t kMostDxfPoints = std::size_t{1} << 22U;

/// Ends of lines that are no farther apart than so many units in the last place are united without
/// a word, where one of them is computed: ends of arcs, and what blocks that are turned move.
constexpr double kUlpsUnsaid = 4;

using Path = std::vector<Point>;

/// "1 entity is", "2 entities are".
std::string several(std::size_t n, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

class DxfConverter {
 public:
  DxfConverter(const PlacedDrawing& placed, const CheckedDxf& checked, const std::string& source,
               const ReadOptions& options)
      : placed_(placed), checked_(checked), options_(options) {
    input_.source = source;
  }

  Result<Input> run() {
    choose_curves();
    choose_layers();
    for (const Placed<DxfCurve>* curve : curves_) note(*curve);
    ends_ = CurveEnds(size_);
    for (const Placed<DxfCurve>* curve : curves_) note_given_ends(*curve);
    std::sort(given_.begin(), given_.end());
    for (const Placed<DxfCurve>* curve : curves_) note_arc_ends(*curve);
    for (const Placed<DxfCurve>* curve : curves_) {
      add(*curve);
      if (error_) return *std::move(error_);
    }
    bend_lines();
    add_points();
    add_texts();
    if (error_) return *std::move(error_);
    if (input_.segments.empty() && (input_.points.empty() || !options_.is_one_of_several))
      return nothing_drawn();
    tell_of_layers();
    tell();
    return std::move(input_);
  }

 private:
  [[nodiscard]] Error nothing_drawn() const {
    std::string message = input_.source + ": no line or curve in it";
    if (options_.layers.empty()) {
      for (const std::string& sentence : about_hidden()) message += "; " + sentence;
    } else {
      message += " on the layers that are read" + others(layers_drawn());
    }
    return {options_.layers.empty() ? ErrorCode::syntax : ErrorCode::bad_option, message, {}, {}};
  }

  [[nodiscard]] std::vector<std::string> about_hidden() const {
    std::vector<std::string> sentences;
    if (checked_.invisible > 0)
      sentences.push_back(several(checked_.invisible, "entity is", "entities are") +
                          " invisible: left out");
    if (checked_.in_paper_space > 0)
      sentences.push_back(several(checked_.in_paper_space, "entity is", "entities are") +
                          " in paper space: left out");
    if (hidden_ > 0)
      sentences.push_back(
          fmt::format("{} left out on hidden layers: {}; --layer reads those it names",
                      several(hidden_, "line or curve is", "lines and curves are"),
                      listed(some(hiding_layers_))));
    if (hidden_points_ > 0)
      sentences.push_back(several(hidden_points_, "point is", "points are") +
                          " left out on hidden layers");
    return sentences;
  }

  /// Layers that options name are read even where they are hidden.
  void choose_curves() {
    std::set<std::string> wanted;
    for (const std::string& layer : options_.layers) wanted.insert(lower(layer));
    for (const Placed<DxfCurve>& curve : placed_.curves) {
      const std::string hiding = wanted.empty() ? hiding_layer(curve) : "";
      if (!hiding.empty()) {
        hiding_layers_.insert(hiding);
        ++hidden_;
      } else if (wanted.empty() || wanted.contains(lower(*curve.layer))) {
        curves_.push_back(&curve);
      }
    }
    for (const Placed<DxfPoint>& point : placed_.points) {
      if (wanted.empty() && !hiding_layer(point).empty())
        ++hidden_points_;
      else if (wanted.empty() || wanted.contains(lower(*point.layer)))
        points_.push_back(&point);
    }
  }

  /// "Aux (frozen)", the layer that hides a thing; empty: none does. Points that dimensions measure
  /// from are on a layer that CAD programs never print.
  template <class Thing>
  [[nodiscard]] std::string hiding_layer(const Placed<Thing>& thing) const {
    if (thing.frozen != nullptr) return *thing.frozen + " (frozen)";
    const std::string layer = lower(*thing.layer);
    const auto found = checked_.hidden.find(layer);
    if (found != checked_.hidden.end())
      return *thing.layer + (found->second.frozen ? " (frozen)" : " (off)");
    return layer == "defpoints" ? *thing.layer + " (never printed)" : "";
  }

  /// Those of all lines, curves and points.
  [[nodiscard]] std::set<std::string> layers_drawn() const {
    std::set<std::string> layers;
    for (const Placed<DxfCurve>& curve : placed_.curves) layers.insert(*curve.layer);
    for (const Placed<DxfPoint>& point : placed_.points) layers.insert(*point.layer);
    return layers;
  }

  /// "; its layers: a, b", of what is drawn.
  [[nodiscard]] static std::string others(const std::set<std::string>& layers) {
    return layers.empty() ? "" : "; its layers: " + listed(some(layers));
  }

  /// The first of many names.
  [[nodiscard]] static std::vector<std::string> some(const std::set<std::string>& layers) {
    constexpr std::size_t kMostNamed = 12;
    std::vector<std::string> names(layers.begin(), layers.end());
    if (names.size() <= kMostNamed) return names;
    names.resize(kMostNamed);
    names.emplace_back("...");
    return names;
  }

  /// Layers that were asked for, on which nothing is drawn.
  void tell_of_layers() {
    const std::set<std::string> layers = layers_drawn();
    for (const std::string& wanted : options_.layers) {
      if (std::any_of(layers.begin(), layers.end(),
                      [&](const std::string& layer) { return lower(layer) == lower(wanted); }))
        continue;
      input_.warnings.push_back(
          fmt::format("no line or curve is on the layer '{}'{}", wanted, others(layers)));
    }
  }

  /// A name that all segments have tells nothing, unless other files are joined with this one.
  void choose_layers() {
    std::set<std::string> layers;
    for (const Placed<DxfCurve>* curve : curves_) layers.insert(*curve->layer);
    named_ = layers.size() > 1 || options_.is_one_of_several;
  }

  [[nodiscard]] double step_for(double radius) const {
    return options_.chord_error && radius > 0
               ? std::min(options_.chord_angle, step_for_chord_error(radius, *options_.chord_error))
               : options_.chord_angle;
  }

  /// The arc as it is seen in the drawing.
  /// REQUIRES: place.is_similar()
  [[nodiscard]] Arc placed(const DxfArc& arc, const Affine& place) const {
    Arc out{place(arc.centre), arc.radius, arc.from, arc.to, 0};
    if (!place.is_identity()) {
      out.radius *= std::hypot(place.a, place.d);
      const double turn = Angle::radians(std::atan2(place.d, place.a)).in_degrees();
      const double way = place.is_mirrored() ? -1 : 1;
      out.from = turn + way * arc.from;
      out.to = is_full_turn(arc.from, arc.to) ? out.from + way * 360 : turn + way * arc.to;
    }
    out.step = step_for(out.radius);
    return out;
  }

  /// Shows arcs to the cutter, and finds out how large the drawing is.
  void note(const Placed<DxfCurve>& curve) {
    const auto reach = [&](Point p) {
      const Point q = curve.place(p);
      if (std::isfinite(q.x) && std::isfinite(q.y))
        size_ = std::max({size_, std::abs(q.x), std::abs(q.y)});
    };
    if (const auto* line = std::get_if<BulgePolyline>(&curve.thing->shape))
      for (const BulgeCorner& corner : line->corners) reach(corner.at);
    if (const auto* spline = std::get_if<DxfSpline>(&curve.thing->shape))
      for (const Point p : spline->controls) reach(p);
    if (const auto* e = std::get_if<DxfEllipse>(&curve.thing->shape)) {
      reach({e->centre.x + e->major.x, e->centre.y + e->major.y});
      reach({e->centre.x - e->major.x, e->centre.y - e->major.y});
    }
    if (const auto* arc = std::get_if<DxfArc>(&curve.thing->shape)) {
      reach({arc->centre.x + arc->radius, arc->centre.y + arc->radius});
      reach({arc->centre.x - arc->radius, arc->centre.y - arc->radius});
      if (curve.place.is_similar()) cutter_.add(placed(*arc, curve.place));
    }
  }

  void note_given_ends(const Placed<DxfCurve>& curve) {
    if (const auto* line = std::get_if<BulgePolyline>(&curve.thing->shape))
      for (const BulgeCorner& corner : line->corners) {
        ends_.add(curve.place(corner.at));
        if (curve.place.is_identity() && std::isfinite(corner.at.x) && std::isfinite(corner.at.y))
          given_.push_back(corner.at);
      }
    const auto* spline = std::get_if<DxfSpline>(&curve.thing->shape);
    if (spline == nullptr || spline->controls.empty()) return;
    ends_.add(curve.place(spline->controls.front()));
    ends_.add(curve.place(spline->controls.back()));
  }

  void note_arc_ends(const Placed<DxfCurve>& curve) {
    const auto* arc = std::get_if<DxfArc>(&curve.thing->shape);
    if (arc == nullptr || !curve.place.is_similar()) return;
    const Arc seen = placed(*arc, curve.place);
    if (seen.full()) return;
    ends_.add(point_on_circle(seen.centre, seen.radius, seen.from));
    ends_.add(point_on_circle(seen.centre, seen.radius, seen.to));
  }

  void add(const Placed<DxfCurve>& curve) {
    curve_layer_ = curve.layer;
    layer_ = named_ && *curve.layer != "0" ? curve.layer : nullptr;
    std::visit([&](const auto& shape) { add(shape, curve.place); }, curve.thing->shape);
    ++number_;
  }

  void add(const DxfArc& arc, const Affine& place) {
    if (place.is_similar()) {
      const Arc seen = placed(arc, place);
      return add_path(cutter_.points(seen, room()), ArcCircle{seen.centre, seen.radius});
    }
    add(DxfEllipse{arc.centre, {arc.radius, 0}, {0, arc.radius}, arc.from, arc.to}, place);
  }

  void add(const DxfEllipse& e, const Affine& place) {
    const Affine shape{e.major.x, e.minor.x, e.centre.x, e.major.y, e.minor.y, e.centre.y};
    const Affine whole = place.after(shape);
    const double radius = std::max(std::hypot(whole.a, whole.d), std::hypot(whole.b, whole.e));
    const double pieces = std::max(is_full_turn(e.from, e.to) ? 3.0 : 1.0,
                                   std::ceil((e.to - e.from) / step_for(radius) - 1e-9));
    if (!(pieces < static_cast<double>(room()))) return too_many();
    Path path;
    for (double k = 0; k <= pieces; ++k)
      path.push_back(whole(point_on_circle({0, 0}, 1, e.from + (e.to - e.from) * k / pieces)));
    if (is_full_turn(e.from, e.to)) path.back() = path.front();
    add_path(std::move(path));
  }

  void add(const BulgePolyline& line, const Affine& place) {
    if (line.wide) ++wide_[*curve_layer_];
    const std::size_t n = line.corners.size();
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < n; ++k) {
      const BulgeCorner& corner = line.corners[k];
      add_bulge(corner.at, line.corners[(k + 1) % n].at, corner.bulge, place);
    }
  }

  void add_bulge(Point a, Point b, double bulge, const Affine& place) {
    const Point centre = midpoint(a, b) + ((1 - bulge * bulge) / (4 * bulge)) * left_normal(b - a);
    if (a == b || bulge == 0 || !std::isfinite(centre.x) || !std::isfinite(centre.y)) {
      note_united(place(a), place.is_identity());
      note_united(place(b), place.is_identity());
      return add_path(Path{place(a), place(b)});
    }
    const double radius =
        length(a - centre) * std::max(std::hypot(place.a, place.d), std::hypot(place.b, place.e));
    const double step = step_for(radius);
    if (!place.is_similar()) {
      auto path = cut_arc_between(a, b, centre, bulge < 0, step, room());
      if (path)
        for (Point& p : *path) p = place(p);
      return add_path(std::move(path));
    }
    const bool clockwise = (bulge < 0) != place.is_mirrored();
    const Point seen = place(centre);
    add_path(cut_arc_between(place(a), place(b), seen, clockwise, step, room()),
             ArcCircle{seen, length(place(a) - seen)});
  }

  void add(const DxfSpline& spline, const Affine& place) {
    const double size = std::max(std::hypot(place.a, place.d), std::hypot(place.b, place.e));
    std::optional<double> error = options_.chord_error;
    if (error && size > 0) *error /= size;
    auto path = spline_points(spline, options_.chord_angle, error);
    if (!path) {
      ++bad_splines_;
      return;
    }
    if (spline.controls.empty()) ++fit_splines_;
    for (Point& p : *path) p = place(p);
    add_path(std::move(path));
  }

  [[nodiscard]] std::size_t room() const { return kMostDxfPoints - input_.segments.size(); }

  void too_many() {
    if (!error_)
      error_ = Error{ErrorCode::unsupported_format,
                     fmt::format("{}: the curves of this file have more than {} points; is the "
                                 "chord error given in the unit of the file?",
                                 input_.source, kMostDxfPoints),
                     {},
                     {}};
  }

  void too_large(std::string_view what) {
    error_ = Error{ErrorCode::non_finite_coordinate,
                   fmt::format("{}: a {} has coordinates that are too large for a double",
                               input_.source, what),
                   {},
                   {}};
  }

  /// Notes an end of a line that is taken for another though both are `given` as they are, or it
  /// is farther off than rounding takes it.
  void note_united(Point p, bool given) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    const Point q = ends_.same(p);
    if (p == q) return;
    const double away = std::max(std::abs(p.x - q.x), std::abs(p.y - q.y));
    const bool are_given = given && is_given(q);
    if (!are_given && away <= kUlpsUnsaid * spacing_at(size_)) return;
    if (!united_.insert(p).second) return;
    input_.changes.push_back(
        {Change::Kind::welded,
         fmt::format("an end of curve {} at {} was moved by {} onto the end of another at {}",
                     number_, describe(p), describe_roughly(away), describe(q)),
         {p, q},
         {{InputKind::segment, number_}}});
  }

  [[nodiscard]] bool is_given(Point p) const {
    return std::binary_search(given_.begin(), given_.end(), p);
  }

  /// A line through an end that rounding took off it is told where both are given as they are.
  void bend_lines() {
    for (const EndOnLine& bent : bend_to_ends(input_, kUlpsUnsaid * spacing_at(size_))) {
      if (!is_given(bent.end) || !is_given(bent.a) || !is_given(bent.b)) continue;
      input_.changes.push_back(
          {Change::Kind::welded,
           fmt::format("curve {}, straight from {} to {}, was bent by {} to an end at {}",
                       bent.line, describe(bent.a), describe(bent.b), describe_roughly(bent.away),
                       describe(bent.end)),
           {bent.end},
           {{InputKind::segment, bent.line}}});
    }
  }

  /// Points along a curve; all of them on `circle`, if there is one.
  void add_path(std::optional<Path> path, const std::optional<ArcCircle>& circle = {}) {
    if (!path || path->size() > room()) return too_many();
    const std::uint32_t number =
        circle && circle->radius > 0 && std::isfinite(circle->radius) ? circles_.of(*circle) : 0;
    InputSegment segment;
    if (layer_ != nullptr) segment.name = *layer_;
    for (std::size_t k = 0; k + 1 < path->size(); ++k) {
      Point a = (*path)[k], b = (*path)[k + 1];
      if (!std::isfinite(a.x) || !std::isfinite(a.y) || !std::isfinite(b.x) || !std::isfinite(b.y))
        return too_large("curve");
      a = ends_.same(a);
      b = ends_.same(b);
      if (a == b) continue;
      segment.a = index_of(a);
      segment.b = index_of(b);
      segment.id = number_;
      const bool is_off = number > 0 && (is_off_circle(*circle, a) || is_off_circle(*circle, b));
      segment.circle = is_off ? 0 : number;
      input_.segments.push_back(segment);
    }
  }

  std::uint32_t index_of(Point p) {
    const auto next = static_cast<std::uint32_t>(input_.points.size());
    const auto [at, is_new] = indices_.emplace(p, next);
    if (is_new) input_.points.push_back(p);
    return at->second;
  }

  /// Points are called as their layer; one at an end of a curve is that end.
  void add_points() {
    for (const Placed<DxfPoint>* point : points_) {
      const Point at = ends_.same(point->place(point->thing->at));
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) return too_large("point");
      const std::uint32_t index = index_of(at);
      if (*point->layer != "0") input_.point_names.push_back({index, *point->layer});
    }
  }

  void add_texts() {
    std::set<std::string> layers;
    for (const Placed<DxfText>& text : placed_.texts) {
      layers.insert(*text.layer);
      if (options_.label_layer.empty() || lower(*text.layer) != lower(options_.label_layer)) {
        ++other_texts_;
        continue;
      }
      const Point at = text.place(text.thing->at);
      const std::string& words = text.thing->text;
      const auto id = static_cast<long>(input_.seeds.size() + input_.holes.size());
      if (lower(words) == "void") {
        input_.holes.push_back({at, id, 0, *text.layer});
        continue;
      }
      const std::size_t slash = std::min(words.find('/'), words.size());
      RegionSeed seed;
      seed.at = at;
      seed.material = words.substr(0, slash);
      if (slash < words.size()) seed.region = words.substr(slash + 1);
      seed.id = id;
      seed.label_layer = *text.layer;
      if (!seed.material.empty() || !seed.region.empty()) input_.seeds.push_back(std::move(seed));
    }
    if (options_.label_layer.empty()) return;
    const bool is_there = !input_.seeds.empty() || !input_.holes.empty();
    AskedNames asked;
    asked.note("label_layer", options_.label_layer, is_there,
               no_text_on(options_.label_layer, {layers.begin(), layers.end()}));
    input_.seeds_may_miss = is_there;
    error_ = asked.settle(options_, input_);
  }

  void tell() {
    const auto warn = [&](std::size_t count, std::string_view one, std::string_view more,
                          std::string_view what) {
      if (count == 0) return;
      input_.warnings.push_back(several(count, one, more));
      input_.warnings.back() += what;
    };
    tell_of_widths();
    warn(fit_splines_, "spline has", "splines have",
         " fit points only: they are joined by straight lines");
    warn(bad_splines_, "spline whose knots do not fit its points is",
         "splines whose knots do not fit their points are", " left out");
    if (options_.label_layer.empty())
      warn(other_texts_, "text is", "texts are",
           " left out; --label-layer makes names of regions of those on one layer");
    for (std::string& sentence : about_hidden()) input_.warnings.push_back(std::move(sentence));
    if (!placed_.missing.empty())
      input_.warnings.push_back(
          fmt::format("blocks that are inserted and not there: {}", listed(placed_.missing)));
  }

  /// A width may be that of a trace, or of the pen.
  void tell_of_widths() {
    std::size_t count = 0;
    std::set<std::string> layers;
    for (const auto& [layer, polylines] : wide_) {
      count += polylines;
      layers.insert(fmt::format("{} on '{}'", polylines, layer));
    }
    if (count > 0)
      input_.warnings.push_back(
          fmt::format("{} a width, {}: what is read is the line in the middle",
                      several(count, "polyline has", "polylines have"), listed(some(layers))));
  }

  const PlacedDrawing& placed_;
  const CheckedDxf& checked_;
  const ReadOptions& options_;
  std::vector<const Placed<DxfCurve>*> curves_;  ///< those that are read
  std::set<std::string> hiding_layers_;
  std::vector<const Placed<DxfPoint>*> points_;  ///< those that are read
  std::size_t hidden_ = 0, hidden_points_ = 0;   ///< lines and curves on these, and points
  std::map<std::string, std::size_t> wide_;      ///< number of polylines with a width, by layer
  Input input_;
  CurveCutter cutter_;
  CircleNumbers circles_{input_.circles};
  double size_ = 0;  ///< largest coordinate
  CurveEnds ends_{0};
  std::map<Point, std::uint32_t> indices_;
  bool named_ = false;
  const std::string* curve_layer_ = nullptr;  ///< of the curve that is added
  const std::string* layer_ = nullptr;        ///< its name; nullptr: none
  long number_ = 0;                           ///< of the curve
  std::size_t bad_splines_ = 0, fit_splines_ = 0, other_texts_ = 0;
  std::set<Point> united_;    ///< ends that were moved
  std::vector<Point> given_;  ///< corners of lines that no block places; sorted
  std::optional<Error> error_;
};

/// Notes what the drawing says of its unit.
void set_unit(Input& input, int unit) {
  static const std::map<int, const char*> units{
      {1, "inches"}, {2, "feet"},        {3, "miles"},          {4, "mm"},
      {5, "cm"},     {6, "m"},           {7, "kilometres"},     {8, "microinches"},
      {9, "mils"},   {10, "yards"},      {11, "angstroms"},     {12, "nm"},
      {13, "um"},    {14, "decimetres"}, {21, "US survey feet"}};
  const auto known = units.find(unit);
  if (known == units.end()) return;
  (is_length_unit(known->second) ? input.unit : input.other_unit) = known->second;
}

void tell_left_out(Input& input, const CheckedDxf& checked, const DxfDrawing& drawing) {
  std::vector<std::string> kinds;
  for (const auto& [kind, count] : checked.left_out)
    kinds.push_back(fmt::format("{} {}", count, kind));
  constexpr std::size_t kMostNamed = 20;
  if (kinds.size() > kMostNamed) kinds.resize(kMostNamed);
  if (!kinds.empty())
    input.warnings.push_back(fmt::format("entities that are not read: {}", listed(kinds)));
  if (drawing.tilted > 0)
    input.warnings.push_back(several(drawing.tilted, "entity is", "entities are") +
                             " not in the plane: left out");
  if (drawing.without_radius > 0)
    input.warnings.push_back(several(drawing.without_radius, "circle or arc", "circles and arcs") +
                             " whose radius is not positive: left out");
  if (drawing.meshes > 0)
    input.warnings.push_back(
        several(drawing.meshes, "polyline is a surface", "polylines are surfaces") + ": left out");
  if (drawing.in_space > 0)
    input.warnings.push_back(
        several(drawing.in_space, "line or curve runs", "lines and curves run") +
        " through space: z is dropped");
}

}  // namespace

namespace {

Result<Input> input_of_dxf(std::string_view text, const std::string& source,
                           const ReadOptions& options) {
  const Result<CheckedDxf> checked = check_dxf(text, source);
  if (!checked) return checked.error();
  const Result<DxfDrawing> drawing = build_drawing(*checked, source);
  if (!drawing) return drawing.error();
  const Result<PlacedDrawing> placed = place_blocks(*drawing, source, checked->hidden);
  if (!placed) return placed.error();
  Result<Input> input = DxfConverter(*placed, *checked, source, options).run();
  if (!input) return input;
  tell_left_out(*input, *checked, *drawing);
  set_unit(*input, checked->unit);
  if (Status status = apply_units(*input, options); !status) return std::move(status).error();
  return input;
}

}  // namespace

Result<Input> parse_dxf(std::string_view text, const std::string& source,
                        const ReadOptions& options) {
  if (const Status status = check_read_options(options); !status) return status.error();
  return memory_as_value(source, [&] { return input_of_dxf(text, source, options); });
}

Result<Input> read_dxf(const std::string& path, const ReadOptions& options) {
  const Result<std::string> text = memory_as_value(path, [&] { return read_file(path); });
  if (!text) return text.error();
  return parse_dxf(*text, path, options);
}

}  // namespace cover
