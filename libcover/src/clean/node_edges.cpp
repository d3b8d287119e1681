// A pass first asks for the constrained Delaunay triangulation, which is fast and exact and exists
// only if the edges are clean; only if they are not, the exact sweep cuts them.
//
// This ends. A common point x of edges is moved by rounding to r, and no end of an edge through x
// is nearer to x than r is: r is the double nearest to x, or the nearest of these ends. So an edge
// ab that is cut at x becomes shorter pieces: |ar| <= |ax| + |xr| <= |ax| + |xb| = |ab|, with
// equality only if r is b and the edge stays as it is; for a piece between two cuts the same holds,
// in whatever order they come.
// At least one edge through x is cut, because r is an end of all of them only where they meet there
// anyway. Replacing lengths by finitely many smaller ones, out of the finitely many that doubles
// inside of the drawing's box can have, comes to an end. A lone point is an end like any other: of
// a segment of length zero. An edge that is led through a point r beside it, at x, becomes shorter
// in the same way, because r is nearer to x than its ends are. A crossing that is left out has the
// same two neighbours on all its edges, which are one edge then; two that crossed there were not
// the same before, so one of them was cut at a neighbour.
// Tested by tests/unit/clean/node_edges_test.cpp.
#include "clean/node_edges.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/faults/machine_memory.hpp"
#include "geom/subdivision/crossings_at_least.hpp"
#include "geom/subdivision/exact_subdivision.hpp"

namespace cover {
namespace {

/// Strands after further passes, for each one after the first; and so many in any case.
constexpr std::size_t kMostPieces = 8;
constexpr std::size_t kFewPieces = 100'000;
/// Strands of all further passes together, likewise: beside 0 a pass may make one crossing more for
/// each one before, some thousand times.
constexpr std::size_t kMostOfAll = 32;
constexpr std::size_t kFewOfAll = 200'000;

/// A few bytes of a layout put a cell over itself ten thousand times.
void check_crossings(const Network& network) {
  const double memory = machine_memory(), all = static_cast<double>(network.strands.size());
  if (all * all / 2 * kBytesPerCrossing <= memory) return;
  std::vector<PlainSegment> segments;
  segments.reserve(network.strands.size());
  for (const Strand& s : network.strands)
    segments.push_back({network.points[s.a], network.points[s.b]});
  const double crossings = crossings_at_least(segments);
  if (crossings * kBytesPerCrossing > memory) throw TooManyCrossings(crossings);
}

IndexPair ends(const Strand& s) { return {std::min(s.a, s.b), std::max(s.a, s.b)}; }

/// Sorts the strands by edge and lists the edges. What a pass did not cut comes first and is
/// sorted.
void index_edges(Network& network, EdgeGraph& graph) {
  const auto is_before = [](const Strand& x, const Strand& y) {
    return std::tuple(ends(x), x.raw, x.a) < std::tuple(ends(y), y.raw, y.a);
  };
  std::vector<Strand>& strands = network.strands;
  const auto rest = std::is_sorted_until(strands.begin(), strands.end(), is_before);
  std::sort(rest, strands.end(), is_before);
  std::inplace_merge(strands.begin(), rest, strands.end(), is_before);
  graph.edges.clear();
  graph.first.clear();
  for (std::size_t k = 0; k < network.strands.size(); ++k) {
    const IndexPair pair = ends(network.strands[k]);
    if (!graph.edges.empty() && graph.edges.back() == pair) continue;
    graph.edges.push_back(pair);
    graph.first.push_back(k);
  }
  graph.first.push_back(network.strands.size());
}

/// By point: whether it is one of the `old` ones, or some line turns off there. Where lines lie
/// next to each other, most of their crossings have only the same two neighbours on all of them:
/// these points are not needed.
std::vector<bool> needed_points(const Subdivision& cuts, const std::vector<std::uint32_t>& index,
                                std::size_t lines, std::size_t old, std::size_t count) {
  std::vector<std::array<std::uint32_t, 2>> neighbours(count, {kNone, kNone});
  std::vector<bool> needed(count, false);
  std::fill_n(needed.begin(), old, true);
  const auto add = [&](std::uint32_t v, std::uint32_t w) {
    auto& [first, second] = neighbours[v];
    if (first == w || second == w) return;
    if (second != kNone) needed[v] = true;
    (first == kNone ? first : second) = w;
  };
  for (std::size_t k = 0; k < lines; ++k) {
    const auto path = cuts.path_of(k);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const std::uint32_t v = index[path[i - 1]], w = index[path[i]];
      if (v == w) continue;
      add(v, w);
      add(w, v);
    }
  }
  return needed;
}

/// Replaces the strands by their pieces between common points. False if there are none.
bool cut(Network& network, const EdgeGraph& graph) {
  std::vector<PlainSegment> segments;
  segments.reserve(graph.edges.size() + network.lone.size());
  for (const auto& [a, b] : graph.edges) segments.push_back({network.points[a], network.points[b]});
  for (const std::uint32_t v : network.lone) {
    segments.push_back({network.points[v], network.points[v]});
  }
  const Subdivision cuts = subdivide_and_snap(segments, graph.passes > 0);
  if (cuts.crowd) throw RoundingCascade(*cuts.crowd, true);
  if (cuts.path.size() == 2 * segments.size()) return false;

  PointPool pool;
  for (const Point& p : network.points) pool.index_of(p);
  std::vector<std::uint32_t> index;  // of the point of each node
  for (const Point& p : cuts.nodes) index.push_back(pool.index_of(p));
  const std::vector<bool> needed =
      needed_points(cuts, index, graph.edges.size(), network.points.size(), pool.points().size());
  std::vector<Strand> strands, pieces;
  strands.reserve(network.strands.size());
  std::vector<std::uint32_t> path;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    path.clear();
    for (const std::uint32_t node : cuts.path_of(k)) {
      const std::uint32_t v = index[node];
      if (needed[v] && (path.empty() || path.back() != v)) path.push_back(v);  // or rounded away
    }
    const auto whole = graph.strands(network, k);
    if (path.size() == 2 && cuts.path_of(k).size() == 2) {
      strands.insert(strands.end(), whole.begin(), whole.end());
      continue;
    }
    for (const Strand& s : whole) {
      const bool rightwards = network.points[s.a] < network.points[s.b];
      for (std::size_t i = 1; i < path.size(); ++i) {
        const std::uint32_t left = path[i - 1], right = path[i];
        pieces.push_back({rightwards ? left : right, rightwards ? right : left, s.raw});
      }
    }
  }
  strands.insert(strands.end(), pieces.begin(), pieces.end());
  network.strands = std::move(strands);
  network.points = pool.take();
  network.input.resize(network.points.size(), kNone);
  compact(network);
  return true;
}

}  // namespace

