// How much there is to draw is counted cell by cell before anything is drawn; in a window, where
// that says nothing, cells, rows and instances that are looked at are counted.
// Tested by tests/unit/io/layout/read_gds_test.cpp.
#include "io/layout/flatten.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "geom/affine.hpp"
#include "geom/box.hpp"
#include "geom/turn.hpp"
#include "geom/vector.hpp"
#include "io/input/drawings/curves.hpp"
#include "io/input/map_words.hpp"
#include "io/layout/path_outline.hpp"
#include "io/layout/window.hpp"
#include "io/text/limits.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// Where the points of a cell lie.
struct Placement : Affine {
  double magnification = 1;

  /// First `inner`, then this.
  [[nodiscard]] Placement after(const Placement& inner) const {
    return {Affine::after(inner), magnification * inner.magnification};
  }
};

/// Without its place. Quarters of a turn are exact.
Placement placement_of(const GdsReference& reference) {
  const auto [cosine, sine] = Turn::by_degrees(reference.angle);
  const double m = reference.magnification, mirror = reference.mirrored ? -1 : 1;
  return {{m * cosine, -m * sine * mirror, 0, m * sine, m * cosine * mirror, 0}, m};
}

Box grown(const Box& box, double by) {
  return {box.low + Vector{-by, -by}, box.high + Vector{by, by}};
}

Box placed(const Box& box, const Placement& place) {
  Box out;
  if (box.is_empty()) return out;
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y}) out.add(place({x, y}));
  return out;
}

