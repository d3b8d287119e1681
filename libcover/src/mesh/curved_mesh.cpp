// Straight triangles are valid, and an edge that is made straight only takes away what is curved;
// so edges of triangles that are not proven are made straight until all are.
// Tested by tests/unit/mesh/curved_mesh_test.cpp.
#include <cover/curved_mesh.hpp>

#include <algorithm>
#include <limits>
#include <optional>

#include <cover/mesh.hpp>

#include "geom/arc.hpp"
#include "geom/vector.hpp"

namespace cover {
namespace {

constexpr std::uint32_t kNotCurved = std::numeric_limits<std::uint32_t>::max();

class Curving {
 public:
  explicit Curving(const Output& output)
      : output_(output), tri_(output.mesh.tri()), number_(tri_.n_edges(), kNotCurved) {}

  CurvedMesh run() {
    find_edges();
    straighten_unproven();
    add_areas();
    return std::move(curved_);
  }

 private:
  using Halfedge = TriMesh::HalfedgeHandle;
  using Face = TriMesh::FaceHandle;

  [[nodiscard]] Point at(TriMesh::VertexHandle v) const {
    const TriMesh::Point& p = tri_.point(v);
    return {p[0], p[1]};
  }

  void find_edges() {
    const Pslg& pslg = output_.pslg;
    std::vector<TriMesh::VertexHandle> vertex(pslg.points.size());
    for (const auto v : tri_.vertices()) {
      const long point = output_.mesh.input_id(v);
      if (point >= 0) vertex[static_cast<std::size_t>(point)] = v;
    }
    for (const Segment& s : pslg.segments) {
      const ArcCircle* circle = circle_of(pslg, s);
      if (circle == nullptr) continue;
      const auto a = vertex[s.a.index()], b = vertex[s.b.index()];
      if (!a.is_valid() || !b.is_valid()) continue;  // it touches no region
      const Halfedge h = tri_.find_halfedge(a, b);
      if (!h.is_valid()) continue;
      number_[index_of(h)] = static_cast<std::uint32_t>(curved_.edges.size());
      halfedges_.push_back(h);
      curved_.edges.push_back({static_cast<std::uint32_t>(a.idx()),
                               static_cast<std::uint32_t>(b.idx()), s.circle - 1,
                               ArcOver(*circle, at(a), at(b)).middle(), false});
    }
  }

  static std::size_t index_of(Halfedge h) {
    return static_cast<std::size_t>(TriMesh::s_edge_handle(h).idx());
  }

  [[nodiscard]] CurvedTriangle triangle(Face f) const {
    CurvedTriangle out;
    Halfedge h = tri_.halfedge_handle(f);
    for (std::size_t i = 0; i < 3; ++i, h = tri_.next_halfedge_handle(h)) {
      const std::uint32_t k = number_[index_of(h)];
      out[i] = at(tri_.from_vertex_handle(h));
      // As it is written, and thus as the proof must have it.
      out[3 + i] = k == kNotCurved ? midpoint_of(h) : curved_.edges[k].middle;
    }
    return out;
  }

  /// As files have it: from the end of the edge's first half.
  [[nodiscard]] Point midpoint_of(Halfedge h) const {
    const Halfedge first = TriMesh::s_halfedge_handle(TriMesh::s_edge_handle(h), 0);
    return midpoint(at(tri_.from_vertex_handle(first)), at(tri_.to_vertex_handle(first)));
  }

  void straighten_unproven() {
    std::vector<Face> queue;
    const auto add_faces = [&](Halfedge h) {
      for (const Halfedge side : {h, tri_.opposite_halfedge_handle(h)}) {
        if (tri_.face_handle(side).is_valid()) queue.push_back(tri_.face_handle(side));
      }
    };
    for (const Halfedge h : halfedges_) add_faces(h);
    for (std::size_t k = 0; k < queue.size(); ++k) {
      if (has_positive_jacobian(triangle(queue[k]))) continue;
      Halfedge h = tri_.halfedge_handle(queue[k]);
      for (int i = 0; i < 3; ++i, h = tri_.next_halfedge_handle(h)) {
        const std::uint32_t edge = number_[index_of(h)];
        if (edge == kNotCurved || curved_.edges[edge].is_straight) continue;
        curved_.edges[edge].is_straight = true;
        curved_.edges[edge].middle = midpoint_of(h);
        add_faces(h);
      }
    }
  }

  void add_areas() {
    for (const Region& region : output_.table.regions) curved_.areas.push_back(region.area);
    for (std::size_t k = 0; k < halfedges_.size(); ++k) {
      if (curved_.edges[k].is_straight) continue;
      for (const Halfedge h : {halfedges_[k], tri_.opposite_halfedge_handle(halfedges_[k])}) {
        const Face f = tri_.face_handle(h);
        if (!f.is_valid()) continue;
        curved_.areas[output_.mesh.region(f).index() - 1] += area_beside_chord(
            at(tri_.from_vertex_handle(h)), at(tri_.to_vertex_handle(h)), curved_.edges[k].middle);
      }
    }
  }

  const Output& output_;
  const TriMesh& tri_;
  std::vector<std::uint32_t> number_;  ///< by edge of the mesh: in curved_.edges, or kNotCurved
  std::vector<Halfedge> halfedges_;    ///< by curved edge, from a to b
  CurvedMesh curved_;
};

}  // namespace

CurvedMesh curved_mesh(const Output& output) { return Curving(output).run(); }

}  // namespace cover
