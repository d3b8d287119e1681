// A pass first asks for the constrained Delaunay triangulation, which is fast and exact and exists
// only if the edges are clean; only if they are not, the exact sweep cuts them.
//
// This ends. A common point x of edges is moved by rounding to r, and no end of an edge through x
// is nearer to x than r is: r is the double nearest to x, or the nearest of these ends. So an edge
// ab that is cut at x becomes shorter pieces: |ar| <= |ax| + |xr| <= |ax| + |xb| = |ab|, with
// equality only if r is b and the edge stays as it is; for a piece between two cuts the same holds.
// At least one edge through x is cut, because r is an end of all of them only where they meet there
// anyway. Replacing lengths by finitely many smaller ones, out of the finitely many that doubles
// inside of the drawing's box can have, comes to an end. Tested by
// tests/unit/region/node_edges_test.cpp.
#include "region/node_edges.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geom/exact_subdivision.hpp"

namespace cover {
namespace {

IndexPair ends(const Strand& s) { return {std::min(s.a, s.b), std::max(s.a, s.b)}; }

/// Sorts the strands by edge and lists the edges.
void index_edges(Network& network, EdgeGraph& graph) {
  std::sort(network.strands.begin(), network.strands.end(), [](const Strand& x, const Strand& y) {
    return std::tuple(ends(x), x.raw, x.a) < std::tuple(ends(y), y.raw, y.a);
  });
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

/// Replaces the strands by their pieces between common points.
void cut(Network& network, const EdgeGraph& graph) {
  std::vector<PlainSegment> segments;
  segments.reserve(graph.edges.size());
  for (const auto& [a, b] : graph.edges) segments.push_back({network.points[a], network.points[b]});
  const Subdivision cuts = subdivide(segments);
  if (cuts.path.size() == 2 * segments.size()) {
    throw std::logic_error("node_edges: edges in conflict that do not meet");
  }

  PointPool pool;
  for (const Point& p : network.points) pool.index_of(p);
  std::vector<std::uint32_t> index;  // of the point of each node
  for (const Point& p : cuts.nodes) index.push_back(pool.index_of(p));
  std::vector<Strand> strands;
  strands.reserve(cuts.path.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto path = cuts.path_of(k);
    for (const Strand& s : graph.strands(network, k)) {
      const bool rightwards = network.points[s.a] < network.points[s.b];
      for (std::size_t i = 1; i < path.size(); ++i) {
        const std::uint32_t left = index[path[i - 1]], right = index[path[i]];
        if (left == right) continue;  // rounded away
        strands.push_back({rightwards ? left : right, rightwards ? right : left, s.raw});
      }
    }
  }
  network.strands = std::move(strands);
  network.points = pool.take();
  network.input.resize(network.points.size(), kNoIndex);
  compact(network);
}

}  // namespace

EdgeGraph node_edges(Network& network) {
  EdgeGraph graph;
  for (;; ++graph.passes) {
    index_edges(network, graph);
    CdtResult cdt = triangulate_hull(network.points, graph.edges);
    if (cdt.conflicts.empty()) {
      graph.triangulation = std::move(cdt.triangulation);
      return graph;
    }
    cut(network, graph);
  }
}

void compact(Network& network) {
  std::vector<std::uint32_t> renumbered(network.points.size(), kNoIndex);
  for (const Strand& s : network.strands) renumbered[s.a] = renumbered[s.b] = 0;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == kNoIndex) continue;
    renumbered[v] = count;
    network.points[count] = network.points[v];
    network.input[count++] = network.input[v];
  }
  network.points.resize(count);
  network.input.resize(count);
  for (Strand& s : network.strands) s = {renumbered[s.a], renumbered[s.b], s.raw};
}

}  // namespace cover
