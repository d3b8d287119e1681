// Commands of the Sentaurus Structure Editor, which are Scheme. Bodies become painted polygons:
// with the boolean ABA, which is the default, the new one wins where they overlap, with BAB the old
// ones. A contact is put on an edge by a place on it. The editor's edges end at every corner and
// crossing of bodies, so the side that the place lies on is cut there. Commands of doping and
// meshing are named in a warning; what is not understood may make geometry, so that it is a change.
// y points as the deck has it.
// Tested by tests/unit/io/input/drawings/read_sde_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "geom/foot.hpp"
#include "geom/rings/place_in_ring.hpp"
#include "geom/vector.hpp"
#include "io/input/drawings/curves.hpp"
#include "io/input/drawings/scheme_values.hpp"
#include "io/input/formats.hpp"

namespace cover {
namespace {

using Kind = SchemeValue::Kind;
using Values = SchemeEvaluator::Values;

/// A place is on a side if it misses it by at most this part of the drawing: positions are
/// computed.
constexpr double kOnSide = 1e-6;
/// More chords than this of one circle are taken for a mistake.
constexpr std::size_t kMostChordsOfCircle = std::size_t{1} << 22;

SchemeValue edge_at(Point p) {
  SchemeValue edge;
  edge.kind = Kind::edge;
  edge.at = p;
  return edge;
}

/// A side of a body and where on it something is.
struct Side {
  Point a, b;
  std::size_t body = 0;
  Point foot;
  double distance = kInfinity;
};

/// The bodies of a drawing, and lines on their sides.
class Drawing {
 public:
  std::vector<InputPolygon> bodies;
  std::vector<Point> corners;  ///< put into edges besides those of bodies

  /// Makes p a corner of every body, and of every line, that passes there. False if no body does.
  bool put_corner(Point p, std::vector<InputLine>& lines) {
    const double reach = kOnSide * extent();
    bool is_there = false;
    for (InputPolygon& body : bodies) {
      std::vector<std::uint32_t> none;
      std::vector<std::uint32_t>& circles = body.circles.empty() ? none : body.circles[0];
      is_there = put_between(body.rings[0], circles, body.rings[0].size(), p, reach) || is_there;
    }
    for (InputLine& line : lines)
      put_between(line.points, line.circles, line.points.size() - 1, p, reach);
    return is_there;
  }

  /// The side that p lies on and that is seen; its distance is infinite if there is none.
  [[nodiscard]] Side side_at(Point p) const {
    Side best;
    const double reach = kOnSide * extent();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const std::vector<Point>& ring = bodies[k].rings[0];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Side side{ring[i], ring[(i + 1) % ring.size()], k, {}, 0};
        if (squared_length(side.b - side.a) == 0) continue;
        side.foot = nearest_on_segment(side.a, side.b, p);
        side.distance = length(p - side.foot);
        if (side.distance > reach || side.distance >= best.distance || is_hidden(side, p)) continue;
        best = side;
      }
    }
    return best;
  }

  /// The part of a side around a place on it, between corners and crossings.
  [[nodiscard]] std::pair<Point, Point> edge_around(const Side& side) const {
    const Vector along = side.b - side.a;
    const double whole = squared_length(along);
    const double at = part_on_line(side.a, side.b, side.foot);
    std::pair<double, Point> low{0, side.a}, high{1, side.b};
    const auto cut = [&](Point q) {
      const double part = part_on_line(side.a, side.b, q);
      if (part <= at && part > low.first) low = {part, q};
      if (part > at && part < high.first) high = {part, q};
    };
    const double reach = kOnSide * extent();
    const auto cut_if_on = [&](Point q) {
      if (std::abs(cross(along, q - side.a)) <= reach * std::sqrt(whole)) cut(q);
    };
    for (const Point q : corners) cut_if_on(q);
    for (const InputPolygon& body : bodies) {
      const std::vector<Point>& ring = body.rings[0];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point c = ring[i], d = ring[(i + 1) % ring.size()];
        cut_if_on(c);
        const double of_c = cross(along, c - side.a), of_d = cross(along, d - side.a);
        if (std::min(std::abs(of_c), std::abs(of_d)) <= reach * std::sqrt(whole)) continue;
        if ((of_c > 0) != (of_d > 0)) cut(c + (of_c / (of_c - of_d)) * (d - c));
      }
    }
    return {low.second, high.second};
  }

 private:
  /// Puts p behind the point that the nearest of so many sides begins at, unless it is a point
  /// already. False if none is as near as that. A chord with such a corner is one of no circle.
  static bool put_between(std::vector<Point>& points, std::vector<std::uint32_t>& circles,
                          std::size_t sides, Point p, double reach) {
    std::size_t nearest = 0;
    double least = kInfinity;
    for (std::size_t i = 0; i < sides; ++i) {
      const Point foot = nearest_on_segment(points[i], points[(i + 1) % points.size()], p);
      const double distance = length(p - foot);
      if (distance < least) {
        least = distance;
        nearest = i;
      }
    }
    if (!(least <= reach)) return false;
    if (std::find(points.begin(), points.end(), p) != points.end()) return true;
    const auto behind = static_cast<std::ptrdiff_t>(nearest) + 1;
    points.insert(points.begin() + behind, p);
    if (circles.empty()) return true;
    circles[nearest] = 0;
    circles.insert(circles.begin() + behind, 0);
    return true;
  }

  [[nodiscard]] double extent() const {
    double largest = 0;
    for (const InputPolygon& body : bodies)
      for (const Point& p : body.rings[0])
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return largest;
  }

  /// Whether a body that wins over that of the side covers the place.
  [[nodiscard]] bool is_hidden(const Side& side, Point p) const {
    return std::any_of(bodies.begin(), bodies.end(), [&](const InputPolygon& body) {
      return *body.priority > *bodies[side.body].priority &&
             place_in(body.rings[0], p) == Place::inside;
    });
  }
};

