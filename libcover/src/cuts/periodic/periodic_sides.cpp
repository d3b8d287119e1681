// Points are looked for by their places along a skew direction, in which no line of a drawing is
// likely to lie.
// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/periodic_sides.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>

#include "cdt/cdt.hpp"
#include "clean/change_report.hpp"
#include "cuts/cut_segments.hpp"
#include "geom/box.hpp"
#include "geom/isometry.hpp"
#include "options/periodic_rule.hpp"
#include "region/region_graph.hpp"

namespace cover {
namespace {

constexpr double kRoundingOfDigits = 0x1p-49;  ///< of the largest coordinate: not told
constexpr std::size_t kShiftsTried = 8;
constexpr std::size_t kUnmatchedTold = 10;

Error periodic_error(const PeriodicRule& rule, const std::string& what,
                     std::vector<Point> where = {}) {
  return {ErrorCode::bad_option,
          fmt::format("periodic {}: {}", describe(rule), what),
          std::move(where),
          {}};
}

/// The points of a line, by place.
class PointFinder {
 public:
  PointFinder(const std::vector<Point>& points, std::vector<VertexId> vertices) : points_(points) {
    for (const VertexId v : vertices) at_.emplace_back(key(points_[v.index()]), v);
    std::sort(at_.begin(), at_.end());
  }

  /// The point nearest to `p`, if one is within `tolerance`.
  [[nodiscard]] std::optional<VertexId> nearest(Point p, double tolerance) const {
    std::optional<VertexId> best;
    double least = tolerance;
    for (auto k = std::lower_bound(at_.begin(), at_.end(),
                                   std::pair(key(p) - 2 * tolerance, VertexId{0U}));
         k != at_.end() && k->first <= key(p) + 2 * tolerance; ++k) {
      const double distance = length(points_[k->second.index()] - p);
      if (distance > least) continue;
      least = distance;
      best = k->second;
    }
    return best;
  }

 private:
  static double key(Point p) {
    constexpr double kAlong = 0.8526, kAcross = 0.5225;  // a direction of length one
    return kAlong * p.x + kAcross * p.y;
  }

  const std::vector<Point>& points_;
  std::vector<std::pair<double, VertexId>> at_;
};

/// A named line.
struct Line {
  std::vector<SegmentId> segments;  ///< in order
  std::vector<VertexId> vertices;   ///< in order, once each
};

bool is_marker(const std::string& name, int marker) {
  int number = 0;
  const auto [stop, status] = std::from_chars(name.data(), name.data() + name.size(), number);
  return status == std::errc() && stop == name.data() + name.size() && number == marker &&
         marker != 0;
}

Line find_line(const Pslg& pslg, const RegionTable& table, const std::string& name) {
  Line line;
  for (const Interface& part : table.interfaces) {
    if (part.name == name)
      line.segments.insert(line.segments.end(), part.segments.begin(), part.segments.end());
  }
  for (std::size_t s = 0; s < pslg.segments.size() && line.segments.empty(); ++s) {
    for (std::size_t t = s; t < pslg.segments.size() && is_marker(name, pslg.segments[s].marker);
         ++t) {
      if (pslg.segments[t].marker == pslg.segments[s].marker) line.segments.emplace_back(t);
    }
  }
  std::sort(line.segments.begin(), line.segments.end());
  for (const SegmentId s : line.segments) {
    line.vertices.push_back(pslg.segments[s.index()].a);
    line.vertices.push_back(pslg.segments[s.index()].b);
  }
  std::sort(line.vertices.begin(), line.vertices.end());
  line.vertices.erase(std::unique(line.vertices.begin(), line.vertices.end()), line.vertices.end());
  return line;
}

Error unknown_line(const RegionTable& table, const PeriodicRule& rule, const std::string& name) {
  std::vector<std::string> names;
  for (const Interface& line : table.interfaces) names.push_back(line.name);
  return periodic_error(
      rule, fmt::format("there is no interface, contact, outline or marker '{}'{}", name,
                        did_you_mean(name, names)));
}

Box box_of(const Pslg& pslg, const Line& line) {
  Box box;
  for (const VertexId v : line.vertices) box.add(pslg.points[v.index()]);
  return box;
}

/// Of the line's length.
Point centroid_of(const Pslg& pslg, const Line& line) {
  const Point origin = pslg.points[line.vertices[0].index()];
  Vector sum;
  double total = 0;
  for (const SegmentId s : line.segments) {
    const Point a = pslg.points[pslg.segments[s.index()].a.index()],
                b = pslg.points[pslg.segments[s.index()].b.index()];
    const double weight = length(b - a);
    sum = sum + weight * (midpoint(a, b) - origin);
    total += weight;
  }
  return origin + (1 / total) * sum;
}

/// Compares two lines.
class Matcher {
 public:
  Matcher(const Pslg& pslg, const PeriodicRule& rule, Line from, Line to)
      : pslg_(pslg),
        rule_(rule),
        from_(std::move(from)),
        to_(std::move(to)),
        find_to_(pslg.points, to_.vertices) {
    Box both = box_of(pslg, from_);
    both.include(box_of(pslg, to_));
    match_.tolerance = kAutoWeld * both.extent();
  }

