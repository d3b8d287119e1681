// Tested by tests/unit/cuts/periodic/periodic_sides_test.cpp.
#include "cuts/periodic/complete_sides.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "clean/ends/loose_ends.hpp"
#include "cuts/cut_segments.hpp"
#include "geom/box.hpp"
#include "geom/curves/arc.hpp"
#include "geom/foot.hpp"
#include "geom/isometry.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The arc over a segment, where that is a chord.
std::optional<ArcOver> arc_over(const Pslg& pslg, const Segment& segment) {
  const ArcCircle* circle = circle_of(pslg, segment);
  if (circle == nullptr) return std::nullopt;
  return ArcOver(*circle, pslg.points[segment.a.index()], pslg.points[segment.b.index()]);
}

/// How far `p` is from the arc over a segment; infinite where it is beside the arc's ends, or where
/// there is no arc.
double distance_to_arc(const Pslg& pslg, const Segment& segment, Point p) {
  const std::optional<ArcOver> arc = arc_over(pslg, segment);
  if (!arc) return kInfinity;
  const double share = arc->share_of(p);
  return share > 0 && share < 1 ? arc->distance_from_circle(p) : kInfinity;
}

}  // namespace

Result<bool> SidesCompletion::complete(const PeriodicRule& rule, const SidesMatch& match) {
  cuts_.clear();
  lost_.clear();
  const Isometry back = inverse_of(match.map);
  const NamedLine from = find_line(pslg_, table_, rule.from),
                  to = find_line(pslg_, table_, rule.to);
  for (const VertexId v : match.from_alone) place(v, match.map, to, match.tolerance);
  for (const VertexId v : match.to_alone) place(v, back, from, match.tolerance);
  if (!lost_.empty()) return mismatch(rule, match);
  if (cuts_.empty()) {
    if (!match.segments_alone.empty()) return lone_segments(rule, match);
    return false;
  }
  std::vector<SegmentCut> cuts;
  for (auto& [s, points] : cuts_) {
    Segment& segment = pslg_.segments[s.index()];
    const Point a = pslg_.points[segment.a.index()];
    const std::optional<ArcOver> arc = arc_over(pslg_, segment);
    const auto way_to = [&](Point p) { return arc ? arc->share_of(p) : length(p - a); };
    std::sort(points.begin(), points.end(),
              [&](Point p, Point q) { return way_to(p) < way_to(q); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    // Ends of chords are on their circle; here the other side is straight.
    const auto is_beside_arc = [&](Point p) {
      return distance_to_arc(pslg_, segment, p) > match.tolerance;
    };
    if (arc && std::any_of(points.begin(), points.end(), is_beside_arc)) straighten(segment);
    cuts.push_back({s, points});
    tell(rule, s, points);
  }
  cut_segments(pslg_, table_, cuts);
  return true;
}

/// Looks for the segment of `line` on which, or on whose arc, the image of `v` lies.
void SidesCompletion::place(VertexId v, const Isometry& map, const NamedLine& line,
                            double tolerance) {
  const Point image = image_of(map, pslg_.points[v.index()]);
  double least = kInfinity;
  SegmentId nearest;
  for (const SegmentId s : line.segments) {
    const Segment& segment = pslg_.segments[s.index()];
    const double distance = std::min(distance_to_segment(image, pslg_.points[segment.a.index()],
                                                         pslg_.points[segment.b.index()]),
                                     distance_to_arc(pslg_, segment, image));
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

void SidesCompletion::tell(const PeriodicRule& rule, SegmentId s,
                           const std::vector<Point>& points) {
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

/// The size of both lines of a rule, as match_sides() takes it.
double SidesCompletion::extent_of(const PeriodicRule& rule) const {
  Box both;
  for (const std::string& name : {rule.from, rule.to}) {
    for (const VertexId v : find_line(pslg_, table_, name).vertices)
      both.add(pslg_.points[v.index()]);
  }
  return both.extent();
}

/// How far the points without a match are from points of the other line, or where these are far,
/// from the line: the widest of these gaps.
double SidesCompletion::widest_gap(const PeriodicRule& rule, const SidesMatch& match) const {
  const double small = kSmallGap * extent_of(rule);
  const NamedLine from = find_line(pslg_, table_, rule.from),
                  to = find_line(pslg_, table_, rule.to);
  double widest = 0;
  for (const Lost& lost : lost_) {
    const bool is_from =
        std::binary_search(match.from_alone.begin(), match.from_alone.end(), lost.vertex);
    double gap = kInfinity;
    for (const VertexId v : (is_from ? to : from).vertices)
      gap = std::min(gap, length(pslg_.points[v.index()] - lost.image));
    widest = std::max(widest, gap <= small ? gap : lost.distance);
  }
  return widest;
}

Error SidesCompletion::mismatch(const PeriodicRule& rule, const SidesMatch& match) const {
  auto worst = lost_;
  std::stable_sort(worst.begin(), worst.end(),
                   [](const Lost& x, const Lost& y) { return x.distance > y.distance; });
  const Lost& first = worst[0];
  const double extent = extent_of(rule), widest = widest_gap(rule, match) / extent;
  const bool is_from = std::find(match.from_alone.begin(), match.from_alone.end(), first.vertex) !=
                       match.from_alone.end();
  std::vector<Point> where;
  for (const Lost& lost : worst) {
    if (where.size() < kUnmatchedTold) where.push_back(pslg_.points[lost.vertex.index()]);
  }
  return periodic_error(
      rule,
      fmt::format(
          "the lines do not match: {} of '{}' comes to {}, which is {} from '{}'{}{}",
          describe(pslg_.points[first.vertex.index()]), is_from ? rule.from : rule.to,
          describe(first.image), describe_roughly(first.distance), is_from ? rule.to : rule.from,
          worst.size() == 1
              ? ""
              : fmt::format("; {} more without a match", counted(worst.size() - 1, "point")),
          match.tolerance < widest * extent && widest <= kSmallGap
              ? fmt::format("; {} moves points of one side by so much to the images of the other",
                            weld_closing(widest))
              : std::string()),
      std::move(where));
}

Error SidesCompletion::lone_segments(const PeriodicRule& rule, const SidesMatch& match) const {
  const Segment& s = pslg_.segments[match.segments_alone[0].index()];
  const Point a = pslg_.points[s.a.index()], b = pslg_.points[s.b.index()];
  return periodic_error(
      rule,
      fmt::format("the lines do not match: the segment from {} to {} has no image", describe(a),
                  describe(b)),
      {a, b});
}

}  // namespace cover
