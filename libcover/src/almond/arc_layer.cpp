// Two almonds can meet in a visible point only inside a triangle that both of them reach. Of the
// pairs found so, those whose sides are too far apart are dropped; the others are met once each,
// and a meeting counts if both sides see it, which a straight walk through the triangulation
// decides with exact predicates.
// Tested by tests/unit/almond/arc_layer_test.cpp.
#include "almond/arc_layer.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "almond/arc_meeting.hpp"
#include "almond/arc_walk.hpp"
#include "base/containers/order.hpp"
#include "base/containers/union_find.hpp"
#include "base/team.hpp"
#include "cdt/search/sight.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

using Pair = std::array<std::uint32_t, 2>;

/// An almond lies in the disk that has its side as diameter: pairs of disjoint disks cannot meet.
bool are_near(const Almond& a, const Almond& b) {
  const Vector doubled{(a.from.x - b.from.x) + (a.to.x - b.to.x),
                       (a.from.y - b.from.y) + (a.to.y - b.to.y)};
  const double reach = a.length + b.length;
  return squared_length(doubled) <= reach * reach * (1 + kArcRounding);
}

/// The pairs of almonds that reach a common triangle and are near, each once, in order.
std::vector<Pair> find_pairs(const Triangulation& cdt, std::span<const Almond> almonds,
                             const Reach& reach) {
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> order;
  const auto left_end = [&](std::uint32_t k) {
    return (almonds[k].from.x + almonds[k].to.x) / 2 - almonds[k].length / 2;
  };
  const auto right_end = [&](std::uint32_t k) {
    return (almonds[k].from.x + almonds[k].to.x) / 2 + almonds[k].length / 2;
  };
  for (std::uint32_t t = 0; t < cdt.triangles.size(); ++t) {
    const auto visitors = reach.visitors_of(t);
    order.assign(visitors.begin(), visitors.end());
    // Many almonds may reach one large triangle: sweep, so that only neighbours are compared.
    const bool sweep = order.size() > 16;
    if (sweep) {
      std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double x = left_end(a), y = left_end(b);
        return x < y || (x == y && a < b);
      });
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        if (sweep && left_end(order[j]) > right_end(order[i])) break;
        if (!are_near(almonds[order[i]], almonds[order[j]])) continue;
        pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
      }
    }
  }
  sort_unique(pairs);
  return pairs;
}

class Layer {
 public:
  Layer(const Triangulation& cdt, std::span<const Almond> almonds, const Team& team)
      : cdt_(cdt),
        almonds_(almonds),
        team_(team),
        reach_(walk_almonds(cdt, almonds)),
        points_(cdt.points) {}

  ArcLayer build(double unite) {
    entries_.resize(reach_.known.size());
    team_.each_range(almonds_.size(), kFewAtATime, [this](std::size_t first, std::size_t last) {
      std::size_t at = reach_.first_known[first];
      for (auto k = static_cast<std::uint32_t>(first); k < last; ++k)
        for (const KnownVertex& known : reach_.known_of(k))
          entries_[at++] = {almonds_[k].place_of_ratio(known.ratio), k, known.vertex};
    });
    const std::vector<Pair> pairs = find_pairs(cdt_, almonds_, reach_);
    for (const Pair& pair : pairs) add_meetings(pair[0], pair[1]);
    sort_entries();
    ArcLayer layer = unite_near(unite);
    layer.visits = reach_.visitors.size() + pairs.size();
    return layer;
  }

 private:
  struct Entry {
    double place;
    std::uint32_t almond;
    std::uint32_t vertex;
  };
  /// Almonds that are one piece of work.

  void add_meetings(std::uint32_t a, std::uint32_t b) {
    const Meetings meetings =
        meet(almonds_[a], reach_.known_of(a), almonds_[b], reach_.known_of(b));
    for (int i = 0; i < meetings.count; ++i) {
      const Meeting& m = meetings.item[static_cast<std::size_t>(i)];
      if (!sees(a, m.at, b) || !sees(b, m.at, a)) continue;
      const auto vertex = static_cast<std::uint32_t>(points_.size());
      points_.push_back(m.at);
      entries_.push_back({m.place_a, a, vertex});
      entries_.push_back({m.place_b, b, vertex});
    }
  }