  Result<SidesMatch> match() {
    if (Status found = find_map(); !found) return std::move(found).error();
    pair_vertices();
    pair_segments();
    return std::move(match_);
  }

 private:
  [[nodiscard]] Point at(VertexId v) const { return pslg_.points[v.index()]; }

  Status find_map() {
    switch (rule_.map) {
      case PeriodicRule::Map::translation:
        match_.map = translation_by(box_of(pslg_, to_).low - box_of(pslg_, from_).low);
        break;
      case PeriodicRule::Map::rotation:
        match_.map = rotation_about(rule_.centre, rule_.angle);
        return ok();  // its shift is what the user says
      case PeriodicRule::Map::mirror: {
        const Point p = centroid_of(pslg_, from_), q = centroid_of(pslg_, to_);
        if (!(length(q - p) > match_.tolerance))
          return periodic_error(rule_,
                                "both lines have the same centre, so that it tells no axis "
                                "for a mirror",
                                {p});
        match_.map = reflection_between(p, q);
        break;
      }
    }
    refine_shift();
    return ok();
  }

  /// Among shifts that differ by rounding, the one with most exact images.
  void refine_shift() {
    std::map<double, std::size_t> shifts_x, shifts_y;
    const Isometry plain = with_shift(match_.map, {0, 0}, {0, 0});
    std::vector<std::array<Point, 2>> near;
    for (const VertexId v : from_.vertices) {
      const auto image = find_to_.nearest(image_of(match_.map, at(v)), match_.tolerance);
      if (!image) continue;
      near.push_back({at(v), at(*image)});
      const Point turned = image_of(plain, at(v));
      ++shifts_x[at(*image).x - turned.x];
      ++shifts_y[at(*image).y - turned.y];
    }
    if (near.empty()) return;
    const auto best_of = [&](const std::map<double, std::size_t>& shifts, auto coordinate,
                             auto with) {
      std::vector<std::pair<std::size_t, double>> often;
      for (const auto& [shift, count] : shifts) often.emplace_back(count, shift);
      std::sort(often.rbegin(), often.rend());
      often.resize(std::min(often.size(), kShiftsTried));
      std::pair<std::size_t, double> best{0, often[0].second};
      for (const auto& [count, shift] : often) {
        const Isometry map = with(shift);
        const auto exact = static_cast<std::size_t>(
            std::count_if(near.begin(), near.end(), [&](const std::array<Point, 2>& pair) {
              return coordinate(image_of(map, pair[0])) == coordinate(pair[1]);
            }));
        if (exact > best.first) best = {exact, shift};
      }
      return best.second;
    };
    const double x = best_of(
        shifts_x, [](Point p) { return p.x; },
        [&](double shift) {
          return with_shift(plain, {shift, 0}, {0, 0});
        });
    const double y = best_of(
        shifts_y, [](Point p) { return p.y; },
        [&](double shift) {
          return with_shift(plain, {0, 0}, {shift, 0});
        });
    match_.map = with_shift(plain, {x, 0}, {y, 0});
  }

