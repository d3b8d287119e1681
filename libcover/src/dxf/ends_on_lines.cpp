// Tested by tests/unit/dxf/read_dxf_test.cpp.
#include "dxf/ends_on_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geom/box.hpp"
#include "geom/predicates.hpp"
#include "geom/search/box_tree.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// An end beside a segment.
struct Beside {
  std::uint32_t segment = 0;
  double along = 0;
  std::uint32_t point = 0;
  double away = 0;
  friend constexpr auto operator<=>(const Beside&, const Beside&) = default;
};

/// By point: whether a straight segment ends there, or an arc.
std::vector<bool> ends_of_curves(const Input& input) {
  std::vector<bool> is_end(input.points.size());
  std::vector<std::uint32_t> chords(input.points.size());
  for (const InputSegment& s : input.segments)
    for (const std::uint32_t p : {s.a, s.b}) {
      if (s.circle == 0)
        is_end[p] = true;
      else
        ++chords[p];
    }
  for (std::size_t p = 0; p < chords.size(); ++p)
    if (chords[p] % 2 == 1) is_end[p] = true;
  return is_end;
}

std::vector<Beside> find_beside(const Input& input, double reach) {
  std::vector<std::uint32_t> straight;
  std::vector<Box> boxes;
  for (std::uint32_t s = 0; s < input.segments.size(); ++s) {
    if (input.segments[s].circle != 0) continue;
    straight.push_back(s);
    boxes.push_back(
        box_of(std::array{input.points[input.segments[s].a], input.points[input.segments[s].b]}));
  }
  const BoxTree tree(boxes);
  const std::vector<bool> is_end = ends_of_curves(input);
  std::vector<Beside> beside;
  for (std::uint32_t k = 0; k < is_end.size(); ++k) {
    if (!is_end[k]) continue;
    const Point p = input.points[k];
    const Box around{{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
    tree.visit(around, [&](std::uint32_t found) {
      const InputSegment& s = input.segments[straight[found]];
      if (s.a == k || s.b == k) return;
      const Point a = input.points[s.a], b = input.points[s.b];
      const Vector way = b - a, to_end = p - a;
      const double whole = length(way);
      const double along = dot(way, to_end) / whole;
      const double away = std::abs(cross(way, to_end)) / whole;
      if (away <= reach && along > reach && along < whole - reach &&
          orientation(a, b, p) != Sign::zero)
        beside.push_back({straight[found], along, k, away});
    });
  }
  std::sort(beside.begin(), beside.end());
  return beside;
}

}  // namespace

std::vector<EndOnLine> bend_to_ends(Input& input, double reach) {
  std::vector<EndOnLine> bent;
  if (!std::isfinite(reach)) return bent;
  const std::vector<Beside> beside = find_beside(input, reach);
  if (beside.empty()) return bent;
  std::vector<InputSegment> segments;
  auto next = beside.begin();
  for (std::uint32_t s = 0; s < input.segments.size(); ++s) {
    InputSegment rest = input.segments[s];
    const Point a = input.points[rest.a], b = input.points[rest.b];
    for (; next != beside.end() && next->segment == s; ++next) {
      bent.push_back({input.points[next->point], rest.id, a, b, next->away});
      InputSegment piece = rest;
      piece.b = rest.a = next->point;
      segments.push_back(std::move(piece));
    }
    segments.push_back(std::move(rest));
  }
  input.segments = std::move(segments);
  return bent;
}

}  // namespace cover
