// The faces are walked along a tree that spans their neighbourhood, starting outside, where nothing
// covers. Crossing an edge flips every polygon that has an odd number of strands on it, so the set
// of covering polygons is kept up to date step by step and never built anew.
// Tested by tests/unit/clean/paint/paint_test.cpp.
#include "clean/paint/paint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/containers/union_find.hpp"
#include "base/faults/complaint.hpp"
#include "faces/face_measures.hpp"
#include "faces/faces.hpp"

namespace cover {

std::vector<std::uint32_t> ranks_of(const std::vector<InputPolygon>& polygons, Overlap overlap) {
  std::vector<std::uint32_t> order(polygons.size()), rank(polygons.size());
  for (std::uint32_t p = 0; p < order.size(); ++p) order[p] = p;
  if (overlap == Overlap::first) std::reverse(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
    return polygons[p].priority.value_or(0) < polygons[q].priority.value_or(0);
  });
  for (std::uint32_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  return rank;
}

std::uint64_t comparable_value(const Attribute& attribute, std::uint32_t feature) {
  const double none = attribute.is_text ? 0 : std::numeric_limits<double>::quiet_NaN();
  const double value = feature > 0 ? attribute.values[feature - 1] : none;
  return std::bit_cast<std::uint64_t>(std::isnan(value) ? none : value + 0.0);  // -0 is 0
}

namespace {

std::vector<std::uint64_t> kept_values(const Input& input, const InputPolygon& polygon) {
  std::vector<std::uint64_t> out;
  for (const Attribute& attribute : input.attributes)
    out.push_back(comparable_value(attribute, polygon.feature));
  return out;
}

/// By polygon: a number that it shares with those that make one region with it where they touch.
std::vector<std::uint32_t> kinds(const Input& input, bool merge) {
  using Kind =
      std::tuple<std::string, std::string, std::optional<double>, std::vector<std::uint64_t>>;
  std::map<Kind, std::uint32_t> first;
  std::vector<std::uint32_t> out;
  for (std::uint32_t p = 0; p < input.polygons.size(); ++p) {
    const InputPolygon& polygon = input.polygons[p];
    if (merge ? polygon.material.empty() : polygon.region.empty()) {
      out.push_back(p);
      continue;
    }
    Kind kind{polygon.material, {}, {}, {}};
    if (!merge)
      kind = {polygon.material, polygon.region, polygon.size, kept_values(input, polygon)};
    out.push_back(first.emplace(std::move(kind), p).first->second);
  }
  return out;
}

/// Whether a segment or a line of the input lies on an edge.
bool is_forced(const Network& network, const EdgeGraph& graph, std::size_t edge) {
  const auto strands = graph.strands(network, edge);
  return std::any_of(strands.begin(), strands.end(), [&](const Strand& s) {
    return network.raws[s.raw].origin.kind != Origin::Kind::ring;
  });
}

/// The polygons that an edge flips.
std::vector<std::uint32_t> flips(const Network& network, const EdgeGraph& graph, std::size_t edge) {
  std::vector<std::uint32_t> out;
  for (const Strand& s : graph.strands(network, edge)) {
    const Origin origin = network.raws[s.raw].origin;
    if (origin.kind == Origin::Kind::ring) out.push_back(origin.index);
  }
  std::sort(out.begin(), out.end());
  std::vector<std::uint32_t> odd;
  for (const std::uint32_t p : out) {
    if (!odd.empty() && odd.back() == p) {
      odd.pop_back();
    } else {
      odd.push_back(p);
    }
  }
  return odd;
}

/// Walks over all faces.
class Painter {
 public:
  Painter(const Input& input, Overlap overlap, const Network& network, const EdgeGraph& graph)
      : input_(input),
        overlap_(overlap),
        network_(network),
        graph_(graph),
        faces_(faces_of(graph.triangulation, graph.edges, false)),
        rank_(ranks_of(input.polygons, overlap)),
        clashes_(ErrorCode::overlapping_polygons, input.source) {}

  Result<Painting> run(bool merge) {
    link_faces();
    walk();
    if (!clashes_.empty()) return clashes_.error();
    Painting out;
    out.owners = beside_edges(owner_);
    const std::vector<std::uint32_t> first = first_owners(merge);
    out.regions = beside_edges(first);
    out.sizes = smallest_sizes(first);
    return out;
  }

 private:
  [[nodiscard]] std::vector<EdgeOwners> beside_edges(
      const std::vector<std::uint32_t>& by_face) const {
    std::vector<EdgeOwners> out;
    out.reserve(graph_.edges.size());
    for (const auto& [left, right] : faces_.of_segment) {
      out.push_back({by_face[left], by_face[right]});
    }
    return out;
  }

