// Points are looked for by their places along a skew direction, in which no line of a drawing is
// likely to lie.
// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/match_sides.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>
#include <cover/verify.hpp>

#include "cuts/periodic/named_line.hpp"
#include "geom/box.hpp"
#include "geom/isometry.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::size_t kShiftsTried = 8;

/// The points of a line, by place.
class PointFinder {
 public:
  PointFinder(const std::vector<Point>& points, const std::vector<VertexId>& vertices)
      : points_(points) {
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

Error unknown_line(const Pslg& pslg, const RegionTable& table, const PeriodicRule& rule,
                   const std::string& name) {
  std::vector<std::string> names;
  for (const Interface& line : table.interfaces) names.push_back(line.name);
  const std::string in_void = line_in_void(pslg, name);
  if (!in_void.empty()) return periodic_error(rule, in_void);
  return periodic_error(
      rule, fmt::format("there is no interface, contact, outline or marker '{}'{}", name,
                        did_you_mean(name, names)));
}

Box box_of(const Pslg& pslg, const NamedLine& line) {
  Box box;
  for (const VertexId v : line.vertices) box.add(pslg.points[v.index()]);
  return box;
}

/// Of the line's length.
Point centroid_of(const Pslg& pslg, const NamedLine& line) {
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
  Matcher(const Pslg& pslg, const PeriodicRule& rule, double tolerance, NamedLine from,
          NamedLine to)
      : pslg_(pslg),
        rule_(rule),
        from_(std::move(from)),
        to_(std::move(to)),
        find_to_(pslg.points, to_.vertices) {
    Box both = box_of(pslg, from_);
    both.include(box_of(pslg, to_));
    match_.tolerance = tolerance * both.extent();
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
      case PeriodicRule::Map::glide:
        return periodic_error(rule_, "a glide reflection cannot be asked for", {});
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
  NamedLine from_, to_;
  PointFinder find_to_;
  SidesMatch match_;
};

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

Result<SidesMatch> match_sides(const Pslg& pslg, const RegionTable& table, const PeriodicRule& rule,
                               double tolerance) {
  NamedLine from = find_line(pslg, table, rule.from), to = find_line(pslg, table, rule.to);
  if (from.segments.empty()) return unknown_line(pslg, table, rule, rule.from);
  if (to.segments.empty()) return unknown_line(pslg, table, rule, rule.to);
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
  return Matcher(pslg, rule, tolerance, std::move(from), std::move(to)).match();
}

Result<std::size_t> verify_periodic_sides(const Pslg& pslg, const RegionTable& table,
                                          const PeriodicRule& rule) {
  const Result<SidesMatch> match = match_sides(pslg, table, rule, kAutoWeld);
  if (!match) return match.error();
  if (std::optional<Error> fault = unmatched(pslg, rule, *match)) return *std::move(fault);
  return match->vertices.size();
}

}  // namespace cover
