// The mesh is built straight into OpenMesh's arrays. Its add_face() looks for the edges around both
// ends of each new edge and relinks the boundary after each face; here all faces are known at once,
// so edges are paired by a sort, and the links along the boundary are set once, at the end:
//
//   1. an edge is made when its first half-edge comes by, in the order of the faces;
//   2. around a boundary vertex lie one or more fans of triangles with void between. The boundary
//      half-edge that arrives at the first edge of a fan goes on along the last edge of the fan
//      before it. Several fans (regions that meet only in this point) are put in the order of
//      their directions, so that the boundary loops are those of the void.
//
// Tested by tests/unit/mesh/stitch_test.cpp.
#include "mesh/mesh_builder.hpp"

#include <algorithm>

#include <cover/mesh.hpp>

#include "geom/predicates.hpp"

namespace cover {

using Halfedge = TriMesh::HalfedgeHandle;
using Vertex = TriMesh::VertexHandle;

namespace {

Vertex vertex(std::uint32_t v) { return Vertex(static_cast<int>(v)); }

}  // namespace

/// A fan of triangles around a boundary vertex, from its first edge counter-clockwise to its last.
struct MeshBuilder::Fan {
  std::uint32_t vertex = 0;
  std::uint32_t towards = 0;  ///< the other end of the first edge
  Halfedge arriving;          ///< boundary half-edge along the first edge, towards `vertex`
  Halfedge leaving;           ///< boundary half-edge along the last edge
};

MeshBuilder::MeshBuilder(std::span<const Point> points, std::span<const IndexTriple> triangles)
    : points_(points),
      triangles_(triangles),
      pairs_(points.size(), triangles),
      half_edge_(pairs_.size()) {
  number_half_edges();
}

Mesh MeshBuilder::build() const {
  Mesh mesh;
  mesh.tri().resize(points_.size(), edges_, triangles_.size());
  set_points(mesh.tri());
  set_faces(mesh.tri());
  set_boundary(mesh.tri());
  return mesh;
}

TriMesh::EdgeHandle MeshBuilder::edge_between(std::uint32_t a, std::uint32_t b) const {
  std::uint32_t h = pairs_.find(a, b);
  if (h == HalfEdges::kAbsent) h = pairs_.find(b, a);
  return h == HalfEdges::kAbsent ? TriMesh::EdgeHandle() : TriMesh::s_edge_handle(half_edge_[h]);
}

void MeshBuilder::number_half_edges() {
  for (std::uint32_t h = 0; h < pairs_.size(); ++h) {
    const std::uint32_t twin = pairs_.twin(h);
    if (twin < h) {
      half_edge_[h] = Halfedge(half_edge_[twin].idx() + 1);
    } else {
      half_edge_[h] = Halfedge(static_cast<int>(2 * edges_++));
      if (twin == HalfEdges::kAbsent) boundary_.push_back(h);
    }
  }
}

void MeshBuilder::set_points(TriMesh& tri) const {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    tri.set_point(vertex(v), TriMesh::Point(points_[v].x, points_[v].y, 0));
  }
}

void MeshBuilder::set_faces(TriMesh& tri) const {
  for (std::uint32_t h = 0; h < pairs_.size(); ++h) {
    const TriMesh::FaceHandle face(static_cast<int>(h / 3));
    const Halfedge edge = half_edge_[h];
    const Vertex from = vertex(pairs_.source(h));
    tri.set_vertex_handle(edge, vertex(pairs_.target(h)));
    tri.set_vertex_handle(tri.opposite_halfedge_handle(edge), from);
    tri.set_face_handle(edge, face);
    tri.set_next_halfedge_handle(edge, half_edge_[HalfEdges::next(h)]);
    if (h % 3 == 0) tri.set_halfedge_handle(face, edge);  // keeps the order of the corners
    tri.set_halfedge_handle(from, edge);
  }
}

void MeshBuilder::set_boundary(TriMesh& tri) const {
  std::vector<Fan> fans;
  fans.reserve(boundary_.size());
  for (const std::uint32_t h : boundary_) fans.push_back(fan_from(h));
  std::stable_sort(fans.begin(), fans.end(),
                   [](const Fan& f, const Fan& g) { return f.vertex < g.vertex; });
  for (auto first = fans.begin(); first != fans.end();) {
    const auto last =
        std::find_if(first, fans.end(), [&](const Fan& f) { return f.vertex != first->vertex; });
    if (last - first > 1) sort_by_direction({first, last});
    for (auto fan = first; fan != last; ++fan) {
      const auto before = fan == first ? last - 1 : fan - 1;
      tri.set_next_halfedge_handle(fan->arriving, before->leaving);
    }
    // OpenMesh knows a boundary vertex by its half-edge.
    tri.set_halfedge_handle(vertex(first->vertex), first->leaving);
    first = last;
  }
}

/// The fan around the source of `first`, an edge without a triangle on its right.
MeshBuilder::Fan MeshBuilder::fan_from(std::uint32_t first) const {
  std::uint32_t incoming = HalfEdges::previous(first);
  for (std::uint32_t out = pairs_.twin(incoming); out != HalfEdges::kAbsent;
       out = pairs_.twin(incoming)) {
    incoming = HalfEdges::previous(out);
  }
  const auto opposite = [](Halfedge h) { return Halfedge(h.idx() ^ 1); };
  return {pairs_.source(first), pairs_.target(first), opposite(half_edge_[first]),
          opposite(half_edge_[incoming])};
}

/// Counter-clockwise around their common vertex, from straight up on.
void MeshBuilder::sort_by_direction(std::span<Fan> fans) const {
  const Point centre = points_[fans.front().vertex];
  std::sort(fans.begin(), fans.end(), [&](const Fan& f, const Fan& g) {
    const Point p = points_[f.towards], q = points_[g.towards];
    if ((p < centre) != (q < centre)) return p < centre;
    return orientation(centre, p, q) == Sign::positive;
  });
}

}  // namespace cover
