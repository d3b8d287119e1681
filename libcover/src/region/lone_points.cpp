// Tested by tests/unit/region/node_edges_test.cpp.
#include "region/lone_points.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "cdt/locate.hpp"

namespace cover {
namespace {

/// A lone point on an edge of the graph.
struct Hit {
  std::size_t edge;
  Point at;
  std::uint32_t input;
};

std::vector<Hit> find_hits(const Network& network, const EdgeGraph& graph) {
  std::vector<Hit> hits;
  Locator locator(graph.triangulation);
  for (const LonePoint& p : network.lone_points) {
    const Location at = locator.locate(p.at);
    if (at.kind != Location::Kind::on_edge) continue;
    const Triangle& f = graph.triangulation.triangles[at.triangle];
    if (!f.is_locked(at.index)) continue;
    const std::uint32_t u = f.v[static_cast<std::size_t>(next3(at.index))];
    const std::uint32_t v = f.v[static_cast<std::size_t>(prev3(at.index))];
    const IndexPair edge{std::min(u, v), std::max(u, v)};
    const auto found = std::lower_bound(graph.edges.begin(), graph.edges.end(), edge);
    hits.push_back({static_cast<std::size_t>(found - graph.edges.begin()), p.at, p.input});
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& x, const Hit& y) {
    return std::pair(x.edge, x.at) < std::pair(y.edge, y.at);
  });
  return hits;
}

}  // namespace

bool cut_at_lone_points(Network& network, const EdgeGraph& graph) {
  if (network.lone_points.empty() || network.strands.empty()) return false;
  const std::vector<Hit> hits = find_hits(network, graph);
  std::vector<Strand> strands;
  auto hit = hits.begin();
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    std::vector<std::uint32_t> inner;  // in the order of coordinates
    for (; hit != hits.end() && hit->edge == e; ++hit) {
      inner.push_back(static_cast<std::uint32_t>(network.points.size()));
      network.points.push_back(hit->at);
      network.input.push_back(hit->input);
    }
    for (Strand s : graph.strands(network, e)) {
      const bool rightwards = network.points[s.a] < network.points[s.b];
      std::uint32_t from = s.a;
      for (std::size_t k = 0; k < inner.size(); ++k) {
        const std::uint32_t to = inner[rightwards ? k : inner.size() - 1 - k];
        strands.push_back({from, to, s.raw});
        from = to;
      }
      strands.push_back({from, s.b, s.raw});
    }
  }
  if (!hits.empty()) network.strands = std::move(strands);
  return !hits.empty();
}

}  // namespace cover
