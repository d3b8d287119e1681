// Equal points and segments are found by sorting; whatever else keeps the input from being a PSLG
// also keeps it from having a constrained Delaunay triangulation.
// Tested by tests/unit/clean/pslg_test.cpp.
#include "clean/check_pslg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include <cover/text.hpp>

#include "base/containers/give_back.hpp"
#include "base/containers/order.hpp"
#include "base/faults/complaint.hpp"
#include "base/sort_by_team.hpp"
#include "cdt/cdt.hpp"
#include "clean/list_meetings.hpp"

namespace cover {
namespace {

InputRef point_ref(const Input& input, std::size_t k) {
  return {InputKind::point, point_id(input, k)};
}
InputRef segment_ref(const Input& input, std::size_t s) {
  return {InputKind::segment, input.segments[s].id};
}

std::optional<Error> find_duplicate_points(const Input& input) {
  const std::vector<std::uint32_t> order = sorted_numbers(
      input.points.size(),
      [&](std::uint32_t i, std::uint32_t j) { return input.points[i] < input.points[j]; });
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
    const InputSegment& first = input.segments[keys[k - 1][2]];
    complaint.add(
        fmt::format("{}, between {} and {}, is the same as segment {}{}", name_of_segment(input, s),
                    describe(input.points[low]), describe(input.points[high]), first.id,
                    file_suffix(input, first.file)),
        {input.points[low], input.points[high]},
        {segment_ref(input, keys[k - 1][2]), segment_ref(input, s)});
  }
  if (complaint.empty()) return {};
  return complaint.error();
}

/// Above and below these, products of four lengths are no doubles any more.
constexpr double kLargest = 0x1p250, kSmallest = 0x1p-250;

/// Calls `f` with every place in the input, a function that names it, and its element.
template <class F>
void for_each_place(const Input& input, F f) {
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    f(
        input.points[k], [&] { return name_of_point(input, k); }, point_ref(input, k));
  }
  const auto seed = [&](const char* what, const auto& s, InputKind kind) {
    f(
        s.at, [&] { return fmt::format("{} {}{}", what, s.id, line_suffix(s.line)); },
        InputRef{kind, s.id});
  };
  for (const RegionSeed& s : input.seeds) seed("region seed", s, InputKind::region_seed);
  for (const HoleSeed& s : input.holes) seed("hole seed", s, InputKind::hole);
  const auto corners = [&](const char* what, const std::vector<Point>& points, InputRef ref) {
    for (const Point& p : points) {
      f(
          p, [&] { return fmt::format("the corner at {} of {} {}", describe(p), what, ref.id); },
          ref);
    }
  };
  for (const InputPolygon& polygon : input.polygons) {
    for (const auto& ring : polygon.rings) {
      corners("polygon", ring, {InputKind::polygon, polygon.id});
    }
  }
  for (const InputLine& line : input.lines) {
    corners("line", line.points, {InputKind::line, line.id});
  }
}

std::optional<Error> find_wild_coordinates(const Input& input) {
  Complaint infinite(ErrorCode::non_finite_coordinate, input.source);
  Complaint vast(ErrorCode::coordinate_out_of_range, input.source);
  double largest = 0;
  for_each_place(input, [&](Point p, const auto& name, InputRef ref) {
    const double size = std::max(std::abs(p.x), std::abs(p.y));
    if (!(std::isfinite(p.x) && std::isfinite(p.y))) {
      infinite.add(name() + " is not finite", {p}, {ref});
    } else if (size > kLargest) {
      vast.add(fmt::format("{} is too far out: coordinates go up to {:.2g}", name(), kLargest), {p},
               {ref});
    }
    largest = std::max(largest, size);
  });
  if (!infinite.empty()) return infinite.error();
  if (largest > 0 && largest < kSmallest) {
    vast.add(fmt::format("no coordinate is above {}, too little to compute with: at least one must "
                         "reach {:.2g}",
                         largest, kSmallest),
             {}, {});
  }
  if (!vast.empty()) return vast.error();
  return {};
}

}  // namespace

std::optional<Error> find_unusable(const Input& input) {
  if (auto error = find_wild_coordinates(input)) return error;
  Complaint range(ErrorCode::id_out_of_range, input.source);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const InputSegment& segment = input.segments[s];
    if (std::max(segment.a, segment.b) < input.points.size()) continue;
    range.add(
        fmt::format("segment {}{} ends at the point with the index {}, but there are {} points",
                    segment.id, line_suffix(segment.line), std::max(segment.a, segment.b),
                    input.points.size()),
        {}, {segment_ref(input, s)});
  }
  if (!range.empty()) return range.error();
  return {};
}

std::optional<Triangulation> triangulation_if_pslg(const Input& input, const Team& team) {
  const std::size_t count = input.segments.size();
  std::vector<IndexPair> pairs(count), ascending(count);
  std::atomic<bool> all_differ = true;
  team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const InputSegment& s = input.segments[k];
      pairs[k] = {s.a, s.b};
      ascending[k] = {std::min(s.a, s.b), std::max(s.a, s.b)};
      if (s.a == s.b) all_differ = false;
    }
  });
  if (!all_differ) return std::nullopt;
  sort_by_team(ascending, std::less(), team);
  team.each_range(count, kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = std::max<std::size_t>(first, 1); k < last; ++k)
      if (ascending[k - 1] == ascending[k]) all_differ = false;
  });
  if (!all_differ) return std::nullopt;
  give_back(ascending);
  CdtResult cdt = triangulate_hull(input.points, pairs, team);
  if (!cdt.conflicts.empty()) return std::nullopt;
  return std::move(cdt.triangulation);
}

std::optional<Error> find_unclean(const Input& input) {
  if (auto error = find_duplicate_points(input)) return error;
  if (auto error = find_zero_length_segments(input)) return error;
  if (auto error = find_duplicate_segments(input)) return error;
  return list_meetings(input);
}

}  // namespace cover
