// Equal points and segments are found by sorting; whatever else keeps the input from being a PSLG
// also keeps it from having a constrained Delaunay triangulation, whose construction names the
// place. Tested by tests/unit/region/pslg_test.cpp.
#include "region/check_pslg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/describe.hpp"
#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "region/complaint.hpp"

namespace cover {
namespace {

InputRef point_ref(const Input& input, std::size_t k) {
  return {InputKind::point, point_id(input, k)};
}
InputRef segment_ref(const Input& input, std::size_t s) {
  return {InputKind::segment, input.segments[s].id};
}

std::optional<Error> find_duplicate_points(const Input& input) {
  std::vector<std::uint32_t> order(input.points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(input.points[i], i) < std::pair(input.points[j], j);
  });
  Complaint complaint(ErrorCode::duplicate_point, input.source);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t i = order[k - 1], j = order[k];
    if (input.points[i] != input.points[j]) continue;
    complaint.add(fmt::format("{} has the coordinates of point {}", name_of_point(input, j),
                              point_id(input, i)),
                  {input.points[j]}, {point_ref(input, i), point_ref(input, j)});
  }
  if (complaint.empty()) return {};
  return complaint.error();
}

std::optional<Error> find_zero_length_segments(const Input& input) {
  Complaint complaint(ErrorCode::zero_length_segment, input.source);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const InputSegment& segment = input.segments[s];
    if (segment.a != segment.b) continue;
    complaint.add(fmt::format("{} at {} has length zero", name_of_segment(input, s),
                              describe(input.points[segment.a])),
                  {input.points[segment.a]}, {segment_ref(input, s)});
  }
  if (complaint.empty()) return {};
  return complaint.error();
}

std::optional<Error> find_duplicate_segments(const Input& input) {
  std::vector<std::array<std::uint32_t, 3>> keys(input.segments.size());
  for (std::uint32_t s = 0; s < keys.size(); ++s) {
    const auto [low, high] = std::minmax(input.segments[s].a, input.segments[s].b);
    keys[s] = {low, high, s};
  }
  std::sort(keys.begin(), keys.end());
  Complaint complaint(ErrorCode::duplicate_segment, input.source);
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const auto& [low, high, s] = keys[k];
    if (keys[k - 1][0] != low || keys[k - 1][1] != high) continue;
    complaint.add(fmt::format("{}, between {} and {}, is the same as segment {}",
                              name_of_segment(input, s), describe(input.points[low]),
                              describe(input.points[high]), input.segments[keys[k - 1][2]].id),
                  {input.points[low], input.points[high]},
                  {segment_ref(input, keys[k - 1][2]), segment_ref(input, s)});
  }
  if (complaint.empty()) return {};
  return complaint.error();
}

/// The intersection of two lines, for messages.
Point meeting_point(Point a, Point b, Point c, Point d) {
  const double t = cross(c - a, d - c) / cross(b - a, d - c);
  return a + t * (b - a);
}

Error crossing(const Input& input, std::size_t first, std::size_t second) {
  const InputSegment &s = input.segments[first], &t = input.segments[second];
  const Point at =
      meeting_point(input.points[s.a], input.points[s.b], input.points[t.a], input.points[t.b]);
  Complaint complaint(ErrorCode::crossing_segments, input.source);
  complaint.add(fmt::format("{} crosses {} near {}", name_of_segment(input, first),
                            name_of_segment(input, second), describe(at)),
                {at}, {segment_ref(input, first), segment_ref(input, second)});
  return complaint.error();
}

/// The segment that starts at `point`, which lies inside segment `s`, and runs along `s`.
std::optional<std::size_t> overlapping_segment(const Input& input, std::uint32_t point,
                                               std::size_t s) {
  const Point a = input.points[input.segments[s].a], b = input.points[input.segments[s].b];
  for (std::size_t k = 0; k < input.segments.size(); ++k) {
    const InputSegment& t = input.segments[k];
    if (k == s || (t.a != point && t.b != point)) continue;
    if (orientation(a, b, input.points[t.a == point ? t.b : t.a]) == Sign::zero) return k;
  }
  return {};
}

