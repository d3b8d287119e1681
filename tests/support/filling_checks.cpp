#include "support/filling_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geom/predicates.hpp"
#include "geom/vector.hpp"

namespace cover::testing {

FillTask task_of(const RegionBoundary& boundary) {
  FillTask task;
  task.points = boundary.points;
  for (const auto& [a, b] : boundary.sides) task.chords.push_back({a, b, false});
  return task;
}

FillingFacts check_filling(const FillTask& task, const Filling& filling) {
  FillingFacts facts;
  const std::size_t n = task.points.size();
  const auto at = [&](std::uint32_t v) { return v < n ? task.points[v] : filling.added[v - n]; };
  std::map<std::array<std::uint32_t, 2>, int> edges;
  std::set<std::uint32_t> used;
  long double area = 0, wanted = 0;
  double largest = 0;
  for (const auto& t : filling.triangles) {
    const Point a = at(t[0]), b = at(t[1]), c = at(t[2]);
    if (orientation(a, b, c) != Sign::positive) facts.fault = "a triangle is not counter-clockwise";
    area += cross(b - a, c - a);
    largest = std::max({largest, angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
      used.insert(t[k]);
    }
  }
  const Point o = task.points[0];
  for (const Chord& c : task.chords) wanted += cross(task.points[c.a] - o, task.points[c.b] - o);
  if (std::abs(area - wanted) > 1e-10L * wanted) facts.fault = "the area is wrong";

  std::map<std::uint32_t, std::vector<std::uint32_t>> splits;
  for (const ChordSplit& s : filling.splits) splits[s.chord] = s.vertices;
  for (std::uint32_t k = 0; k < task.chords.size(); ++k) {
    std::vector<std::uint32_t> chain{task.chords[k].a};
    chain.insert(chain.end(), splits[k].begin(), splits[k].end());
    chain.push_back(task.chords[k].b);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (--edges[{chain[i], chain[i + 1]}] != 0) facts.fault = "a chord is no chain of edges";
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto other = edges.find({edge[1], edge[0]});
    if (count > 1 || (count == 1 && (other == edges.end() || other->second != 1))) {
      facts.fault = "an inner edge is not used once from each side";
    }
  }
  for (std::uint32_t v = 0; v < n; ++v) {
    if (!used.contains(v)) facts.fault = "an input point is no vertex";
  }
  facts.largest_angle = largest * 180 / std::numbers::pi;
  facts.vertices = used.size();
  facts.triangles = filling.triangles.size();
  return facts;
}

}  // namespace cover::testing
