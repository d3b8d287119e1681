// What nearly touches is found in the constrained Delaunay triangulation of the noded lines: from
// each end of a line over all triangles that come nearer than the tolerance. So the search sees
// only what is in sight, and costs no more where lines are long and dense. Welds are then made in
// the drawing before noding, so that no crossing of two versions of one border leaves a trace; the
// rest is done again until nothing is left to weld. Where lines lie so close together that noding
// gives up, ends are united first without it.
// Tested by tests/unit/clean/ends/weld_test.cpp.
#include "clean/ends/weld.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "clean/ends/loose_ends.hpp"
#include "geom/box.hpp"
#include "geom/foot.hpp"
#include "geom/triangle.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

/// The part of the shortest edge at a point by which it may move: small enough that both ends of an
/// edge and what is bent to it can move without any corner turning over.
constexpr double kFeaturePart = 1.0 / 8;
constexpr int kMostRounds = 16;
constexpr int kMostTriangles = 1000;  ///< looked at from one corner of one triangle

/// Two ends that may become one.
struct NearPair {
  double distance = 0;
  std::uint32_t u = 0, w = 0;
  friend auto operator<=>(const NearPair&, const NearPair&) = default;
};

/// An end to which a line may be bent.
struct NearLine {
  std::uint32_t raw = 0;
  double place = 0;  ///< along the line, from 0 to 1
  std::uint32_t w = 0;
  double distance = 0;
  friend auto operator<=>(const NearLine&, const NearLine&) = default;
};

/// From the area, without the difference of two near places that distance_to_segment() takes.
double distance_from_segment(Point a, Point b, Point w) {
  const double place = part_on_line(a, b, w);
  if (place <= 0) return length(w - a);
  if (place >= 1) return length(w - b);
  return distance_to_line(w, a, b);
}

/// The size of what is drawn; lone points do not count.
double size_of(const Network& drawing) {
  Box box;
  for (const Strand& s : drawing.strands) {
    box.add(drawing.points[s.a]);
    box.add(drawing.points[s.b]);
  }
  return box.extent();
}

/// How far each end of a line may be from what it is welded to.
std::vector<double> limits(const Network& drawing, double tolerance) {
  std::vector<double> out(drawing.points.size(), tolerance);
  for (const Strand& s : drawing.strands) {
    const double most = kFeaturePart * length(drawing.points[s.b] - drawing.points[s.a]);
    out[s.a] = std::min(out[s.a], most);
    out[s.b] = std::min(out[s.b], most);
  }
  return out;
}