  /// By polygon; see Painting::sizes. `first`: by face.
  [[nodiscard]] std::vector<std::optional<double>> smallest_sizes(
      const std::vector<std::uint32_t>& first) const {
    std::vector<std::optional<double>> out(input_.polygons.size());
    for (std::uint32_t f = 0; f < faces_.count; ++f) {
      if (owner_[f] == kNone || !input_.polygons[owner_[f]].size) continue;
      const double wished = *input_.polygons[owner_[f]].size;
      std::optional<double>& size = out[first[f]];
      size = std::min(wished, size.value_or(wished));
    }
    return out;
  }

  /// By face: the first owner of a face in the same region.
  [[nodiscard]] std::vector<std::uint32_t> first_owners(bool merge) const {
    const std::vector<std::uint32_t> kind = kinds(input_, merge);
    UnionFind regions(faces_.count);
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      const auto [left, right] = faces_.of_segment[e];
      const std::uint32_t p = owner_[left], q = owner_[right];
      if (p == kNone || q == kNone || kind[p] != kind[q]) continue;
      if (!is_forced(network_, graph_, e)) regions.unite(left, right);
    }
    std::vector<std::uint32_t> out(faces_.count, kNone);
    for (std::uint32_t f = 0; f < faces_.count; ++f) {
      std::uint32_t& first = out[regions.find(f)];
      first = std::min(first, owner_[f]);
    }
    for (std::uint32_t f = 0; f < faces_.count; ++f) out[f] = out[regions.find(f)];
    return out;
  }

  /// Sorts the edges by the faces beside them.
  void link_faces() {
    first_.assign(faces_.count + 1, 0);
    for (const auto& [left, right] : faces_.of_segment) {
      ++first_[left + 1];
      ++first_[right + 1];
    }
    for (std::size_t f = 0; f < faces_.count; ++f) first_[f + 1] += first_[f];
    edges_.resize(2 * graph_.edges.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
      for (const std::uint32_t face : faces_.of_segment[e]) edges_[next[face]++] = e;
    }
  }

  /// Depth first from the outside; going back over an edge undoes its flips.
  void walk() {
    struct Step {
      std::uint32_t face;
      std::uint32_t edge;  ///< by which it was entered
      std::size_t next;    ///< edge of the face to try next
    };
    owner_.assign(faces_.count, kNone);
    std::vector<bool> seen(faces_.count, false);
    seen[kOutside] = true;
    std::vector<Step> path{{kOutside, kNone, first_[kOutside]}};
    while (!path.empty()) {
      Step& here = path.back();
      if (here.next == first_[here.face + 1]) {
        if (here.edge != kNone) flip(here.edge);
        path.pop_back();
        continue;
      }
      const std::uint32_t edge = edges_[here.next++];
      const auto [left, right] = faces_.of_segment[edge];
      const std::uint32_t there = left == here.face ? right : left;
      if (seen[there]) continue;
      seen[there] = true;
      flip(edge);
      enter(there);
      path.push_back({there, edge, first_[there]});
    }
  }

  void flip(std::uint32_t edge) {
    for (const std::uint32_t p : flips(network_, graph_, edge)) {
      const std::pair<std::uint32_t, std::uint32_t> entry{rank_[p], p};
      if (!covering_.insert(entry).second) covering_.erase(entry);
    }
  }

  void enter(std::uint32_t face) {
    if (covering_.empty()) return;
    const auto top = covering_.rbegin();
    owner_[face] = top->second;
    if (overlap_ != Overlap::error || covering_.size() < 2) return;
    const std::uint32_t p = std::next(top)->second, q = top->second;
    if (input_.polygons[p].priority.value_or(0) == input_.polygons[q].priority.value_or(0)) {
      clash(face, p, q);
    }
  }

  /// Two polygons of equal priority cover `face`.
  void clash(std::uint32_t face, std::uint32_t p, std::uint32_t q) {
    if (!clashing_.insert(std::minmax(p, q)).second) return;
    if (measures_.empty()) measures_ = measure_faces(faces_);
    const Point at = measures_[face].inside.value_or(measures_[face].smallest_side.first);
    clashes_.add(
        fmt::format("{} and {} overlap at ({}, {})", name_of_polygon(input_, p),
                    name_of_polygon(input_, q), at.x, at.y),
        {at}, {ref_of(input_, {Origin::Kind::ring, p}), ref_of(input_, {Origin::Kind::ring, q})});
  }

  const Input& input_;
  Overlap overlap_;
  const Network& network_;
  const EdgeGraph& graph_;
  Faces faces_;
  std::vector<std::uint32_t> rank_;
  std::vector<std::size_t> first_;  ///< by face: its edges in edges_
  std::vector<std::uint32_t> edges_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> covering_;  ///< rank and polygon
  std::vector<std::uint32_t> owner_;                            ///< by face
  Complaint clashes_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> clashing_;
  std::vector<FaceMeasure> measures_;  ///< only made for complaints
};

}  // namespace

Result<Painting> paint(const Input& input, Overlap overlap, bool merge, const Network& network,
                       const EdgeGraph& graph) {
  return Painter(input, overlap, network, graph).run(merge);
}

}  // namespace cover