  void pair_vertices() {
    std::vector<std::pair<VertexId, VertexId>> reached;  // image, point
    for (const VertexId v : from_.vertices) {
      const auto image = find_to_.nearest(image_of(match_.map, at(v)), match_.tolerance);
      if (image) {
        reached.emplace_back(*image, v);
      } else {
        match_.from_alone.push_back(v);
      }
    }
    std::sort(reached.begin(), reached.end());
    for (std::size_t k = 0; k < reached.size(); ++k) {
      if (k > 0 && reached[k].first == reached[k - 1].first) {
        match_.from_alone.push_back(reached[k].second);  // two points with one image
      } else {
        match_.vertices.push_back({reached[k].second, reached[k].first});
      }
    }
    std::sort(match_.vertices.begin(), match_.vertices.end());
    std::sort(match_.from_alone.begin(), match_.from_alone.end());
    for (const VertexId v : to_.vertices) {
      const auto found = std::lower_bound(reached.begin(), reached.end(), std::pair(v, VertexId{}));
      if (found == reached.end() || found->first != v) match_.to_alone.push_back(v);
    }
  }

  [[nodiscard]] std::optional<VertexId> image(VertexId v) const {
    const auto found = std::lower_bound(match_.vertices.begin(), match_.vertices.end(),
                                        std::array<VertexId, 2>{v, VertexId{}});
    if (found == match_.vertices.end() || (*found)[0] != v) return std::nullopt;
    return (*found)[1];
  }

  void pair_segments() {
    std::map<std::pair<VertexId, VertexId>, SegmentId> of_ends;
    for (const SegmentId s : to_.segments) {
      const Segment& segment = pslg_.segments[s.index()];
      of_ends.emplace(std::pair(segment.a, segment.b), s);
      of_ends.emplace(std::pair(segment.b, segment.a), s);
    }
    std::vector<SegmentId> reached;
    for (const SegmentId s : from_.segments) {
      const Segment& segment = pslg_.segments[s.index()];
      const auto a = image(segment.a), b = image(segment.b);
      if (!a || !b) continue;
      const auto found = of_ends.find({*a, *b});
      if (found == of_ends.end()) {
        match_.segments_alone.push_back(s);
        continue;
      }
      const Segment& other = pslg_.segments[found->second.index()];
      match_.pairs.push_back({s, found->second, other.a != *a, 0});
      reached.push_back(found->second);
    }
    std::sort(reached.begin(), reached.end());
    std::sort(match_.to_alone.begin(), match_.to_alone.end());
    const auto is_alone = [&](VertexId v) {
      return std::binary_search(match_.to_alone.begin(), match_.to_alone.end(), v);
    };
    for (const SegmentId s : to_.segments) {
      const Segment& segment = pslg_.segments[s.index()];
      if (!std::binary_search(reached.begin(), reached.end(), s) && !is_alone(segment.a) &&
          !is_alone(segment.b))
        match_.segments_alone.push_back(s);
    }
  }