EdgeGraph index_edges(Network& network) {
  EdgeGraph graph;
  index_edges(network, graph);
  return graph;
}

EdgeGraph node_edges(Network& network, bool may_be_clean, const Team& team) {
  check_crossings(network);
  EdgeGraph graph;
  std::size_t most = network.strands.max_size(), most_of_all = most, of_all = 0;
  for (;; ++graph.passes) {
    const std::size_t strands = network.strands.size();
    if (graph.passes == 1) {
      most = kMostPieces * strands + kFewPieces;
      most_of_all = kMostOfAll * strands + kFewOfAll;
    }
    if (graph.passes > 0) of_all += strands;
    if (strands > most || of_all > most_of_all) throw RoundingCascade(network.points.back());
    index_edges(network, graph);
    if (may_be_clean) {
      CdtResult cdt = triangulate_hull(network.points, graph.edges, team);
      if (cdt.conflicts.empty()) {
        graph.triangulation = std::move(cdt.triangulation);
        return graph;
      }
    }
    if (!cut(network, graph) && may_be_clean) {
      throw std::logic_error("node_edges: edges in conflict that do not meet");
    }
    may_be_clean = true;
  }
}

void compact(Network& network) {
  std::vector<std::uint32_t> renumbered(network.points.size(), kNone);
  for (const Strand& s : network.strands) renumbered[s.a] = renumbered[s.b] = 0;
  for (const auto* kept : {&network.lone, &network.named})
    for (const std::uint32_t v : *kept) renumbered[v] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == kNone) continue;
    renumbered[v] = count;
    network.points[count] = network.points[v];
    network.input[count++] = network.input[v];
  }
  network.points.resize(count);
  network.input.resize(count);
  for (Strand& s : network.strands) s = {renumbered[s.a], renumbered[s.b], s.raw};
  for (auto* kept : {&network.lone, &network.named})
    for (std::uint32_t& v : *kept) v = renumbered[v];
}

}  // namespace cover
