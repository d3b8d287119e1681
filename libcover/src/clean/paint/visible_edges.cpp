// Tested by tests/unit/clean/paint/paint_test.cpp.
#include "clean/paint/visible_edges.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace cover {
namespace {

bool is_forced(const Network& network, std::uint32_t raw) {
  return network.raws[raw].origin.kind != Origin::Kind::ring;
}

/// Unites edges at points that only hidden edges needed.
class Uniter {
 public:
  Uniter(const Network& network, std::vector<VisibleEdge>& edges)
      : network_(network),
        edges_(edges),
        at_(network.points.size(), {kNone, kNone}),
        degree_(network.points.size(), 0) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      for (const std::uint32_t v : {edges[e].a, edges[e].b}) {
        if (degree_[v] < 2) at_[v][degree_[v]] = e;
        ++degree_[v];
      }
    }
  }

  /// True if any were united.
  bool run() {
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (degree_[v] == 2 && network_.input[v] == kNone) unite_at(v);
    }
    return std::erase_if(edges_, [](const VisibleEdge& e) { return e.raws.empty(); }) > 0;
  }

 private:
  /// Turns edge e so that it ends at v.
  static void turn_to(VisibleEdge& e, std::uint32_t v) {
    if (e.b == v) return;
    std::swap(e.a, e.b);
    std::swap(e.owners[0], e.owners[1]);
  }

  [[nodiscard]] bool has_end_at(const VisibleEdge& e, Point p) const {
    return std::any_of(e.raws.begin(), e.raws.end(), [&](std::uint32_t r) {
      return network_.raws[r].a == p || network_.raws[r].b == p;
    });
  }

  void unite_at(std::uint32_t v) {
    const std::uint32_t kept = at_[v][0], gone = at_[v][1];
    VisibleEdge &e = edges_[kept], &f = edges_[gone];
    turn_to(e, v);
    turn_to(f, v);
    std::swap(f.a, f.b);
    std::swap(f.owners[0], f.owners[1]);
    const Point p = network_.points[v];
    if (e.owners != f.owners || e.a == f.b || has_end_at(e, p) || has_end_at(f, p)) return;
    std::vector<std::uint32_t> common;
    std::set_intersection(e.raws.begin(), e.raws.end(), f.raws.begin(), f.raws.end(),
                          std::back_inserter(common));
    if (common.empty()) return;
    e.b = f.b;
    e.raws = std::move(common);
    f.raws.clear();
    for (std::uint32_t& slot : at_[e.b]) {
      if (slot == gone) slot = kept;
    }
  }

  const Network& network_;
  std::vector<VisibleEdge>& edges_;
  std::vector<std::array<std::uint32_t, 2>> at_;  ///< the first two edges at each point
  std::vector<std::uint32_t> degree_;
};

}  // namespace

VisibleEdges visible_edges(const Network& network, const EdgeGraph& graph,
                           const Painting& painting) {
  VisibleEdges out;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [left, right] = painting.owners[e];
    VisibleEdge edge{graph.edges[e][0], graph.edges[e][1], painting.regions[e], {}};
    bool visible = edge.owners[0] != edge.owners[1];
    for (const Strand& s : graph.strands(network, e)) {
      const bool forced = is_forced(network, s.raw);
      const std::uint32_t polygon = network.raws[s.raw].origin.index;
      visible |= forced;
      if (!forced && polygon != left && polygon != right) continue;
      if (edge.raws.empty() || edge.raws.back() != s.raw) edge.raws.push_back(s.raw);
    }
    if (visible) out.edges.push_back(std::move(edge));
  }
  out.any_united = Uniter(network, out.edges).run();
  return out;
}

Network network_of(const std::vector<VisibleEdge>& edges, const Network& network) {
  Network out;
  out.points = network.points;
  out.input = network.input;
  out.lone = network.lone;
  out.named = network.named;
  const auto add = [&](const VisibleEdge& e, bool forwards, Raw raw) {
    out.strands.push_back(
        {forwards ? e.a : e.b, forwards ? e.b : e.a, static_cast<std::uint32_t>(out.raws.size())});
    out.raws.push_back(raw);
  };
  for (const VisibleEdge& e : edges) {
    const Point a = network.points[e.a], b = network.points[e.b];
    for (const std::uint32_t owner : e.owners) {
      if (owner != kNone && e.owners[0] != e.owners[1]) {
        add(e, true, {a, b, {Origin::Kind::ring, owner}});
      }
    }
    for (const std::uint32_t r : e.raws) {
      const Raw& raw = network.raws[r];
      if (!is_forced(network, r)) continue;
      const bool forwards = (raw.a < raw.b) == (a < b);
      add(e, forwards, {forwards ? a : b, forwards ? b : a, raw.origin});
    }
  }
  compact(out);
  return out;
}

}  // namespace cover
