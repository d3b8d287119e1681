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

#include "base/sort_by_team.hpp"
#include "geom/predicates.hpp"

namespace cover {

using Halfedge = TriMesh::HalfedgeHandle;
using Vertex = TriMesh::VertexHandle;

namespace {

constexpr std::size_t kRange = 1 << 15;

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
      half_edge_(opposite_half_edges(points.size(), triangles)) {
  number_half_edges();
}

Mesh MeshBuilder::build(const Team& team, const std::function<void(Mesh&)>& more) const {
  Mesh mesh;
  mesh.tri().resize(points_.size(), edges_, triangles_.size());
  // What each of them sets is no other's.
  constexpr std::size_t kWhole = 2;
  team.each(kWhole + Team::ranges(triangles_.size(), kRange), [&](std::size_t k) {
    if (k == 0) {
      set_homes(mesh.tri());
    } else if (k == 1) {
      set_points(mesh.tri());
      if (more) more(mesh);
    } else {
      const std::size_t first = (k - kWhole) * kRange;
      set_faces(first, std::min(triangles_.size(), first + kRange), mesh.tri());
    }
  });
  set_boundary(team, mesh.tri());
  return mesh;
}

/// In place of their opposites, of which each is looked at once.
void MeshBuilder::number_half_edges() {
  for (std::uint32_t h = 0; h < half_edge_.size(); ++h) {
    const std::uint32_t twin = half_edge_[h];
    if (twin < h) {
      half_edge_[h] = half_edge_[twin] + 1;
    } else {
      half_edge_[h] = static_cast<std::uint32_t>(2 * edges_++);
      if (twin == HalfEdges::kAbsent) boundary_.push_back(half_edge_[h]);
    }
  }
}

void MeshBuilder::set_points(TriMesh& tri) const {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    tri.set_point(vertex(v), TriMesh::Point(points_[v].x, points_[v].y, 0));
  }
}

/// The faces and their half-edges.
void MeshBuilder::set_faces(std::size_t first, std::size_t last, TriMesh& tri) const {
  for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
    const TriMesh::FaceHandle face(static_cast<int>(t));
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Halfedge edge = halfedge(3 * t + i);
      tri.set_vertex_handle(edge, vertex(triangles_[t][(i + 1) % 3]));
      tri.set_face_handle(edge, face);
      tri.set_next_halfedge_handle(edge, halfedge(3 * t + (i + 1) % 3));
      if (i == 0) tri.set_halfedge_handle(face, edge);  // keeps the order of the corners
    }
  }
}

/// Of each vertex the half-edge that leaves it in its last face.
void MeshBuilder::set_homes(TriMesh& tri) const {
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i)
      tri.set_halfedge_handle(vertex(triangles_[t][i]), halfedge(3 * t + i));
  }
}

void MeshBuilder::set_boundary(const Team& team, TriMesh& tri) const {
  std::vector<Fan> fans(boundary_.size());
  team.each_range(boundary_.size(), kRange, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Halfedge inside(static_cast<int>(boundary_[k]));
      const Halfedge before = tri.next_halfedge_handle(tri.next_halfedge_handle(inside));
      tri.set_vertex_handle(tri.opposite_halfedge_handle(inside), tri.to_vertex_handle(before));
    }
  });
  team.each_range(boundary_.size(), kRange, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      fans[k] = fan_from(tri, Halfedge(static_cast<int>(boundary_[k])));
  });
  sort_by_team(
      fans,
      [](const Fan& f, const Fan& g) {
        return f.vertex != g.vertex ? f.vertex < g.vertex : f.arriving < g.arriving;
      },
      team);
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
MeshBuilder::Fan MeshBuilder::fan_from(const TriMesh& tri, Halfedge first) {
  const auto opposite = [](Halfedge h) { return Halfedge(h.idx() ^ 1); };
  Halfedge incoming = tri.prev_halfedge_handle(first);
  for (Halfedge out = opposite(incoming); tri.face_handle(out).is_valid();
       out = opposite(incoming)) {
    incoming = tri.prev_halfedge_handle(out);
  }
  return {static_cast<std::uint32_t>(tri.from_vertex_handle(first).idx()),
          static_cast<std::uint32_t>(tri.to_vertex_handle(first).idx()), opposite(first),
          opposite(incoming)};
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