  const Pslg& pslg_;
  const PeriodicRule& rule_;
  Line from_, to_;
  PointFinder find_to_;
  SidesMatch match_;
};

double distance_from(Point a, Point b, Point p) {
  const double along = std::clamp(dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
  return length(p - (a + along * (b - a)));
}

/// Puts the points that only one of two lines has on the other.
class Completion {
 public:
  Completion(Pslg& pslg, RegionTable& table, Report& report)
      : pslg_(pslg), table_(table), report_(report) {}

  /// Whether anything was cut.
  Result<bool> complete(const PeriodicRule& rule, const SidesMatch& match) {
    cuts_.clear();
    lost_.clear();
    const Isometry back = inverse_of(match.map);
    const Line from = find_line(pslg_, table_, rule.from), to = find_line(pslg_, table_, rule.to);
    for (const VertexId v : match.from_alone) place(v, match.map, to, match.tolerance);
    for (const VertexId v : match.to_alone) place(v, back, from, match.tolerance);
    if (!lost_.empty()) return mismatch(rule, match);
    if (cuts_.empty()) {
      if (!match.segments_alone.empty()) return lone_segments(rule, match);
      return false;
    }
    std::vector<SegmentCut> cuts;
    for (auto& [segment, points] : cuts_) {
      const Point a = pslg_.points[pslg_.segments[segment.index()].a.index()];
      std::sort(points.begin(), points.end(),
                [&](Point p, Point q) { return length(p - a) < length(q - a); });
      points.erase(std::unique(points.begin(), points.end()), points.end());
      cuts.push_back({segment, points});
      tell(rule, segment, points);
    }
    cut_segments(pslg_, table_, cuts);
    return true;
  }

 private:
  /// Looks for the segment of `line` on which the image of `v` lies.
  void place(VertexId v, const Isometry& map, const Line& line, double tolerance) {
    const Point image = image_of(map, pslg_.points[v.index()]);
    double least = std::numeric_limits<double>::infinity();
    SegmentId nearest;
    for (const SegmentId s : line.segments) {
      const Segment& segment = pslg_.segments[s.index()];
      const double distance =
          distance_from(pslg_.points[segment.a.index()], pslg_.points[segment.b.index()], image);
      if (distance >= least) continue;
      least = distance;
      nearest = s;
    }
    const Segment& segment = pslg_.segments[nearest.index()];
    const Point a = pslg_.points[segment.a.index()], b = pslg_.points[segment.b.index()];
    const bool is_inside =
        least <= tolerance && length(image - a) > tolerance && length(image - b) > tolerance;
    if (is_inside) {
      cuts_[nearest].push_back(image);
    } else {
      lost_.push_back({least, v, image});
    }
  }

  void tell(const PeriodicRule& rule, SegmentId s, const std::vector<Point>& points) {
    const Segment& segment = pslg_.segments[s.index()];
    std::vector<InputRef> refs;
    if (segment.id >= 0) refs.push_back({InputKind::segment, segment.id});
    report_.changes.push_back(
        {Change::Kind::split,
         fmt::format("the segment from {} to {} was cut at {}, as periodic {} asks: the other side "
                     "has {} there",
                     describe(pslg_.points[segment.a.index()]),
                     describe(pslg_.points[segment.b.index()]), describe(points[0]), describe(rule),
                     points.size() == 1 ? "a point" : "points"),
         points, std::move(refs)});
  }

  [[nodiscard]] Error mismatch(const PeriodicRule& rule, const SidesMatch& match) const {
    auto worst = lost_;
    std::stable_sort(worst.begin(), worst.end(),
                     [](const Lost& x, const Lost& y) { return x.distance > y.distance; });
    const Lost& first = worst[0];
    const bool is_from = std::find(match.from_alone.begin(), match.from_alone.end(),
                                   first.vertex) != match.from_alone.end();
    std::vector<Point> where;
    for (const Lost& lost : worst) {
      if (where.size() < kUnmatchedTold) where.push_back(pslg_.points[lost.vertex.index()]);
    }
    return periodic_error(
        rule,
        fmt::format("the lines do not match: {} of '{}' comes to {}, which is {} from '{}'{}",
                    describe(pslg_.points[first.vertex.index()]), is_from ? rule.from : rule.to,
                    describe(first.image), describe_roughly(first.distance),
                    is_from ? rule.to : rule.from,
                    worst.size() == 1
                        ? ""
                        : fmt::format("; {} more do not", counted(worst.size() - 1, "point"))),
        std::move(where));
  }

  [[nodiscard]] Error lone_segments(const PeriodicRule& rule, const SidesMatch& match) const {
    const Segment& s = pslg_.segments[match.segments_alone[0].index()];
    const Point a = pslg_.points[s.a.index()], b = pslg_.points[s.b.index()];
    return periodic_error(
        rule,
        fmt::format("the lines do not match: the segment from {} to {} has no image", describe(a),
                    describe(b)),
        {a, b});
  }

  struct Lost {
    double distance = 0;
    VertexId vertex;
    Point image;
  };

  Pslg& pslg_;
  RegionTable& table_;
  Report& report_;
  std::map<SegmentId, std::vector<Point>> cuts_;
  std::vector<Lost> lost_;
};

/// Moves the points of each class to the images of one of them.
class Snapping {
 public:
  Snapping(Pslg& pslg, const std::vector<SidesMatch>& matches) : pslg_(pslg), matches_(matches) {
    double largest = 0;
    for (const Point& p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    untold_ = kRoundingOfDigits * largest;
  }

  /// Whether anything moved. Changes beyond rounding are appended to `changes`.
  bool run(std::vector<Change>& changes) {
    link();
    std::vector<std::uint8_t> done(pslg_.points.size(), 0);
    bool has_moved = false;
    // A point that is no image first, or images would be rounded twice.
    for (const bool only_origins : {true, false}) {
      for (const auto& [v, links] : links_) {
        const bool is_image =
            std::any_of(links.begin(), links.end(), [](const Link& link) { return link.is_back; });
        if (done[v.index()] != 0 || (only_origins && is_image)) continue;
        has_moved |= spread(v, done, changes);
      }
    }
    return has_moved;
  }

 private:
  struct Link {
    VertexId to;
    std::size_t rule = 0;
    bool is_back = false;
  };

  void link() {
    for (std::size_t r = 0; r < matches_.size(); ++r) {
      for (const auto& [v, image] : matches_[r].vertices) {
        if (v == image) continue;
        links_[v].push_back({image, r, false});
        links_[image].push_back({v, r, true});
      }
    }
  }

  bool spread(VertexId root, std::vector<std::uint8_t>& done, std::vector<Change>& changes) {
    bool has_moved = false;
    std::vector<VertexId> queue{root};
    done[root.index()] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const VertexId v = queue[head];
      for (const Link& link : links_.at(v)) {
        if (done[link.to.index()] != 0) continue;
        done[link.to.index()] = 1;
        queue.push_back(link.to);
        const Isometry& map = matches_[link.rule].map;
        const Point image = image_of(link.is_back ? inverse_of(map) : map, pslg_.points[v.index()]);
        Point& p = pslg_.points[link.to.index()];
        if (p == image) continue;
        tell(link.to, image, changes);
        p = image;
        has_moved = true;
      }
    }
    return has_moved;
  }

  void tell(VertexId v, Point image, std::vector<Change>& changes) const {
    const Point p = pslg_.points[v.index()];
    const long id = pslg_.point_ids[v.index()];
    if (id < 0 || length(image - p) <= untold_) return;
    changes.push_back(
        {Change::Kind::welded,
         fmt::format("point {} at {} was moved by {} to {}, where the other periodic "
                     "side asks for it",
                     id, describe(p), describe_roughly(length(image - p)), describe(image)),
         {p, image},
         {{InputKind::point, id}}});
  }

  Pslg& pslg_;
  const std::vector<SidesMatch>& matches_;
  double untold_ = 0;
  std::map<VertexId, std::vector<Link>> links_;
};

/// Whether segments still meet only at points.
bool is_clean(const Pslg& pslg) {
  std::vector<IndexPair> pairs;
  pairs.reserve(pslg.segments.size());
  for (const Segment& s : pslg.segments) pairs.push_back({s.a.value(), s.b.value()});
  return triangulate_hull(pslg.points, pairs).conflicts.empty();
}

bool has_same_sides(const RegionTable& x, const RegionTable& y) {
  return std::equal(x.sides.begin(), x.sides.end(), y.sides.begin(), y.sides.end(),
                    [](const SegmentSides& s, const SegmentSides& t) {
                      return s.left == t.left && s.right == t.right;
                    });
}

/// Matches of all rules, with all points on both sides.
Result<std::vector<SidesMatch>> match_all(Pslg& pslg, RegionTable& table,
                                          const std::vector<PeriodicRule>& rules, Report& report) {
  Completion completion(pslg, table, report);
  // A point goes from line to line, so no more rounds are needed than there are rules.
  for (std::size_t round = 0; round <= rules.size() + 1; ++round) {
    std::vector<SidesMatch> matches;
    bool has_cut = false;
    for (const PeriodicRule& rule : rules) {
      Result<SidesMatch> match = match_sides(pslg, table, rule);
      if (!match) return std::move(match).error();
      const Result<bool> cut = completion.complete(rule, *match);
      if (!cut) return cut.error();
      has_cut |= *cut;
      matches.push_back(*std::move(match));
    }
    if (!has_cut) return matches;
  }
  return periodic_error(rules[0],
                        "the rules ask for points without end: are they all of one cell?");
}

}  // namespace

std::optional<Error> unmatched(const Pslg& pslg, const PeriodicRule& rule,
                               const SidesMatch& match) {
  std::vector<Point> where;
  for (const auto* alone : {&match.from_alone, &match.to_alone}) {
    for (const VertexId v : *alone) where.push_back(pslg.points[v.index()]);
  }
  if (!where.empty()) {
    const std::size_t count = where.size();
    const Point first = where[0];
    where.resize(std::min(count, kUnmatchedTold));
    return periodic_error(rule,
                          fmt::format("{} without a partner, the first at {}",
                                      counted(count, "point"), describe(first)),
                          std::move(where));
  }
  if (match.segments_alone.empty()) return std::nullopt;
  const Segment& s = pslg.segments[match.segments_alone[0].index()];
  const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
  return periodic_error(
      rule, fmt::format("the edge from {} to {} has no partner", describe(a), describe(b)), {a, b});
}

std::string describe(const PeriodicRule& rule) {
  return fmt::format("'{}' and '{}'", rule.from, rule.to);
}

Result<SidesMatch> match_sides(const Pslg& pslg, const RegionTable& table,
                               const PeriodicRule& rule) {
  Line from = find_line(pslg, table, rule.from), to = find_line(pslg, table, rule.to);
  if (from.segments.empty()) return unknown_line(table, rule, rule.from);
  if (to.segments.empty()) return unknown_line(table, rule, rule.to);
  std::vector<SegmentId> both;
  std::set_intersection(from.segments.begin(), from.segments.end(), to.segments.begin(),
                        to.segments.end(), std::back_inserter(both));
  if (!both.empty()) {
    const Segment& s = pslg.segments[both[0].index()];
    const Point a = pslg.points[s.a.index()], b = pslg.points[s.b.index()];
    return periodic_error(rule,
                          fmt::format("the segment from {} to {} is on both lines, and no line can "
                                      "be taken to itself",
                                      describe(a), describe(b)),
                          {a, b});
  }
  return Matcher(pslg, rule, std::move(from), std::move(to)).match();
}

Status join_periodic_sides(Pslg& pslg, RegionTable& table, const std::vector<PeriodicRule>& rules,
                           const Options& options, Report& report) {
  if (rules.empty()) return ok();
  if (options.method == Method::nonobtuse)
    return Error{ErrorCode::bad_option,
                 "method nonobtuse cuts segments by itself, so it does not go with periodic sides",
                 {},
                 {}};
  for (const PeriodicRule& rule : rules) {
    if (Status good = check_rule(rule); !good) return good;
  }
  const std::size_t changes = report.changes.size();
  Result<std::vector<SidesMatch>> matches = match_all(pslg, table, rules, report);
  if (!matches) return std::move(matches).error();
  const bool has_moved = Snapping(pslg, *matches).run(report.changes);
  if (options.strict && report.changes.size() > changes) {
    const Change& first = report.changes[changes];
    return Error{ErrorCode::changed_input, first.message, first.where, first.inputs};
  }
  sum_up({report.changes.begin() + static_cast<std::ptrdiff_t>(changes), report.changes.end()},
         report.notes);
  if (has_moved || report.changes.size() > changes) {
    if (!is_clean(pslg))
      return periodic_error(rules[0], "points moved to their images make segments cross");
    std::vector<Note> known;  // told already
    Result<RegionTable> again = build_region_table(pslg, options, known);
    if (!again) return std::move(again).error();
    if (!has_same_sides(table, *again))
      return periodic_error(rules[0], "points moved to their images change sides of segments");
    table = *std::move(again);
  }
  for (std::size_t r = 0; r < rules.size(); ++r) {
    pslg.isometries.push_back((*matches)[r].map);
    for (SegmentPair pair : (*matches)[r].pairs) {
      pair.rule = static_cast<std::uint32_t>(r);
      pslg.periodic.push_back(pair);
    }
  }
  return ok();
}

Result<std::size_t> verify_periodic_sides(const Pslg& pslg, const RegionTable& table,
                                          const PeriodicRule& rule) {
  const Result<SidesMatch> match = match_sides(pslg, table, rule);
  if (!match) return match.error();
  if (std::optional<Error> fault = unmatched(pslg, rule, *match)) return *std::move(fault);
  return match->vertices.size();
}

}  // namespace cover