/// What must not be welded: corners of some polygons to edges and other corners of the same one.
class Kept {
 public:
  Kept(const Network& drawing, const std::vector<bool>& polygons) {
    if (std::find(polygons.begin(), polygons.end(), true) == polygons.end()) return;
    for (const Strand& s : drawing.strands) {
      const Origin origin = drawing.raws[s.raw].origin;
      if (origin.kind != Origin::Kind::ring || !polygons[origin.index]) continue;
      edges_.push_back({{std::min(s.a, s.b), std::max(s.a, s.b)}, origin.index});
      corners_.push_back({s.a, origin.index});
      corners_.push_back({s.b, origin.index});
    }
    std::sort(edges_.begin(), edges_.end());
    std::sort(corners_.begin(), corners_.end());
  }
  /// Whether a line between u and v must not be bent to w: it may be the copy of an edge that
  /// another polygon has.
  [[nodiscard]] bool forbids(std::uint32_t w, std::uint32_t u, std::uint32_t v) const {
    const IndexPair ends{std::min(u, v), std::max(u, v)};
    auto edge = std::lower_bound(edges_.begin(), edges_.end(), std::pair(ends, 0U));
    for (; edge != edges_.end() && edge->first == ends; ++edge) {
      if (has_corner(w, edge->second)) return true;
    }
    return false;
  }
  /// Whether two corners must not become one.
  [[nodiscard]] bool forbids(std::uint32_t u, std::uint32_t w) const {
    auto corner = std::lower_bound(corners_.begin(), corners_.end(), std::pair(u, 0U));
    for (; corner != corners_.end() && corner->first == u; ++corner) {
      if (has_corner(w, corner->second)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool has_corner(std::uint32_t v, std::uint32_t polygon) const {
    return std::binary_search(corners_.begin(), corners_.end(), std::pair(v, polygon));
  }

  std::vector<std::pair<IndexPair, std::uint32_t>> edges_;        ///< and their polygons, sorted
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners_;  ///< and their polygons, sorted
};

/// Looks for what nearly touches.
class Search {
 public:
  Search(const Network& drawing, const Network& noded, const EdgeGraph& graph,
         const std::vector<double>& limit, const Kept& kept)
      : drawing_(drawing), noded_(noded), graph_(graph), limit_(limit), kept_(kept) {
    for (const Strand& s : drawing.strands) {
      neighbours_.push_back({std::min(s.a, s.b), std::max(s.a, s.b)});
    }
    std::sort(neighbours_.begin(), neighbours_.end());
  }

  void run() {
    for (std::uint32_t t = 0; t < graph_.triangulation.triangles.size(); ++t) {
      for (const Corner i : kCorners) {
        const std::uint32_t w = graph_.triangulation.triangles[t].v[i];
        if (w < limit_.size()) look_from(w, t, i);
      }
    }
    make_unique(pairs);
    make_unique(lines);
  }

  std::vector<NearPair> pairs;
  std::vector<NearLine> lines;

 private:
  template <class T>
  static void make_unique(std::vector<T>& v) {
    sort_unique(v);
  }

  [[nodiscard]] Point at(std::uint32_t p) const { return noded_.points[p]; }

  /// Looks from w, corner i of triangle t, through the opposite edge and on.
  void look_from(std::uint32_t w, std::uint32_t t, Corner i) {
    const Triangle& f = graph_.triangulation.triangles[t];
    look_at_point(w, f.v[i.next()]);
    look_at_point(w, f.v[i.previous()]);
    stack_.assign(1, {t, i});
    for (int seen = 0; !stack_.empty() && seen < kMostTriangles; ++seen) {
      const auto [g, k] = stack_.back();
      stack_.pop_back();
      look_through(w, g, k);
    }
  }

  void look_through(std::uint32_t w, std::uint32_t t, Corner i) {
    const Triangle& f = graph_.triangulation.triangles[t];
    const std::uint32_t u = f.v[i.next()];
    const std::uint32_t v = f.v[i.previous()];
    if (u == w || v == w || !(distance_from_segment(at(u), at(v), at(w)) <= limit_[w])) return;
    if (f.is_locked(i)) return look_at_edge(w, u, v);
    const std::uint32_t next = f.n[i];
    if (next == kNone) return;
    const Corner back = graph_.triangulation.triangles[next].edge_to(t);
    look_at_point(w, graph_.triangulation.triangles[next].v[back]);
    stack_.push_back({next, back.next()});
    stack_.push_back({next, back.previous()});
  }

  void look_at_point(std::uint32_t w, std::uint32_t u) {
    if (u >= limit_.size() || u == w) return;
    const double distance = length(at(u) - at(w));
    if (!(distance <= std::min(limit_[u], limit_[w]))) return;
    const IndexPair pair{std::min(u, w), std::max(u, w)};
    if (std::binary_search(neighbours_.begin(), neighbours_.end(), pair)) return;
    if (kept_.forbids(u, w)) return;
    pairs.push_back({distance, pair[0], pair[1]});
  }

  void look_at_edge(std::uint32_t w, std::uint32_t u, std::uint32_t v) {
    const IndexPair edge{std::min(u, v), std::max(u, v)};
    const auto found = std::lower_bound(graph_.edges.begin(), graph_.edges.end(), edge);
    const auto k = static_cast<std::size_t>(found - graph_.edges.begin());
    for (const Strand& s : graph_.strands(noded_, k)) {
      const Raw& raw = drawing_.raws[s.raw];
      const double whole = length(raw.b - raw.a);
      const double limit = std::min(limit_[w], kFeaturePart * whole);
      const double distance = distance_from_segment(raw.a, raw.b, at(w));
      const double place = part_on_line(raw.a, raw.b, at(w));
      const bool is_inside = place * whole > limit && (1 - place) * whole > limit;
      const Strand& line = drawing_.strands[s.raw];
      if (!is_inside) {
        // The end itself may be out of sight: behind the line, where lines cross beside their ends.
        look_at_point(w, place < 0.5 ? line.a : line.b);
      } else if (distance <= limit && !kept_.forbids(w, line.a, line.b)) {
        lines.push_back({s.raw, place, w, distance});
      }
    }
  }

  const Network& drawing_;
  const Network& noded_;
  const EdgeGraph& graph_;
  const std::vector<double>& limit_;
  const Kept& kept_;
  std::vector<IndexPair> neighbours_;  ///< pairs of ends with a line between them
  std::vector<std::pair<std::uint32_t, Corner>> stack_;
};

/// Makes the welds of one round in the drawing.
class Welder {
 public:
  Welder(const Input& input, Network& drawing, std::vector<double> limit,
         std::vector<Change>& changes)
      : input_(input), drawing_(drawing), limit_(std::move(limit)), changes_(changes) {
    target_.resize(drawing.points.size());
    std::iota(target_.begin(), target_.end(), 0U);
    moved_.assign(target_.size(), false);
  }

  /// True if anything was welded.
  bool weld(const std::vector<NearPair>& pairs, const std::vector<NearLine>& lines) {
    for (const NearPair& pair : pairs) unite(pair);
    bends_.resize(drawing_.raws.size());
    for (const NearLine& line : lines) bend(line);
    if (changed_) rebuild();
    return changed_;
  }

 private:
  std::uint32_t target(std::uint32_t v) {
    while (target_[v] != v) v = target_[v] = target_[target_[v]];
    return v;
  }

  [[nodiscard]] std::string name(std::uint32_t v) const {
    const std::uint32_t k = drawing_.input[v];
    const std::string at = describe(drawing_.points[v]);
    if (k == kNone) return "the corner at " + at;
    return fmt::format("point {} at {}", id(k), at);
  }
  [[nodiscard]] long id(std::uint32_t k) const {
    return input_.point_ids.empty() ? static_cast<long>(k) : input_.point_ids[k];
  }
  [[nodiscard]] std::vector<InputRef> refs(std::uint32_t v) const {
    if (drawing_.input[v] == kNone) return {};
    return {{InputKind::point, id(drawing_.input[v])}};
  }

  void unite(const NearPair& pair) {
    std::uint32_t u = target(pair.u), w = target(pair.w);
    if (u == w) return;
    // The smaller one in the order of coordinates stays, whatever the order of the input.
    if (drawing_.points[w] < drawing_.points[u]) std::swap(u, w);
    const double distance = length(drawing_.points[w] - drawing_.points[u]);
    limit_[u] = std::min(limit_[u], limit_[w]);
    if (distance > limit_[u]) return;
    target_[w] = u;
    moved_[u] = moved_[w] = changed_ = true;
    changes_.push_back(
        {Change::Kind::welded,
         fmt::format("{} was moved by {} onto {}", name(w), describe_roughly(distance), name(u)),
         {drawing_.points[w], drawing_.points[u]},
         refs(w)});
  }

  /// Lines at ends that were moved in this round wait for the next one; so do ends that are near to
  /// the one before, with which they may become one then.
  void bend(const NearLine& line) {
    const Strand& strand = drawing_.strands[line.raw];
    if (moved_[line.w] || moved_[strand.a] || moved_[strand.b]) return;
    std::vector<std::uint32_t>& bends = bends_[line.raw];
    if (!bends.empty() &&
        length(drawing_.points[line.w] - drawing_.points[bends.back()]) <= limit_[line.w]) {
      return;
    }
    bends.push_back(line.w);
    changed_ = true;
    changes_.push_back(
        {Change::Kind::welded,
         fmt::format(
             "{} was bent by {} to {}", name_of_raw(input_, drawing_, line.raw),
             line.distance > 0 ? describe_roughly(line.distance) : "less than rounding tells",
             name(line.w)),
         {drawing_.points[line.w]},
         {ref_of(input_, drawing_.raws[line.raw].origin)}});
  }

  void rebuild() {
    Network out;
    out.points = drawing_.points;
    out.input = drawing_.input;
    out.lone = drawing_.lone;
    out.named = drawing_.named;
    for (auto* kept : {&out.lone, &out.named})
      for (std::uint32_t& v : *kept) v = target(v);
    for (const Strand& s : drawing_.strands) {
      std::uint32_t from = target(s.a);
      bends_[s.raw].push_back(s.b);
      for (const std::uint32_t v : bends_[s.raw]) {
        const std::uint32_t to = target(v);
        if (from == to) continue;
        out.strands.push_back({from, to, static_cast<std::uint32_t>(out.raws.size())});
        out.raws.push_back({out.points[from], out.points[to], drawing_.raws[s.raw].origin});
        from = to;
      }
    }
    for (std::uint32_t v = 0; v < target_.size(); ++v) {
      std::uint32_t& kept = out.input[target(v)];
      if (kept == kNone) kept = out.input[v];
    }
    compact(out);
    drawing_ = std::move(out);
  }

  const Input& input_;
  Network& drawing_;
  std::vector<double> limit_;
  std::vector<Change>& changes_;
  std::vector<std::uint32_t> target_;              ///< where each end goes, as a forest
  std::vector<bool> moved_;                        ///< took part in a weld of two ends
  std::vector<std::vector<std::uint32_t>> bends_;  ///< by raw line: ends it is bent to, in order
  bool changed_ = false;
};

/// Unites ends that are near, whatever lies between them: where lines are in the way that cannot be
/// told apart. False if there are none.
bool weld_ends_alone(const Input& input, double tolerance, const Kept& kept, Network& network,
                     std::vector<Change>& changes) {
  EdgeGraph graph;
  graph.triangulation = triangulate_hull(network.points, {}).triangulation;
  const std::vector<double> limit = limits(network, tolerance);
  const Network ends = network;
  Search search(ends, ends, graph, limit, kept);
  search.run();
  return Welder(input, network, limit, changes).weld(search.pairs, {});
}

/// Shrinks lines to points that are no longer than rounding: somebody computed their ends twice.
void shrink_to_points(const Input& input, double tolerance, const Kept& kept, Network& network,
                      std::vector<Change>& changes) {
  const double most = std::min(tolerance, rounding_of(network.points));
  std::vector<NearPair> pairs;
  for (const Strand& s : network.strands) {
    const double distance = length(network.points[s.b] - network.points[s.a]);
    if (distance <= most && !kept.forbids(s.a, s.b))
      pairs.push_back({distance, std::min(s.a, s.b), std::max(s.a, s.b)});
  }
  std::sort(pairs.begin(), pairs.end());
  Welder(input, network, std::vector<double>(network.points.size(), most), changes).weld(pairs, {});
}

EdgeGraph weld_once(const Input& input, double tolerance, Network& network,
                    std::vector<Change>& changes, const std::vector<bool>& kept_polygons) {
  shrink_to_points(input, tolerance, Kept(network, kept_polygons), network, changes);
  for (int round = 0;; ++round) {
    Network noded = network;
    const Kept kept(network, kept_polygons);
    EdgeGraph graph;
    try {
      graph = node_edges(noded);
    } catch (const RoundingCascade&) {
      if (round >= kMostRounds || !weld_ends_alone(input, tolerance, kept, network, changes)) throw;
      continue;
    }
    const std::vector<double> limit = limits(network, tolerance);
    Search search(network, noded, graph, limit, kept);
    if (round < kMostRounds) search.run();
    if (!Welder(input, network, limit, changes).weld(search.pairs, search.lines)) {
      network = std::move(noded);
      return graph;
    }
  }
}

/// By polygon: whether it is drawn wider than rounding.
std::vector<bool> wide_polygons(const Input& input, const Network& drawing) {
  std::vector<double> area(input.polygons.size(), 0), around(area);
  const Point origin = drawing.points.front();
  for (const Strand& s : drawing.strands) {
    const Origin from = drawing.raws[s.raw].origin;
    if (from.kind != Origin::Kind::ring) continue;
    const Point a = drawing.points[s.a], b = drawing.points[s.b];
    area[from.index] += doubled_area(origin, a, b);
    around[from.index] += length(b - a);
  }
  const double rounding = rounding_of(drawing.points);
  std::vector<bool> out;
  for (std::size_t p = 0; p < area.size(); ++p)
    out.push_back(std::abs(area[p]) > rounding * around[p]);
  return out;
}

/// By polygon: whether an edge has it on one side alone.
std::vector<bool> polygons_with_inside(const Input& input, const Network& noded,
                                       const EdgeGraph& graph) {
  std::vector<bool> out(input.polygons.size(), false);
  std::vector<std::uint32_t> buffer;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    each_polygon_on(graph, noded, e, buffer, [&](std::uint32_t polygon, std::ptrdiff_t times) {
      if (times % 2 != 0) out[polygon] = true;
    });
  }
  return out;
}

}  // namespace

EdgeGraph weld_and_node(const Input& input, double relative, Network& network,
                        std::vector<Change>& changes, bool keep_polygons) {
  if (relative <= 0 || network.strands.empty()) return node_edges(network);
  const double tolerance = relative * size_of(network);
  const std::vector<bool> wide = wide_polygons(input, network);
  const Network drawing = keep_polygons ? network : Network{};
  const std::size_t known = changes.size();
  std::vector<bool> kept(input.polygons.size(), false);
  for (;;) {  // each time with more polygons kept
    EdgeGraph graph = weld_once(input, tolerance, network, changes, kept);
    if (!keep_polygons || changes.size() == known) return graph;
    const std::vector<bool> has_inside = polygons_with_inside(input, network, graph);
    bool any_vanished = false;
    for (std::size_t p = 0; p < kept.size(); ++p) {
      if (has_inside[p] || !wide[p] || kept[p]) continue;
      kept[p] = any_vanished = true;
    }
    if (!any_vanished) return graph;
    network = drawing;
    changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(known), changes.end());
  }
}

}  // namespace cover