  /// True if nothing lies between a side and a point of its arc and that of `other`. A point of a
  /// hull side may lie outside by rounding.
  [[nodiscard]] bool sees(std::uint32_t almond, Point x, std::uint32_t other) const {
    const Almond& a = almonds_[almond];
    const Walk walk = walk_straight(cdt_, a.base.triangle, midpoint(a.from, a.to), x);
    if (walk.arrived) return true;
    for (const Almond& h : {std::cref(a), std::cref(almonds_[other])}) {
      if (h.kind == AlmondKind::hull_side && walk.at.triangle == h.base.triangle &&
          walk.at.edge == h.base.edge) {
        return true;
      }
    }
    return false;
  }

  /// By almond and place; counting sort by almond, since the lists are short.
  void sort_entries() {
    first_.assign(almonds_.size() + 1, 0);
    for (const Entry& e : entries_) ++first_[e.almond + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    std::vector<Entry> sorted(entries_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Entry& e : entries_) sorted[next[e.almond]++] = e;
    team_.each_range(almonds_.size(), kFewAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        std::sort(sorted.begin() + first_[k], sorted.begin() + first_[k + 1],
                  [](const Entry& a, const Entry& b) {
                    return a.place < b.place || (a.place == b.place && a.vertex < b.vertex);
                  });
    });
    entries_ = std::move(sorted);
  }

  ArcLayer unite_near(double unite) {
    // The lower one of two stays, so input vertices stay where they are.
    UnionFind unions(points_.size());
    for (std::size_t k = 0; k + 1 < entries_.size(); ++k) {
      unite_flat(entries_[k], unions);
      const Entry& e = entries_[k];
      const Entry& f = entries_[k + 1];
      if (e.almond != f.almond || (is_input(e.vertex) && is_input(f.vertex))) continue;
      const double near = unite * kArcRounding * almonds_[e.almond].length;
      if (squared_length(points_[f.vertex] - points_[e.vertex]) <= near * near) {
        unions.unite(e.vertex, f.vertex);
      }
    }
    ArcLayer layer;
    layer.first.push_back(0);
    for (std::size_t k = 0; k < almonds_.size(); ++k) {
      append_arc(k, unions, layer);
      layer.first.push_back(static_cast<std::uint32_t>(layer.vertices.size()));
    }
    layer.points = std::move(points_);
    return layer;
  }

  /// On a flat arc, a vertex so near to an end that its height over the side cannot be resolved
  /// becomes that end.
  void unite_flat(const Entry& e, UnionFind& unions) const {
    const Almond& a = almonds_[e.almond];
    const double height = a.nu * a.length * std::min(e.place, 1 - e.place);
    if (is_input(e.vertex) || a.kind == AlmondKind::hull_side ||
        height >= kFlatArc * a.resolution) {
      return;
    }
    unions.unite(e.vertex, e.place < 0.5 ? a.u : a.v);
  }

  [[nodiscard]] bool is_input(std::uint32_t vertex) const { return vertex < cdt_.points.size(); }

  /// The vertices of one arc: the ends as they are, inner ones that were not united with an end or
  /// with their predecessor.
  void append_arc(std::size_t almond, UnionFind& unions, ArcLayer& layer) const {
    const Almond& a = almonds_[almond];
    layer.vertices.push_back({a.u, 0});
    for (std::uint32_t k = first_[almond]; k < first_[almond + 1]; ++k) {
      const std::uint32_t vertex = unions.find(entries_[k].vertex);
      if (vertex == layer.vertices.back().vertex || vertex == a.u || vertex == a.v) continue;
      layer.vertices.push_back({vertex, entries_[k].place});
    }
    layer.vertices.push_back({a.v, 1});
  }

  const Triangulation& cdt_;
  std::span<const Almond> almonds_;
  const Team& team_;
  Reach reach_;
  std::vector<Point> points_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> first_;  ///< by almond, into entries_ once they are sorted
};

}  // namespace

ArcLayer lay_arcs(const Triangulation& cdt, std::span<const Almond> almonds, double unite,
                  const Team& team) {
  return Layer(cdt, almonds, team).build(unite);
}

}  // namespace cover