Error point_on_segment(const Input& input, std::uint32_t point, std::size_t s) {
  const Point at = input.points[point];
  if (const auto other = overlapping_segment(input, point, s)) {
    Complaint complaint(ErrorCode::overlapping_segments, input.source);
    complaint.add(fmt::format("{} and {} overlap from {} on", name_of_segment(input, s),
                              name_of_segment(input, *other), name_of_point(input, point)),
                  {at}, {segment_ref(input, s), segment_ref(input, *other)});
    return complaint.error();
  }
  Complaint complaint(ErrorCode::point_on_segment, input.source);
  complaint.add(
      fmt::format("{} lies inside {}", name_of_point(input, point), name_of_segment(input, s)),
      {at}, {point_ref(input, point), segment_ref(input, s)});
  return complaint.error();
}

std::optional<Error> find_crossings(const Input& input) {
  std::vector<IndexPair> pairs;
  pairs.reserve(input.segments.size());
  for (const InputSegment& s : input.segments) pairs.push_back({s.a, s.b});
  const CdtResult cdt = triangulate_hull(input.points, pairs);
  if (cdt.conflicts.empty()) return {};
  const CdtConflict& c = cdt.conflicts.front();
  if (c.kind == CdtConflict::Kind::crossing) return crossing(input, c.first, c.second);
  return point_on_segment(input, c.first, c.second);
}

/// Complains of the corners of a polygon or a line that are not finite.
void add_infinite(const std::vector<Point>& points, const char* what, InputRef ref,
                  Complaint& complaint) {
  for (const Point& p : points) {
    if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
    complaint.add(fmt::format("the corner at {} of {} {} is not finite", describe(p), what, ref.id),
                  {p}, {ref});
  }
}

}  // namespace

std::optional<Error> find_unusable(const Input& input) {
  Complaint finite(ErrorCode::non_finite_coordinate, input.source);
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    const Point p = input.points[k];
    if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
    finite.add(name_of_point(input, k) + " is not finite", {p}, {point_ref(input, k)});
  }
  for (const RegionSeed& seed : input.seeds) {
    if (std::isfinite(seed.at.x) && std::isfinite(seed.at.y)) continue;
    finite.add(fmt::format("region seed {}{} is not finite", seed.id, line_suffix(seed.line)),
               {seed.at}, {{InputKind::region_seed, seed.id}});
  }
  for (const HoleSeed& hole : input.holes) {
    if (std::isfinite(hole.at.x) && std::isfinite(hole.at.y)) continue;
    finite.add(fmt::format("hole seed {}{} is not finite", hole.id, line_suffix(hole.line)),
               {hole.at}, {{InputKind::hole, hole.id}});
  }
  for (const InputPolygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) {
      add_infinite(ring, "polygon", {InputKind::polygon, polygon.id}, finite);
    }
  }
  for (const InputLine& line : input.lines) {
    add_infinite(line.points, "line", {InputKind::line, line.id}, finite);
  }
  if (!finite.empty()) return finite.error();
  Complaint range(ErrorCode::id_out_of_range, input.source);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const InputSegment& segment = input.segments[s];
    if (std::max(segment.a, segment.b) < input.points.size()) continue;
    range.add(fmt::format("segment {}{} ends at a point that does not exist", segment.id,
                          line_suffix(segment.line)),
              {}, {segment_ref(input, s)});
  }
  if (!range.empty()) return range.error();
  return {};
}

std::optional<Error> find_unclean(const Input& input) {
  if (auto error = find_duplicate_points(input)) return error;
  if (auto error = find_zero_length_segments(input)) return error;
  if (auto error = find_duplicate_segments(input)) return error;
  return find_crossings(input);
}

}  // namespace cover
