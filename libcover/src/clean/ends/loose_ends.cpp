// Tested by tests/unit/clean/ends/loose_ends_test.cpp.
#include "clean/ends/loose_ends.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <cover/option_ranges.hpp>
#include <cover/text.hpp>

#include "base/faults/complaint.hpp"
#include "clean/ends/near_points.hpp"
#include "geom/ulp.hpp"
#include "geom/vector.hpp"

namespace cover {

double rounding_of(std::span<const Point> points) {
  constexpr double kUnits = 4;
  return kUnits * spacing_of(points);
}

std::vector<LooseGap> find_loose_gaps(std::span<const Point> points,
                                      std::span<const IndexPair> segments, double reach) {
  std::vector<std::uint32_t> degree(points.size(), 0), joined(points.size(), kNone);
  for (const auto& [a, b] : segments) {
    ++degree[a], ++degree[b];
    joined[a] = b, joined[b] = a;
  }
  if (std::find(degree.begin(), degree.end(), 1U) == degree.end()) return {};
  const NearPoints ends(points, reach, [&](std::uint32_t v) { return degree[v] > 0; });
  std::vector<LooseGap> gaps;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (degree[v] != 1) continue;
    LooseGap gap{v, v, reach};
    ends.visit(points[v], [&](std::uint32_t w) {
      const double distance = length(points[w] - points[v]);
      if (w == v || w == joined[v] || !(distance <= gap.distance)) return;
      if (gap.other != v && distance == gap.distance) return;
      gap.other = w;
      gap.distance = distance;
    });
    if (gap.other != v) gaps.push_back(gap);
  }
  return gaps;
}

std::string weld_closing(double widest) {
  if (widest <= kAutoWeld) return "--weld auto";
  const double unit = std::pow(10, std::floor(std::log10(widest)));
  // Above what is measured, which is rounded.
  return fmt::format("--weld {:.0e}", std::ceil(widest / unit * (1 + 0x1p-20)) * unit);
}

std::optional<Input> join_loose_ends(const Input& input, std::vector<Change>& changes) {
  std::vector<IndexPair> segments;
  for (const InputSegment& s : input.segments) segments.push_back({s.a, s.b});
  std::vector<LooseGap> gaps = find_loose_gaps(input.points, segments, rounding_of(input.points));
  // Equal coordinates are one point anyway.
  std::erase_if(gaps, [](const LooseGap& gap) { return gap.distance == 0; });
  if (gaps.empty()) return std::nullopt;
  Input out = input;
  std::vector<bool> taken(input.points.size(), false);
  for (LooseGap gap : gaps) {
    if (taken[gap.loose] || taken[gap.other]) continue;
    taken[gap.loose] = taken[gap.other] = true;
    out.points[gap.loose] = out.points[gap.other];
    changes.push_back({Change::Kind::welded,
                       fmt::format("point {} at {} was moved by {} onto point {} at {}",
                                   point_id(input, gap.loose), describe(input.points[gap.loose]),
                                   describe_roughly(gap.distance), point_id(input, gap.other),
                                   describe(input.points[gap.other])),
                       {input.points[gap.loose], input.points[gap.other]},
                       {{InputKind::point, point_id(input, gap.loose)}}});
  }
  return out;
}

}  // namespace cover
