// For two elements E and F of different cycles take the disk whose diameter is the shortest segment
// between them. If no other element enters it, it is inserted and the cycles are one. Otherwise let
// G be the element nearest to its centre: the pair (E, F) is replaced by (E, G) and (G, F), which
// are closer, so this ends; and the pairs still connect all cycles, so at the end one is left.
// Shortest pairs go first. Two lines never make a disk, as the disks at their ends are nearer.
// Tested by tests/unit/disks/fill_disks_test.cpp.
#include "disks/packing/connect_holes.hpp"

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>

#include "base/containers/union_find.hpp"
#include "base/numbers.hpp"
#include "disks/packing/reduce_cycles.hpp"

namespace cover::disks {
namespace {

struct Segment {
  Point a, b;
};

Segment ends_of(const Element& line) {
  return {line.c + line.from * line.d, line.c + line.to * line.d};
}

Point nearest_on(const Element& line, Point x) {
  return line.c + std::clamp(dot(line.d, x - line.c), line.from, line.to) * line.d;
}

/// The shortest segment from `e` to `f`.
Segment shortest(const Element& e, const Element& f) {
  if (e.is_disk() && f.is_disk()) return {contact(e, f.c), contact(f, e.c)};
  if (e.is_line() && f.is_disk()) {
    const Point a = nearest_on(e, f.c);
    return {a, contact(f, a)};
  }
  if (e.is_disk()) {
    const Segment s = shortest(f, e);
    return {s.b, s.a};
  }
  const Segment u = ends_of(e), v = ends_of(f);
  Segment best{u.a, nearest_on(f, u.a)};
  for (const Segment s : {Segment{u.b, nearest_on(f, u.b)}, Segment{nearest_on(e, v.a), v.a},
                          Segment{nearest_on(e, v.b), v.b}}) {
    if (squared_length(s.b - s.a) < squared_length(best.b - best.a)) best = s;
  }
  return best;
}

}  // namespace

bool connect_holes(Packing& packing, std::span<const std::array<Index, 2>> pairs,
                   double tolerance) {
  if (pairs.empty()) return true;
  std::vector<Index> cluster_of(packing.elements.size(), kNone);
  UnionFind clusters(packing.cycles.size());
  for (const Side& s : packing.sides) {  // a disk on the boundary may lie on several cycles
    if (cluster_of[s.element] == kNone) cluster_of[s.element] = s.cycle;
    clusters.unite(cluster_of[s.element], s.cycle);
  }

  using Entry = std::tuple<double, Index, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  /// False if they are not closer than that: by rounding alone, and pairs could replace each other
  /// for ever.
  const auto push = [&](Index e, Index f, double further) {
    if (clusters.find(cluster_of[e]) == clusters.find(cluster_of[f])) return true;
    const Segment s = shortest(packing.elements[e], packing.elements[f]);
    const double gap = norm(s.b - s.a);
    if (!(gap < further)) return false;
    queue.emplace(gap, std::min(e, f), std::max(e, f));
    return true;
  };
  for (const auto& [e, f] : pairs) {
    if (!push(e, f, kInfinity)) return false;
  }

  while (!queue.empty()) {
    const auto [gap, e, f] = queue.top();
    queue.pop();
    if (clusters.find(cluster_of[e]) == clusters.find(cluster_of[f])) continue;
    const Segment s = shortest(packing.elements[e], packing.elements[f]);
    const Circle disk{midpoint(s.a, s.b), gap / 2};
    const Index g = packing.nearest_obstacle(disk.c, disk.r * (1 - 1e-9), kNone, e, f);
    if (g != kNone) {
      if (!push(e, g, gap) || !push(g, f, gap)) return false;
      continue;
    }
    const std::vector<Contact> contacts = touched_sides(packing, disk, {}, kNone, tolerance);
    if (contacts.size() < 2) return false;
    const auto element = static_cast<Index>(packing.elements.size());
    packing.insert_disk(disk, contacts);
    for (const Contact& c : contacts) {
      clusters.unite(cluster_of[packing.sides[c.side].element], cluster_of[e]);
    }
    cluster_of.push_back(cluster_of[e]);
    if (cluster_of.size() != element + 1 ||
        clusters.find(cluster_of[e]) != clusters.find(cluster_of[f])) {
      return false;
    }
  }

  packing.find_cycles();
  return true;
}

}  // namespace cover::disks
