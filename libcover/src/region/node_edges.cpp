// A pass first asks for the constrained Delaunay triangulation, which is fast and exact and exists
// only if the edges are clean; only if they are not, the exact sweep cuts them.
// Tested by tests/unit/region/node_edges_test.cpp.
#include "region/node_edges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "geom/exact_subdivision.hpp"

namespace cover {
namespace {

/// In practice two or three passes do; see the long run of the soup tests.
constexpr int kMostPasses = 40;

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
  const std::vector<SubSegment> pieces = subdivide(segments);

  PointPool pool;
  for (const Point& p : network.points) pool.index_of(p);
  std::vector<Strand> strands;
  strands.reserve(pieces.size());
  for (const SubSegment& piece : pieces) {
    if (piece.left == piece.right) continue;  // rounded away
    const std::uint32_t left = pool.index_of(piece.left), right = pool.index_of(piece.right);
    for (const std::uint32_t parent : piece.parents) {
      for (const Strand& s : graph.strands(network, parent)) {
        const bool rightwards = network.points[s.a] < network.points[s.b];
        strands.push_back({rightwards ? left : right, rightwards ? right : left, s.raw});
      }
    }
  }
  network.strands = std::move(strands);
  network.points = pool.take();
  network.input.resize(network.points.size(), kNoIndex);
}

}  // namespace

Result<EdgeGraph> node_edges(Network& network) {
  EdgeGraph graph;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    index_edges(network, graph);
    CdtResult cdt = triangulate_hull(network.points, graph.edges);
    if (cdt.conflicts.empty()) {
      graph.triangulation = std::move(cdt.triangulation);
      return graph;
    }
    cut(network, graph);
  }
  return Error{
      ErrorCode::internal,
      fmt::format("crossing segments do not settle in {} passes of snap rounding", kMostPasses),
      {},
      {}};
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
