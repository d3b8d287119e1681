// All lines of an input, edge by edge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <cover/error.hpp>
#include <cover/input.hpp>

#include "base/faults/complaint.hpp"

namespace cover {

/// An element of an input and its file, as InputSegment has it.
struct ElementOfFile : InputRef {
  std::uint32_t file = 0;
};

/// Calls f(a, b, circle, ref) for every segment, edge of a ring and edge of a line: its ends, the
/// number of its circle as in InputSegment, and the element that it belongs to.
template <class F>
void for_each_edge(const Input& input, F f) {
  for (const InputSegment& s : input.segments)
    f(input.points[s.a], input.points[s.b], s.circle,
      ElementOfFile{{InputKind::segment, s.id}, s.file});
  const auto path = [&](const std::vector<Point>& points, const std::vector<std::uint32_t>& circles,
                        bool is_closed, const ElementOfFile& ref) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k + 1 == points.size() && !is_closed) continue;
      f(points[k], points[k + 1 < points.size() ? k + 1 : 0], k < circles.size() ? circles[k] : 0,
        ref);
    }
  };
  const std::vector<std::uint32_t> straight;
  for (const InputPolygon& polygon : input.polygons) {
    for (std::size_t r = 0; r < polygon.rings.size(); ++r)
      path(polygon.rings[r], r < polygon.circles.size() ? polygon.circles[r] : straight, true,
           {{InputKind::polygon, polygon.id}, polygon.file});
  }
  for (const InputLine& line : input.lines)
    path(line.points, line.circles, false, {{InputKind::line, line.id}, line.file});
}

/// "polygon", "line" or "segment".
inline const char* describe_kind(InputKind kind) {
  return kind == InputKind::polygon ? "polygon" : kind == InputKind::line ? "line" : "segment";
}

/// "segment 3", "polygon 2 of b.json".
inline std::string describe_element(const Input& input, const ElementOfFile& element) {
  return fmt::format("{} {}{}", describe_kind(element.kind), element.id,
                     file_suffix(input, element.file));
}

}  // namespace cover