class SdeReader {
 public:
  SdeReader(const std::string& source, const ReadOptions& options)
      : source_(source), options_(options) {}

  Result<Input> read(const SchemeText& text) {
    SchemeEvaluator evaluator(
        source_, [this](const SchemeForm& form, SchemeEvaluator& e) { return command(form, e); });
    for (const int line : text.conditions)
      leave_out("all between a condition of the preprocessor and its #endif", line);
    for (const int line : text.directives) leave_out("a line of the preprocessor", line);
    for (const SchemeForm& form : text.forms) {
      evaluator.evaluate(form);
      if (evaluator.error()) return *evaluator.error();
      const std::string unknown = evaluator.take_unknown();
      if (!unknown.empty()) leave_out(unknown, form.line);
      if (unusable_) return *unusable_;
    }
    if (drawing_.bodies.empty())
      return Error{
          ErrorCode::syntax,
          fmt::format("{}: no sdegeo:create-rectangle, -polygon or -circle that is "
                      "understood{}",
                      source_, left_out_.empty() ? "" : "; not understood: " + list_of(left_out_)),
          {},
          {}};
    place_contacts();
    put_corners();
    tell();
    input_.source = source_;
    input_.unit = "um";
    input_.polygons = std::move(drawing_.bodies);
    return std::move(input_);
  }

 private:
  /// How often something was left out, and where first.
  struct Count {
    std::size_t times = 0;
    int line = 0;
  };
  using Counts = std::map<std::string, Count>;
  struct Contact {
    std::string name;
    Point at;
    int line;
  };

  static void count(Counts& counts, const std::string& what, int line) {
    Count& c = counts[what];
    if (c.times++ == 0) c.line = line;
  }
  void leave_out(const std::string& what, int line) { count(left_out_, what, line); }

  static std::string list_of(const Counts& counts) {
    constexpr std::size_t kMost = 12;
    std::string out;
    std::size_t k = 0;
    for (const auto& [name, c] : counts) {
      if (k++ == kMost) return out + fmt::format(" and {} more", counts.size() - kMost);
      out += fmt::format("{}{} (line {}{})", out.empty() ? "" : ", ", name, c.line,
                         c.times > 1 ? fmt::format(", {} times", c.times) : "");
    }
    return out;
  }