Point point_of(GdsPoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// Numbers of an array from which on, and up to which, its boxes meet a window.
struct Span {
  double first;
  double last;
  /// Keeps those k for which low + k step <= window_high and high + k step >= window_low.
  void keep(double low, double high, double step, double window_low, double window_high) {
    if (step == 0) {
      if (low > window_high || high < window_low) last = first - 1;
      return;
    }
    double from = (window_low - high) / step, to = (window_high - low) / step;
    if (step < 0) std::swap(from, to);
    first = std::max(first, std::floor(from));  // one too many does no harm
    last = std::min(last, std::ceil(to));
  }
};

class Flattener {
 public:
  Flattener(const GdsLibrary& library, const std::string& source, const ReadOptions& options,
            LayerMap& layers)
      : library_(library), options_(options), layers_(layers) {
    input_.source = source;
    for (const GdsCell& cell : library.cells)
      most_shapes_ += cell.shapes.size() + cell.texts.size() + cell.references.size();
    most_points_ += library.points.size();
    per_unit_ = std::round(1 / library.unit);
    if (!(std::abs(per_unit_ * library.unit - 1) < 1e-9 && per_unit_ < 1e15)) per_unit_ = 0;
  }

  Result<Input> run() {
    input_.unit = unit_of_user();
    const std::optional<std::uint32_t> top = top_cell();
    if (top) measure(*top);
    if (!error_ && !options_.label_layer.empty()) set_label_layer();
    if (!error_ && options_.window) window_ = window_in_units(*options_.window);
    if (!error_ && !options_.window) check_amount(totals_[*top]);
    if (!error_) draw(*top, Placement());
    if (error_) return *std::move(error_);
    tell();
    if (input_.polygons.empty() && input_.lines.empty()) {
      if (const std::string why = why_empty(totals_[*top].box); !why.empty())
        return Error{ErrorCode::bad_option, fmt::format("{}: {}", input_.source, why), {}, {}};
    }
    return std::move(input_);
  }

 private:
  /// What a cell has in it, with all that its references bring.
  struct Total {
    double shapes = 0;
    double points = 0;
    Box box;
    enum class State { unknown, open, done } state = State::unknown;
  };

  void fail(ErrorCode code, const std::string& what) {
    if (!error_) error_ = Error{code, fmt::format("{}: {}", input_.source, what), {}, {}};
  }

  /// The unit of the coordinates, if it has a name here.
  [[nodiscard]] std::string unit_of_user() const {
    const double metres = library_.metres / library_.unit;
    constexpr std::array<std::pair<double, const char*>, 5> kUnits{
        {{1e-9, "nm"}, {1e-6, "um"}, {1e-3, "mm"}, {1e-2, "cm"}, {1, "m"}}};
    for (const auto& [size, name] : kUnits)
      if (std::abs(metres / size - 1) < 1e-9) return name;
    return "";
  }

  std::optional<std::uint32_t> top_cell() {
    const std::vector<GdsCell>& cells = library_.cells;
    totals_.resize(cells.size());
    if (!options_.cell.empty()) {
      for (std::uint32_t k = 0; k < cells.size(); ++k)
        if (cells[k].name == options_.cell) return k;
      fail(ErrorCode::bad_option, fmt::format("there is no cell '{}'", options_.cell));
      return std::nullopt;
    }
    std::vector<bool> referred(cells.size());
    for (const GdsCell& cell : cells)
      for (const GdsReference& reference : cell.references) referred[reference.cell] = true;
    std::vector<std::uint32_t> tops;
    for (std::uint32_t k = 0; k < cells.size(); ++k)
      if (!referred[k]) tops.push_back(k);
    if (tops.size() == 1) return tops.front();
    if (cells.empty()) {
      fail(ErrorCode::syntax, "there is no cell in it");
    } else if (tops.empty()) {
      fail(ErrorCode::unsupported_format, "every cell is in another one: cells contain themselves");
    } else {
      constexpr std::size_t kMostNamed = 8;
      std::vector<std::string> names;
      for (std::size_t k = 0; k < std::min(tops.size(), kMostNamed); ++k)
        names.push_back(legible(cells[tops[k]].name));
      if (tops.size() > kMostNamed) names.emplace_back("...");
      fail(ErrorCode::bad_option,
           fmt::format("it has {} top cells ({}): name one by --cell", tops.size(), listed(names)));
    }
    return std::nullopt;
  }

  /// Fills totals_ for a cell and all in it, without recursion of the program.
  void measure(std::uint32_t top) {
    struct Step {
      std::uint32_t cell;
      std::size_t next;
    };
    std::vector<Step> path{{top, 0}};
    totals_[top].state = Total::State::open;
    while (!path.empty()) {
      Step& step = path.back();
      const GdsCell& cell = library_.cells[step.cell];
      if (step.next == cell.references.size()) {
        sum_up(step.cell);
        path.pop_back();
        continue;
      }
      const std::uint32_t inner = cell.references[step.next++].cell;
      Total& total = totals_[inner];
      if (total.state == Total::State::open)
        return fail(
            ErrorCode::unsupported_format,
            fmt::format("the cell '{}' contains itself", legible(library_.cells[inner].name)));
      if (total.state == Total::State::done) continue;
      if (path.size() >= kCellDepth)
        return fail(ErrorCode::unsupported_format,
                    fmt::format("more than {} cells, one in the other", kCellDepth));
      total.state = Total::State::open;
      path.push_back({inner, 0});
    }
  }

  void sum_up(std::uint32_t number) {
    const GdsCell& cell = library_.cells[number];
    Total& total = totals_[number];
    for (const GdsShape& shape : cell.shapes) {
      ++total.shapes;
      total.points += shape.count;
      total.box.include(box_of(shape));
    }
    for (const GdsText& text : cell.texts) {
      ++total.shapes;
      total.box.add(point_of(text.at));
    }
    for (const GdsReference& reference : cell.references) {
      const Total& inner = totals_[reference.cell];
      const double times = static_cast<double>(reference.columns) * reference.rows;
      total.shapes += times * std::max(1.0, inner.shapes);  // an empty cell takes time too
      total.points += times * inner.points;
      const Placement place = placement_of(reference);
      const Box box = placed(inner.box, place);
      if (box.is_empty()) continue;
      for (const double column : {0.0, reference.columns - 1.0})
        for (const double row : {0.0, reference.rows - 1.0}) {
          const Point at = at_of(reference, column, row);
          Box moved = box;
          moved.low.x += at.x, moved.high.x += at.x, moved.low.y += at.y, moved.high.y += at.y;
          total.box.include(moved);
        }
    }
    total.state = Total::State::done;
  }

  [[nodiscard]] Box box_of(const GdsShape& shape) const {
    Box box;
    for (std::uint32_t k = 0; k < shape.count; ++k)
      box.add(point_of(library_.points[shape.first + k]));
    if (shape.path == GdsShape::kPolygon) return box;
    const GdsPath& path = library_.paths[shape.path];
    // A mitre reaches twice as far as the side.
    const double width = std::abs(static_cast<double>(path.width));
    const double more =
        std::max({0.0, static_cast<double>(path.begin), static_cast<double>(path.end)});
    return grown(box, width + more);
  }

  static Point at_of(const GdsReference& reference, double column, double row) {
    // Captured by name: clang 14 does not capture structured bindings.
    const auto along = [&, &first = reference.at[0], &columns = reference.at[1],
                        &rows = reference.at[2]](auto member) {
      const double start = first.*member;
      return start + (columns.*member - start) * column / reference.columns +
             (rows.*member - start) * row / reference.rows;
    };
    return {along(&GdsPoint::x), along(&GdsPoint::y)};
  }

  void check_amount(const Total& total) {
    if (total.shapes > static_cast<double>(most_shapes_) ||
        total.points > static_cast<double>(most_points_))
      too_much(fmt::format("{:.6g} shapes with {:.6g} points", total.shapes, total.points));
  }

  void too_much(const std::string& what) {
    fail(ErrorCode::unsupported_format,
         fmt::format("the layout has {}, at most {} and {} are drawn: choose a part by --window or "
                     "--cell",
                     what, most_shapes_, most_points_));
  }

  /// Counts one more thing that is looked at; false after too many.
  bool count(std::size_t points) {
    looked_at_ += 1;
    points_ += points;
    if (looked_at_ > most_shapes_ || points_ > most_points_)
      too_much("too many shapes in the window");
    return !error_;
  }

  void set_label_layer() {
    label_ = parse_layer_pattern(options_.label_layer);
    if (!label_ && !options_.is_one_of_several)
      return fail(
          ErrorCode::bad_option,
          fmt::format("label_layer: '{}' is not a layer, as 68 or 68/5", options_.label_layer));
    std::set<std::pair<std::int16_t, std::int16_t>> layers;
    for (const GdsCell& cell : library_.cells)
      for (const GdsText& text : cell.texts) {
        layers.emplace(text.layer.layer, text.layer.type);
        has_labels_ |= label_ && label_->matches(text.layer);
      }
    std::vector<std::string> names;
    for (const auto& [layer, type] : layers) names.push_back(fmt::format("{}/{}", layer, type));
    AskedNames asked;
    asked.note("label_layer", options_.label_layer, has_labels_,
               no_text_on(options_.label_layer, std::move(names)));
    error_ = asked.settle(options_, input_);
  }

  /// The window in units of the database.
  [[nodiscard]] Box window_in_units(const Window& window) const {
    Box box;
    box.add(Point{window.low.x / library_.unit, window.low.y / library_.unit});
    box.add(Point{window.high.x / library_.unit, window.high.y / library_.unit});
    return grown(box, 1);  // what rounding might do; exactly it is cut later
  }

  void draw(std::uint32_t number, const Placement& place) {
    const GdsCell& cell = library_.cells[number];
    for (const GdsShape& shape : cell.shapes) {
      if (!count(shape.count)) return;
      if (window_ && !placed(box_of(shape), place).meets(*window_)) continue;
      draw(shape, place);
    }
    for (const GdsText& text : cell.texts) {
      if (!count(1)) return;
      draw(text, place);
    }
    for (const GdsReference& reference : cell.references) {
      draw(reference, place);
      if (error_) return;
    }
  }

  void draw(const GdsReference& reference, const Placement& place) {
    Placement inner = placement_of(reference);
    const Box& whole = totals_[reference.cell].box;
    if (whole.is_empty()) return;
    const Box box = placed(whole, place.after(inner));
    const Placement steps = place;
    const Point first = at_of(reference, 0, 0), next = at_of(reference, 1, 0);
    const double step_x = steps.a * (next.x - first.x) + steps.b * (next.y - first.y);
    const double step_y = steps.d * (next.x - first.x) + steps.e * (next.y - first.y);
    for (double row = 0; row < reference.rows; ++row) {
      Span span{0, reference.columns - 1.0};
      if (window_) {
        if (!count(0)) return;
        const Point start = at_of(reference, 0, row);
        const double x = place.a * start.x + place.b * start.y;
        const double y = place.d * start.x + place.e * start.y;
        span.keep(box.low.x + x, box.high.x + x, step_x, window_->low.x, window_->high.x);
        span.keep(box.low.y + y, box.high.y + y, step_y, window_->low.y, window_->high.y);
      }
      for (double column = span.first; column <= span.last; ++column) {
        if (!count(0)) return;
        const Point at = at_of(reference, column, row);
        inner.c = at.x;
        inner.f = at.y;
        draw(reference.cell, place.after(inner));
        if (error_) return;
      }
    }
  }

  /// A point in units of the database, in the unit of the user.
  [[nodiscard]] Point in_user_unit(Point p) const {
    if (per_unit_ > 0) return {p.x / per_unit_, p.y / per_unit_};
    return {p.x * library_.unit, p.y * library_.unit};
  }

  void draw(const GdsShape& shape, const Placement& place) {
    const NamedLayer* layer = layers_.find(shape.layer);
    if (layer == nullptr) return;
    std::vector<Point> points;
    points.reserve(shape.count);
    for (std::uint32_t k = 0; k < shape.count; ++k)
      points.push_back(point_of(library_.points[shape.first + k]));
    if (shape.path == GdsShape::kPolygon) return add_polygon(std::move(points), *layer, place);
    const GdsPath& path = library_.paths[shape.path];
    if (path.width == 0) return add_line(points, *layer, place);
    WidePath wide;
    wide.line = std::move(points);
    wide.half_width = path.width / 2.0;
    if (path.width < 0) wide.half_width /= -place.magnification;
    wide.round = path.ends == 1;
    wide.step = options_.chord_angle;
    wide.begin = path.ends == 2 ? wide.half_width : path.ends == 4 ? path.begin : 0;
    wide.end = path.ends == 2 ? wide.half_width : path.ends == 4 ? path.end : 0;
    if (wide.round && options_.chord_error)
      wide.step = std::min(
          wide.step, step_for_chord_error(wide.half_width * library_.unit * place.magnification,
                                          *options_.chord_error));
    for (std::vector<Point>& polygon : path_polygons(std::move(wide))) {
      if (!count(polygon.size())) return;
      add_polygon(std::move(polygon), *layer, place);
    }
  }

  void move(std::vector<Point>& points, const Placement& place) const {
    for (Point& p : points) p = in_user_unit(place(p));
  }

  void add_polygon(std::vector<Point> points, const NamedLayer& layer, const Placement& place) {
    move(points, place);
    if (options_.window) points = clip_polygon(std::move(points), *options_.window);
    if (points.empty()) return;
    InputPolygon polygon;
    polygon.material = polygon.region = layer.name;
    polygon.priority = layer.height;
    polygon.id = static_cast<long>(input_.polygons.size());
    polygon.rings.push_back(std::move(points));
    input_.polygons.push_back(std::move(polygon));
  }

  void add_line(std::vector<Point> points, const NamedLayer& layer, const Placement& place) {
    move(points, place);
    std::vector<std::vector<Point>> pieces;
    if (options_.window) {
      pieces = clip_line(points, *options_.window);
    } else {
      pieces.push_back(std::move(points));
    }
    for (std::vector<Point>& piece : pieces)
      input_.lines.push_back(
          {layer.name, std::move(piece), static_cast<long>(input_.lines.size())});
  }

  void draw(const GdsText& text, const Placement& place) {
    if (!label_ || !label_->matches(text.layer) || text.text.empty()) return;
    const Point at = in_user_unit(place(point_of(text.at)));
    if (options_.window) {
      const auto& [low, high] = *options_.window;
      if (!(low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y)) return;
      if (!(low.x < at.x && at.x < high.x && low.y < at.y && at.y < high.y)) {
        if (labels_on_border_++ == 0)
          first_on_border_ = fmt::format("'{}' at {}", text.text, describe(at));
        return;
      }
    }
    RegionSeed seed;
    seed.at = at;
    seed.region = text.text;
    seed.id = static_cast<long>(input_.seeds.size());
    seed.label_layer = options_.label_layer;
    input_.seeds.push_back(std::move(seed));
  }

  void tell() {
    if (const std::size_t n = library_.left_out; n > 0)
      input_.warnings.push_back(fmt::format(
          "{} without an area left out", n == 1 ? "1 shape is" : fmt::format("{} shapes are", n)));
    if (library_.absolute > 0)
      input_.warnings.push_back(fmt::format(
          "{} placed with absolute angle or size: taken as relative",
          library_.absolute == 1 ? "1 cell is" : fmt::format("{} cells are", library_.absolute)));
    if (!input_.polygons.empty() || !input_.lines.empty()) {
      for (const std::string& choice : layers_.choices_of_nothing())
        input_.warnings.push_back(fmt::format("no shape is on the layer '{}'", legible(choice)));
    }
    if (labels_on_border_ > 0)
      input_.warnings.push_back(fmt::format(
          "{} on the border of the window, where faces end, and left out: {}{}",
          counted(labels_on_border_, "label") + (labels_on_border_ == 1 ? " is" : " are"),
          labels_on_border_ == 1 ? "" : "the first is ", first_on_border_));
    if (has_labels_ && input_.seeds.empty() && labels_on_border_ == 0)
      input_.warnings.push_back(
          fmt::format("no text on the layer '{}' is in what is drawn: no region has a name of it",
                      legible(options_.label_layer)));
    if (options_.layer_map.empty()) return;
    if (const std::string names = names_of(layers_.not_in_map()); !names.empty())
      input_.warnings.push_back("layers that the layer map does not have are left out: " + names);
  }

  [[nodiscard]] static std::string names_of(const std::vector<GdsLayer>& layers) {
    std::vector<std::string> names;
    for (const GdsLayer layer : layers)
      names.push_back(fmt::format("{}/{}", layer.layer, layer.type));
    constexpr std::size_t kMostNamed = 20;
    const bool all = names.size() <= kMostNamed;
    if (!all) names.resize(kMostNamed);
    return listed(names) + (all ? "" : ", ...");
  }

  /// Where nothing was drawn: what there would have been; empty: nothing at all.
  [[nodiscard]] std::string why_empty(const Box& all) {
    const std::string others = names_of(layers_.left_out());
    const std::string window =
        !options_.window || all.is_empty()
            ? ""
            : fmt::format("the window; the layout is from {} to {}",
                          describe(in_user_unit(all.low)), describe(in_user_unit(all.high)));
    if (others.empty()) return window.empty() ? "" : "nothing is in " + window;
    return "nothing is on the layers chosen" + (window.empty() ? "" : " in " + window) +
           "; other layers are " + others;
  }

  const GdsLibrary& library_;
  const ReadOptions& options_;
  LayerMap& layers_;
  Input input_;
  std::vector<Total> totals_;  ///< by cell
  std::optional<Box> window_;  ///< in units of the database
  std::optional<LayerPattern> label_;
  bool has_labels_ = false;           ///< in any cell
  std::size_t labels_on_border_ = 0;  ///< of the window
  std::string first_on_border_;
  double per_unit_ = 0;  ///< database units in one of the user, where that is a whole number
  std::size_t most_shapes_ = kLayoutShapes;  ///< and what the file has itself
  std::size_t most_points_ = kLayoutPoints;
  std::size_t looked_at_ = 0;
  std::size_t points_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<Input> flatten(const GdsLibrary& library, const std::string& source,
                      const ReadOptions& options, LayerMap& layers) {
  return Flattener(library, source, options, layers).run();
}

}  // namespace cover
