// Tested by tests/unit/clean/soup_test.cpp.
#include "clean/paint/assemble.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

#include <cover/text.hpp>

#include "base/containers/order.hpp"
#include "base/faults/complaint.hpp"

namespace cover {
namespace {

/// Fills a Pslg step by step.
class Assembler {
 public:
  Assembler(const Input& input, const Network& network, const EdgeGraph& graph,
            const std::vector<EdgeOwners>& owners, std::vector<Note>& notes)
      : input_(input), network_(network), graph_(graph), owners_(owners), notes_(notes) {}

  Pslg assemble() {
    pslg_.source = input_.source;
    add_points();
    add_segments();
    warn_of_lost_names();
    if (owners_.empty()) {
      pslg_.seeds = input_.seeds;
      pslg_.holes = input_.holes;
      pslg_.void_rule = input_.void_rule;
      pslg_.seeds_may_miss = input_.seeds_may_miss;
    } else {
      add_polygon_seeds();
    }
    return std::move(pslg_);
  }

 private:
  /// Points of the input in their order; kNone comes last.
  void add_points() {
    const std::vector<std::uint32_t> order = sorted_numbers(
        network_.points.size(),
        [this](std::uint32_t v, std::uint32_t w) { return network_.input[v] < network_.input[w]; });
    vertex_.resize(order.size());
    for (const std::uint32_t v : order) {
      vertex_[v] = VertexId{pslg_.points.size()};
      const std::uint32_t k = network_.input[v];
      const bool known = k != kNone;
      pslg_.points.push_back(network_.points[v]);
      pslg_.point_ids.push_back(known ? point_id(input_, k) : -1);
      pslg_.point_markers.push_back(known && !input_.point_markers.empty() ? input_.point_markers[k]
                                                                           : 0);
    }
    for (std::size_t k = 0; k < network_.named.size(); ++k)
      pslg_.named_points.push_back({vertex_[network_.named[k]], input_.point_names[k].name});
  }

  /// The edges in the order of the lines that they belong to.
  [[nodiscard]] std::vector<std::size_t> edge_order() const {
    const auto line = [this](std::size_t e) {
      return network_.raws[graph_.strands(network_, e).front().raw].origin;
    };
    return sorted_numbers<std::size_t>(
        graph_.edges.size(), [&](std::size_t e, std::size_t f) { return line(e) < line(f); });
  }

  void add_segments() {
    for (const std::size_t e : edge_order()) {
      auto [a, b] = graph_.edges[e];
      Segment segment;
      bool directed = false;
      for (const Strand& s : graph_.strands(network_, e)) {
        const Origin origin = network_.raws[s.raw].origin;
        if (origin.kind == Origin::Kind::ring) continue;
        if (!std::exchange(directed, true)) std::tie(a, b) = std::pair(s.a, s.b);
        if (origin.kind == Origin::Kind::segment) take_over(input_.segments[origin.index], segment);
      }
      name_segment(e, segment);
      segment.a = vertex_[a];
      segment.b = vertex_[b];
      pslg_.segments.push_back(segment);
      if (owners_.empty()) continue;
      const bool turned = a != graph_.edges[e][0];
      pslg_.side_seeds.push_back(
          {seed_of(owners_[e][turned ? 1 : 0]), seed_of(owners_[e][turned ? 0 : 1])});
    }
  }

  static void take_over(const InputSegment& from, Segment& segment) {
    if (segment.id < 0) segment.id = from.id;
    if (segment.marker == 0) segment.marker = from.marker;
  }

  /// Lines come before segments: a line is laid over a drawing to name what is there, and segments
  /// often have the name of their layer only.
  void name_segment(std::size_t e, Segment& segment) {
    for (const Origin::Kind kind : {Origin::Kind::line, Origin::Kind::segment}) {
      for (const Strand& s : graph_.strands(network_, e)) {
        const Origin origin = network_.raws[s.raw].origin;
        if (origin.kind != kind) continue;
        take_name(kind == Origin::Kind::line ? input_.lines[origin.index].name
                                             : input_.segments[origin.index].name,
                  segment, graph_.edges[e]);
      }
    }
  }

  /// The first name counts.
  void take_name(const std::string& name, Segment& segment, IndexPair edge) {
    const std::uint32_t index = name_index(name);
    if (segment.name == 0) segment.name = index;
    if (index != 0 && segment.name != index) lost_[{index, segment.name}].push_back(edge);
  }

  void warn_of_lost_names() {
    for (const auto& [names, edges] : lost_) {
      const Point a = network_.points[edges[0][0]], b = network_.points[edges[0][1]];
      notes_.push_back({Note::Kind::warning,
                        kVoid,
                        fmt::format("'{0}' and '{1}' both lie on {2}, first from {3} to {4}: "
                                    "there '{1}' counts",
                                    pslg_.names[names.first], pslg_.names[names.second],
                                    counted(edges.size(), "segment"), describe(a), describe(b)),
                        {a, b}});
    }
  }

  std::uint32_t name_index(const std::string& name) {
    const auto [entry, is_new] =
        name_index_.emplace(name, static_cast<std::uint32_t>(pslg_.names.size()));
    if (is_new) pslg_.names.push_back(name);
    return entry->second;
  }

  /// The seed of a polygon is the one of the same index.
  static std::uint32_t seed_of(std::uint32_t polygon) { return polygon == kNone ? 0 : polygon + 1; }

  void add_polygon_seeds() {
    for (const InputPolygon& polygon : input_.polygons) {
      RegionSeed seed;
      if (!polygon.rings.empty() && !polygon.rings[0].empty()) seed.at = polygon.rings[0][0];
      seed.material = polygon.material;
      seed.region = polygon.region;
      seed.id = polygon.id;
      seed.feature = polygon.feature;
      pslg_.seeds.push_back(std::move(seed));
    }
  }

  const Input& input_;
  const Network& network_;
  const EdgeGraph& graph_;
  const std::vector<EdgeOwners>& owners_;
  std::vector<Note>& notes_;
  Pslg pslg_;
  std::vector<VertexId> vertex_;  ///< by point of the network
  std::map<std::string, std::uint32_t> name_index_{{"", 0}};
  /// By two names: the edges that have the second one although the first lies on them too.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<IndexPair>> lost_;
};

}  // namespace

Pslg assemble(const Input& input, const Network& network, const EdgeGraph& graph,
              const std::vector<EdgeOwners>& owners, std::vector<Note>& notes) {
  return Assembler(input, network, graph, owners, notes).assemble();
}

}  // namespace cover