  std::optional<SchemeValue> command(const SchemeForm& form, SchemeEvaluator& evaluator) {
    const std::string& name = form.items[0].word;
    const auto is = [&](const char* command) { return name == command; };
    const SchemeValue nothing;
    if (is("sdegeo:define-contact-set") || is("sdegeo:create-contact-set")) return nothing;
    if (is("sde:clear")) {
      drawing_ = {};
      corner_lines_.clear();
      contacts_.clear();
      return nothing;
    }
    if (name.starts_with("sde:load") || name.starts_with("sdeio:read")) return std::nullopt;
    if (name.starts_with("sdedr:") || name.starts_with("sde:") || name.starts_with("sdeio:") ||
        name.starts_with("sdesnmesh:") || is("display") || is("newline") ||
        is("entity:set-color")) {
      count(no_geometry_, name.substr(0, name.find(':')), form.line);
      return nothing;
    }
    if (is("sdegeo:create-rectangle")) return create(form, rectangle(evaluator.arguments(form)));
    if (is("sdegeo:create-polygon")) return create(form, polygon(evaluator.arguments(form)));
    if (is("sdegeo:create-circle")) return create_circle(form, evaluator.arguments(form));
    if (is("sdegeo:set-default-boolean")) return set_boolean(form, evaluator.arguments(form));
    if (is("sdegeo:set-current-contact-set")) {
      const Values values = evaluator.arguments(form);
      contact_ = values.empty() ? "" : values[0].text;
      return nothing;
    }
    if (is("find-edge-id") || is("sdegeo:insert-vertex") || is("find-vertex-id")) {
      const Values values = evaluator.arguments(form);
      if (values.empty() || !values[0].is(Kind::position)) return std::nullopt;
      if (is("sdegeo:insert-vertex")) {
        drawing_.corners.push_back(values[0].at);
        corner_lines_.push_back(form.line);
      }
      return is("find-edge-id") ? edge_at(values[0].at) : nothing;
    }
    if (is("find-region-id") || is("find-body-id")) return find_body(evaluator.arguments(form));
    if (is("sdegeo:define-2d-contact") || is("sdegeo:set-contact-edges") ||
        is("sdegeo:set-contact") || is("sdegeo:set-contact-boundary-edges"))
      return set_contact(form, evaluator.arguments(form));
    return std::nullopt;
  }

  /// The ring, and the names behind it.
  using Body = std::optional<std::pair<std::vector<Point>, Values>>;

  static bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

  static Body rectangle(Values values) {
    if (values.size() < 2 || !values[0].is(Kind::position) || !values[1].is(Kind::position))
      return std::nullopt;
    const Point a = values[0].at, b = values[1].at;
    values.erase(values.begin(), values.begin() + 2);
    return std::pair(std::vector<Point>{a, {b.x, a.y}, b, {a.x, b.y}}, std::move(values));
  }

  static Body polygon(Values values) {
    if (values.empty() || !values[0].is(Kind::list)) return std::nullopt;
    std::vector<Point> ring;
    for (const SchemeValue& corner : values[0].items) {
      if (!corner.is(Kind::position)) return std::nullopt;
      ring.push_back(corner.at);
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) return std::nullopt;
    values.erase(values.begin());
    return std::pair(std::move(ring), std::move(values));
  }

  SchemeValue create_circle(const SchemeForm& form, Values values) {
    if (values.size() < 2 || !values[0].is(Kind::position) || !values[1].is(Kind::number) ||
        !(values[1].number > 0))
      return create(form, std::nullopt);
    Arc arc;
    arc.centre = values[0].at;
    arc.radius = values[1].number;
    arc.step = options_.chord_angle;
    if (options_.chord_error)
      arc.step = std::min(arc.step, step_for_chord_error(arc.radius, *options_.chord_error));
    values.erase(values.begin(), values.begin() + 2);
    if (!is_finite(arc.centre) || !std::isfinite(arc.radius))
      return create(form, std::pair(std::vector{arc.centre + Vector{arc.radius, 0}}, values));
    CurveCutter cutter;
    cutter.add(arc);
    std::optional<std::vector<Point>> ring = cutter.points(arc, kMostChordsOfCircle);
    if (!ring) {
      unusable_ = Error{ErrorCode::unsupported_format,
                        fmt::format("{}:{}: a circle has more than {} chords; is the chord error "
                                    "given in the unit of the file?",
                                    source_, form.line, kMostChordsOfCircle),
                        {},
                        {}};
      return {};
    }
    ring->pop_back();
    const std::size_t chords = ring->size();
    SchemeValue value = create(form, std::pair(*std::move(ring), std::move(values)));
    if (value.is(Kind::body))
      drawing_.bodies.back().circles = {
          std::vector<std::uint32_t>(chords, circles_.of({arc.centre, arc.radius}))};
    return value;
  }

  SchemeValue create(const SchemeForm& form, const Body& body) {
    SchemeValue value;
    if (!body || body->second.empty() || !body->second[0].is(Kind::text)) {
      leave_out(form.items[0].word, form.line);
      return value;
    }
    InputPolygon polygon;
    for (const Point& p : body->first) {
      if (is_finite(p)) continue;
      unusable_ = Error{ErrorCode::non_finite_coordinate,
                        fmt::format("{}:{}: a coordinate is not finite", source_, form.line),
                        {},
                        {}};
      return value;
    }
    polygon.rings.push_back(body->first);
    polygon.material = body->second[0].text;
    if (body->second.size() > 1) polygon.region = body->second[1].text;
    polygon.id = static_cast<long>(drawing_.bodies.size());
    // Of equal signs the later one wins above zero, the earlier one below.
    const auto order = static_cast<double>(drawing_.bodies.size() + 1);
    polygon.priority = new_wins_ ? order : -order;
    value.kind = Kind::body;
    value.number = static_cast<double>(drawing_.bodies.size());
    drawing_.bodies.push_back(std::move(polygon));
    return value;
  }

