// Thousands of polygons over each other cross at millions of places, of which next to none are
// seen. Each is worth some microseconds and a thousand bytes, so what one polygon alone hides is
// left out before lines are cut.
// Tested by tests/unit/clean/paint/hidden_polygons_test.cpp.
#include "clean/paint/hidden_polygons.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/containers/order.hpp"
#include "clean/arcs/input_edges.hpp"
#include "clean/paint/paint.hpp"
#include "geom/box.hpp"
#include "geom/predicates.hpp"
#include "geom/rings/place_in_ring.hpp"
#include "geom/subdivision/crossings_at_least.hpp"

namespace cover {
namespace {

/// Crossings for each edge from which on it pays.
constexpr double kCrowd = 4;
/// Edges that are looked at, for all polygons together.
constexpr std::size_t kMostEdges = 200'000'000;

bool is_crowded(const Input& input) {
  std::vector<PlainSegment> edges;
  for_each_edge(input, [&](Point a, Point b, std::uint32_t, const InputRef& element) {
    if (element.kind == InputKind::polygon) edges.push_back({a, b});
  });
  return crossings_at_least(edges) > kCrowd * static_cast<double>(edges.size());
}

Box box_around(const InputPolygon& polygon) {
  Box box;
  for (const std::vector<Point>& ring : polygon.rings) box.include(box_of(ring));
  return box;
}

/// Whether `outer` has its sides around those of `inner`.
bool surrounds(const Box& outer, const Box& inner) {
  return outer.low.x < inner.low.x && inner.high.x < outer.high.x && outer.low.y < inner.low.y &&
         inner.high.y < outer.high.y;
}

/// False only if the edge from a to b has no point in common with the box.
bool may_meet(const Box& box, Point a, Point b) {
  if (!box_of(std::array{a, b}).meets(box)) return false;
  const Sign side = orientation(a, b, box.low);
  return side == Sign::zero || orientation(a, b, box.high) != side ||
         orientation(a, b, {box.low.x, box.high.y}) != side ||
         orientation(a, b, {box.high.x, box.low.y}) != side;
}

/// Whether all of the box lies inside of the polygon, away from its edges.
bool covers(const InputPolygon& polygon, const Box& box) {
  bool is_inside = false;
  for (const std::vector<Point>& ring : polygon.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (may_meet(box, ring[k], ring[k + 1 < ring.size() ? k + 1 : 0])) return false;
    }
    is_inside ^= place_in(ring, box.low) == Place::inside;
  }
  return is_inside;
}

/// The polygons of the largest boxes, by number, as many as may be tried over all others.
std::vector<std::uint32_t> largest_of(const std::vector<InputPolygon>& polygons,
                                      const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> order =
      sorted_numbers(polygons.size(), [&](std::uint32_t p, std::uint32_t q) {
        return boxes[p].width() * boxes[p].height() > boxes[q].width() * boxes[q].height();
      });
  std::size_t edges = 0, count = 0;
  for (; count < order.size() && edges <= kMostEdges / order.size(); ++count) {
    for (const std::vector<Point>& ring : polygons[order[count]].rings) edges += ring.size();
  }
  order.resize(count);
  return order;
}

}  // namespace

std::vector<bool> hidden_polygons(const Input& input, Overlap overlap) {
  const std::size_t count = input.polygons.size();
  std::vector<bool> hidden(count, false);
  if (overlap == Overlap::error || count < 2 || !is_crowded(input)) return hidden;
  std::vector<Box> boxes;
  for (const InputPolygon& polygon : input.polygons) boxes.push_back(box_around(polygon));
  const std::vector<std::uint32_t> largest = largest_of(input.polygons, boxes);
  const std::vector<std::uint32_t> rank = ranks_of(input.polygons, overlap);
  for (std::uint32_t p = 0; p < count; ++p) {
    if (boxes[p].is_empty()) continue;
    hidden[p] = std::any_of(largest.begin(), largest.end(), [&](std::uint32_t q) {
      return rank[q] > rank[p] && surrounds(boxes[q], boxes[p]) &&
             covers(input.polygons[q], boxes[p]);
    });
  }
  return hidden;
}

}  // namespace cover
