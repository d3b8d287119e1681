// A segment that is no edge of the mesh is followed from vertex to vertex; a vertex that is a point
// of the input already lies on no other segment, so no way leads through it.
// Tested by tests/unit/cuts/adopt_cuts_test.cpp.
#include <cover/adopt_cuts.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cuts/cut_segments.hpp"
#include "cuts/renumber_points.hpp"
#include "geom/curves/arc.hpp"
#include "geom/topology/soup_edges.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

class Adopter {
 public:
  Adopter(Pslg& pslg, RegionTable& table, const TriangleSoup& mesh)
      : pslg_(pslg),
        table_(table),
        mesh_(mesh),
        edges_(mesh),
        is_input_(mesh.points.size(), false) {
    double largest = 0;
    for (const Point& p : pslg.points) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
      vertex_.push_back(edges_.vertex_at(p));
      if (vertex_.back()) is_input_[*vertex_.back()] = true;
    }
    offset_ = offset_on_segment(largest);
  }

  std::size_t run() {
    const std::size_t before = pslg_.points.size();
    std::vector<SegmentCut> cuts;
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s) {
      std::vector<std::uint32_t> on_it = vertices_on_arc(s);
      if (on_it.empty()) {
        on_it = vertices_on(s);
        if (!on_it.empty()) straighten(pslg_.segments[s]);
      }
      if (on_it.empty()) continue;
      cuts.push_back({SegmentId{s}, {}});
      for (const std::uint32_t v : on_it) {
        cuts.back().points.push_back(mesh_.points[v]);
        vertex_.emplace_back(v);
      }
    }
    cut_segments(pslg_, table_, cuts);
    order_as_in_mesh();
    return pslg_.points.size() - before;
  }

 private:
  /// The vertices inside a segment, from its end a to its end b.
  [[nodiscard]] std::vector<std::uint32_t> vertices_on(std::size_t s) const {
    const Segment& segment = pslg_.segments[s];
    const auto a = vertex_[segment.a.index()], b = vertex_[segment.b.index()];
    const SegmentSides& sides = table_.sides[s];
    if (!a || !b || (sides.left == kVoid && sides.right == kVoid)) return {};
    const bool forward = sides.left != kVoid;  // edges have their triangle on the left
    const std::uint32_t from = forward ? *a : *b, to = forward ? *b : *a;
    std::vector<std::uint32_t> vertices;
    const SoupEdges::Banks banks = forward ? SoupEdges::Banks::of(sides.left, sides.right)
                                           : SoupEdges::Banks::of(sides.right, sides.left);
    const auto whole = edges_.find(from, to);
    if (whole && edges_.lies_between(edges_.all()[*whole], banks)) return {};
    // Else the cuts may lie beside that edge, by rounding.
    const auto way = whole ? edges_.along_between(from, to, offset_, is_input_, false, banks)
                           : edges_.along(from, to, offset_, is_input_, false, banks);
    for (const std::size_t edge : way) vertices.push_back(edges_.all()[edge].to);
    if (vertices.empty()) return {};
    vertices.pop_back();  // the segment's end
    if (!forward) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }

  /// The vertices on the arc over a chord, from its end a to its end b: the nearest one along the
  /// arc follows each. Between two of them there may be others on the chord.
  [[nodiscard]] std::vector<std::uint32_t> vertices_on_arc(std::size_t s) const {
    const Segment& segment = pslg_.segments[s];
    const ArcCircle* circle = circle_of(pslg_, segment);
    const auto a = vertex_[segment.a.index()], b = vertex_[segment.b.index()];
    const SegmentSides& sides = table_.sides[s];
    if (circle == nullptr || !a || !b || (sides.left == kVoid && sides.right == kVoid)) return {};
    const bool forward = sides.left != kVoid;
    const std::uint32_t from = forward ? *a : *b, to = forward ? *b : *a;
    const ArcOver arc(*circle, mesh_.points[from], mesh_.points[to]);
    const std::vector<std::int64_t>* labels = labels_apart(sides);
    std::vector<std::uint32_t> vertices{from};
    for (double done = 0; done < 1;) {
      const std::vector<std::uint32_t> way = way_to_next(arc, vertices.back(), to, labels, done);
      if (way.empty()) return {};
      vertices.insert(vertices.end(), way.begin(), way.end());
    }
    vertices.erase(vertices.begin());
    vertices.pop_back();  // the segment's end
    if (!forward) std::reverse(vertices.begin(), vertices.end());
    return vertices;
  }

  /// What tells the triangles on both sides of a segment apart; nullptr if nothing does. An edge
  /// inside a region may lead to a vertex of the arc by chance, and past others on its chord.
  [[nodiscard]] const std::vector<std::int64_t>* labels_apart(const SegmentSides& sides) const {
    if (sides.left == sides.right) return nullptr;
    if (!mesh_.region.empty()) return &mesh_.region;
    if (mesh_.material.empty()) return nullptr;
    const bool is_outer = sides.left == kVoid || sides.right == kVoid;
    const auto material = [&](RegionId r) { return table_.region(r).material; };
    const bool differ = is_outer || material(sides.left) != material(sides.right);
    return differ ? &mesh_.material : nullptr;
  }

  /// Whether `edge` has triangles of different labels on its sides, or none on its right.
  [[nodiscard]] bool is_border(const SoupEdges::Edge& edge,
                               const std::vector<std::int64_t>* labels) const {
    if (labels == nullptr) return true;
    const auto twin = edges_.find(edge.to, edge.from);
    return !twin || (*labels)[edge.triangle] != (*labels)[edges_.all()[*twin].triangle];
  }

  /// The straight way over borders from `here` to the nearest vertex of the arc beyond the share
  /// `done` of it, which moves there; `to` is the arc's end.
  [[nodiscard]] std::vector<std::uint32_t> way_to_next(const ArcOver& arc, std::uint32_t here,
                                                       std::uint32_t to,
                                                       const std::vector<std::int64_t>* labels,
                                                       double& done) const {
    std::vector<std::uint32_t> best;
    double nearest = 0;
    for (const SoupEdges::Edge& edge : edges_.leaving(here)) {
      if (!is_border(edge, labels)) continue;
      const std::vector<std::uint32_t> way = straight_way(arc, here, edge.to, to, labels);
      if (way.empty()) continue;
      const double share = way.back() == to ? 1 : arc.share_of(mesh_.points[way.back()]);
      if (share <= done || share > 1 || (!best.empty() && share >= nearest)) continue;
      best = way;
      nearest = share;
    }
    done = nearest;
    return best;
  }

  /// From `next`, a neighbour of `here`, on in the same direction up to a vertex of the arc; empty
  /// if there is none, or a point of the input is in the way.
  [[nodiscard]] std::vector<std::uint32_t> straight_way(
      const ArcOver& arc, std::uint32_t here, std::uint32_t next, std::uint32_t to,
      const std::vector<std::int64_t>* labels) const {
    const Point start = mesh_.points[here];
    const Vector along = mesh_.points[next] - start;
    std::vector<std::uint32_t> way{next};
    while (way.back() != to) {
      const std::uint32_t v = way.back();
      if (is_input_[v]) return {};
      if (arc.is_on_circle(mesh_.points[v])) break;
      const double share = arc.share_of(mesh_.points[v]);
      if (share < 0 || share > 1) return {};
      std::optional<std::uint32_t> following;
      for (const SoupEdges::Edge& edge : edges_.leaving(v)) {
        const Vector step = mesh_.points[edge.to] - start;
        if (is_border(edge, labels) && dot(along, step) > dot(along, mesh_.points[v] - start) &&
            std::abs(cross(along, step)) <= offset_ * length(step))  // off the line as it was begun
          following = edge.to;
      }
      if (!following) return {};
      way.push_back(*following);
    }
    return way;
  }

  void order_as_in_mesh() {
    std::vector<std::size_t> places, order;
    for (std::size_t v = 0; v < vertex_.size(); ++v) {
      if (vertex_[v]) places.push_back(v);
    }
    order = places;
    std::sort(order.begin(), order.end(),
              [&](std::size_t u, std::size_t v) { return *vertex_[u] < *vertex_[v]; });
    if (order == places) return;
    std::vector<VertexId> new_ids;
    for (std::size_t v = 0; v < vertex_.size(); ++v) new_ids.emplace_back(v);
    for (std::size_t k = 0; k < order.size(); ++k) new_ids[order[k]] = VertexId{places[k]};
    renumber_points(pslg_, table_, new_ids);
  }

  Pslg& pslg_;
  RegionTable& table_;
  const TriangleSoup& mesh_;
  SoupEdges edges_;
  std::vector<bool> is_input_;                        ///< by vertex of the mesh
  std::vector<std::optional<std::uint32_t>> vertex_;  ///< of the mesh, by VertexId
  double offset_ = 0;
};

}  // namespace

std::size_t adopt_cuts(Pslg& pslg, RegionTable& table, const TriangleSoup& mesh) {
  return Adopter(pslg, table, mesh).run();
}

}  // namespace cover