  std::optional<SchemeValue> set_boolean(const SchemeForm& form, const Values& values) {
    if (values.size() != 1 || (values[0].text != "ABA" && values[0].text != "BAB")) {
      leave_out(fmt::format("{} \"{}\"", form.items[0].word, values.empty() ? "" : values[0].text),
                form.line);
      return SchemeValue{};
    }
    new_wins_ = values[0].text == "ABA";
    return SchemeValue{};
  }

  std::optional<SchemeValue> find_body(const Values& values) const {
    for (std::size_t k = drawing_.bodies.size(); k-- > 0 && !values.empty();) {
      const InputPolygon& body = drawing_.bodies[k];
      const bool meant = values[0].is(Kind::text)
                             ? body.region == values[0].text
                             : values[0].is(Kind::position) &&
                                   place_in(body.rings[0], values[0].at) == Place::inside;
      if (!meant) continue;
      SchemeValue value;
      value.kind = Kind::body;
      value.number = static_cast<double>(k);
      return value;
    }
    return std::nullopt;
  }

  SchemeValue set_contact(const SchemeForm& form, const Values& values) {
    const std::string name =
        values.size() > 1 && values[1].is(Kind::text) ? values[1].text : contact_;
    if (values.empty() || name.empty() || !add_contacts(values[0], name, form.line))
      leave_out(form.items[0].word, form.line);
    if (values.size() > 2 && values[2].text == "remove")
      leave_out(form.items[0].word + " \"remove\"", form.line);
    return {};
  }

  bool add_contacts(const SchemeValue& what, const std::string& name, int line) {
    if (what.is(Kind::edge)) {
      contacts_.push_back({name, what.at, line});
      return true;
    }
    if (what.is(Kind::body)) {
      const InputPolygon& body = drawing_.bodies[static_cast<std::size_t>(what.number)];
      std::vector<Point> around = body.rings[0];
      around.push_back(around.front());
      input_.lines.push_back({name, std::move(around), static_cast<long>(input_.lines.size())});
      if (body.circles.empty()) return true;
      input_.lines.back().circles = body.circles[0];
      input_.lines.back().circles.push_back(0);
      return true;
    }
    if (!what.is(Kind::list) || what.items.empty()) return false;
    bool all = true;
    for (const SchemeValue& item : what.items) all = add_contacts(item, name, line) && all;
    return all;
  }

  void place_contacts() {
    for (const Contact& contact : contacts_) {
      const Side side = drawing_.side_at(contact.at);
      if (!std::isfinite(side.distance)) {
        drop(fmt::format("{}:{}: contact '{}': no edge at {}: left out", source_, contact.line,
                         contact.name, describe(contact.at)),
             {contact.at});
        continue;
      }
      const auto [a, b] = drawing_.edge_around(side);
      input_.lines.push_back({contact.name, {a, b}, static_cast<long>(input_.lines.size())});
      const InputPolygon& body = drawing_.bodies[side.body];
      if (!body.circles.empty()) input_.lines.back().circles = {body.circles[0][0], 0};
    }
  }

  void put_corners() {
    for (std::size_t k = 0; k < drawing_.corners.size(); ++k) {
      const Point p = drawing_.corners[k];
      if (drawing_.put_corner(p, input_.lines)) continue;
      drop(fmt::format("{}:{}: vertex: no edge at {}: left out", source_, corner_lines_[k],
                       describe(p)),
           {p});
    }
  }

  void drop(std::string message, std::vector<Point> where) {
    input_.changes.push_back({Change::Kind::dropped, std::move(message), std::move(where), {}});
  }

  void tell() {
    if (!left_out_.empty()) drop("not understood and left out: " + list_of(left_out_), {});
    if (!no_geometry_.empty())
      input_.warnings.push_back("commands of doping and meshing are left out: " +
                                list_of(no_geometry_));
  }

  const std::string& source_;
  const ReadOptions& options_;
  Drawing drawing_;
  std::vector<int> corner_lines_;  ///< by corner of the drawing
  std::vector<Contact> contacts_;
  std::string contact_;  ///< the current set
  bool new_wins_ = true;
  Counts left_out_, no_geometry_;
  std::optional<Error> unusable_;
  Input input_;
  CircleNumbers circles_{input_.circles};
};

}  // namespace

Result<Input> parse_sde(std::string_view text, const std::string& source,
                        const ReadOptions& options) {
  const Result<SchemeText> parsed = parse_scheme(text, source);
  if (!parsed) return parsed.error();
  return SdeReader(source, options).read(*parsed);
}

}  // namespace cover
