// A pass first asks for the constrained Delaunay triangulation, which is fast and exact and exists
// only if the edges are clean; only if they are not, the exact sweep cuts them.
// Tested by tests/unit/region/node_edges_test.cpp.
#include "region/node_edges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
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

/// Whether two points are at most two units in the last place of their coordinates apart.
bool is_next_to(Point p, Point q) {
  const double size =
      std::max(std::max(std::abs(p.x), std::abs(p.y)), std::max(std::abs(q.x), std::abs(q.y)));
  const double reach = 2 * (std::nextafter(size, HUGE_VAL) - size);
  return std::abs(p.x - q.x) <= reach && std::abs(p.y - q.y) <= reach;
}

/// Takes crossings that are next to an end of a line that crosses there for that end: between the
/// two no double would be left, so that a face there could not even be pointed at.
class EndSnapper {
 public:
  EndSnapper(std::span<const PlainSegment> segments, std::span<const SubSegment> pieces) {
    for (const SubSegment& piece : pieces) {
      for (const std::uint32_t parent : piece.parents) {
        look(piece.left, segments[parent]);
        look(piece.right, segments[parent]);
      }
    }
  }
  [[nodiscard]] Point snapped(Point p) const {
    const auto end = end_.find(p);
    return end == end_.end() ? p : end->second;
  }

 private:
  void look(Point p, const PlainSegment& s) {
    if (p == s.a || p == s.b) return;
    for (const Point end : {s.a, s.b}) {
      if (!is_next_to(p, end)) continue;
      const auto [entry, is_new] = end_.emplace(p, end);
      if (!is_new) entry->second = std::min(entry->second, end);
    }
  }
  std::map<Point, Point> end_;
};

/// Replaces the strands by their pieces between common points.
void cut(Network& network, const EdgeGraph& graph) {
  std::vector<PlainSegment> segments;
  segments.reserve(graph.edges.size());
  for (const auto& [a, b] : graph.edges) segments.push_back({network.points[a], network.points[b]});
  const std::vector<SubSegment> pieces = subdivide(segments);
  EndSnapper ends_near(segments, pieces);

  PointPool pool;
  for (const Point& p : network.points) pool.index_of(p);
  const std::size_t given = pool.points().size();
  // Given points stay where they are, also those on a line next to its end.
  const auto index_of = [&](Point p) {
    const std::uint32_t index = pool.index_of(p);
    return index < given ? index : pool.index_of(ends_near.snapped(p));
  };
  std::vector<Strand> strands;
  strands.reserve(pieces.size());
  for (const SubSegment& piece : pieces) {
    const std::uint32_t left = index_of(piece.left), right = index_of(piece.right);
    if (left == right) continue;  // rounded away
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
  compact(network);
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
