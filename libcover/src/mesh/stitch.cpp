// The mesh is built straight into OpenMesh's arrays. Its add_face() looks for the edges around both
// ends of each new edge and relinks the boundary after each face; here all faces are known at once,
// so edges are paired by a sort, and the links along the boundary are set once, at the end:
//
//   1. vertices: those of the PSLG that some region uses, then the Steiner vertices of each region;
//   2. half-edges: an edge is made when its first half-edge comes by, in the order of the faces;
//   3. around a boundary vertex lie one or more fans of triangles with void between. The boundary
//      half-edge that arrives at the first edge of a fan goes on along the last edge of the fan
//      before it. Several fans (regions that meet only in this point) are put in the order of
//      their directions, so that the boundary loops are those of the void.
//
// Tested by tests/unit/mesh/stitch_test.cpp.
#include "mesh/stitch.hpp"

#include <algorithm>

#include "geom/half_edges.hpp"
#include "geom/predicates.hpp"

namespace cover {
namespace {

using Halfedge = TriMesh::HalfedgeHandle;

/// All triangles by global vertex.
struct Gathered {
  std::vector<Point> points;
  std::vector<long> input_ids;           ///< by vertex; -1: Steiner
  std::vector<std::uint32_t> vertex_of;  ///< by VertexId; kNone: not in the mesh
  std::vector<IndexTriple> triangles;
};

void number_input_vertices(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                           Gathered& all) {
  all.vertex_of.assign(pslg.points.size(), kNone);
  for (const RegionBoundary& boundary : boundaries) {
    for (const VertexId v : boundary.vertices) all.vertex_of[v.index()] = 0;
  }
  for (std::size_t v = 0; v < pslg.points.size(); ++v) {
    if (all.vertex_of[v] == kNone) continue;
    all.vertex_of[v] = static_cast<std::uint32_t>(all.points.size());
    all.points.push_back(pslg.points[v]);
    all.input_ids.push_back(static_cast<long>(v));
  }
}

Gathered gather(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                std::span<const RegionMesh> meshes) {
  Gathered all;
  number_input_vertices(pslg, boundaries, all);
  std::size_t triangles = 0, steiner = 0;
  for (const RegionMesh& mesh : meshes) {
    triangles += mesh.triangles.size();
    steiner += mesh.steiner.size();
  }
  all.triangles.reserve(triangles);
  all.points.reserve(all.points.size() + steiner);
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    const std::vector<VertexId>& vertices = boundaries[r].vertices;
    const auto first_steiner = static_cast<std::uint32_t>(all.points.size());
    const auto boundary_size = static_cast<std::uint32_t>(vertices.size());
    all.points.insert(all.points.end(), meshes[r].steiner.begin(), meshes[r].steiner.end());
    for (IndexTriple t : meshes[r].triangles) {
      for (std::uint32_t& v : t) {
        v = v < boundary_size ? all.vertex_of[vertices[v].index()]
                              : first_steiner + (v - boundary_size);
      }
      all.triangles.push_back(t);
    }
  }
  all.input_ids.resize(all.points.size(), -1);
  return all;
}

/// A fan of triangles around a boundary vertex, from its first edge counter-clockwise to its last.
struct Fan {
  std::uint32_t vertex = 0;
  std::uint32_t towards = 0;  ///< the other end of the first edge
  Halfedge arriving;          ///< boundary half-edge along the first edge, towards `vertex`
  Halfedge leaving;           ///< boundary half-edge along the last edge
};

class Builder {
 public:
  explicit Builder(const Gathered& all)
      : all_(all), pairs_(all.points.size(), all.triangles), half_edge_(pairs_.size()) {}

  void build(Mesh& mesh) {
    const std::uint32_t edges = number_half_edges();
    mesh.tri().resize(all_.points.size(), edges, all_.triangles.size());
    set_vertices(mesh);
    set_faces(mesh.tri());
    set_boundary(mesh.tri());
  }

  /// The edge between two vertices, invalid if there is none.
  [[nodiscard]] TriMesh::EdgeHandle edge_between(std::uint32_t a, std::uint32_t b) const {
    std::uint32_t h = pairs_.find(a, b);
    if (h == HalfEdges::kAbsent) h = pairs_.find(b, a);
    return h == HalfEdges::kAbsent ? TriMesh::EdgeHandle() : TriMesh::s_edge_handle(half_edge_[h]);
  }

 private:
  [[nodiscard]] bool on_boundary(std::uint32_t h) const {
    return pairs_.twin(h) == HalfEdges::kAbsent;
  }

  std::uint32_t number_half_edges() {
    int edges = 0;
    for (std::uint32_t h = 0; h < pairs_.size(); ++h) {
      const std::uint32_t twin = pairs_.twin(h);
      if (twin < h) {
        half_edge_[h] = Halfedge(half_edge_[twin].idx() + 1);
      } else {
        half_edge_[h] = Halfedge(2 * edges++);
        if (twin == HalfEdges::kAbsent) boundary_.push_back(h);
      }
    }
    return static_cast<std::uint32_t>(edges);
  }

  void set_vertices(Mesh& mesh) const {
    for (std::size_t v = 0; v < all_.points.size(); ++v) {
      const TriMesh::VertexHandle handle(static_cast<int>(v));
      mesh.tri().set_point(handle, TriMesh::Point(all_.points[v].x, all_.points[v].y, 0));
      mesh.set_input_id(handle, all_.input_ids[v]);
    }
  }

  void set_faces(TriMesh& tri) const {
    for (std::uint32_t h = 0; h < pairs_.size(); ++h) {
      const TriMesh::FaceHandle face(static_cast<int>(h / 3));
      const Halfedge edge = half_edge_[h];
      const TriMesh::VertexHandle from(static_cast<int>(pairs_.source(h)));
      tri.set_vertex_handle(edge, TriMesh::VertexHandle(static_cast<int>(pairs_.target(h))));
      tri.set_vertex_handle(tri.opposite_halfedge_handle(edge), from);
      tri.set_face_handle(edge, face);
      tri.set_next_halfedge_handle(edge, half_edge_[HalfEdges::next(h)]);
      tri.set_halfedge_handle(face, edge);
      tri.set_halfedge_handle(from, edge);
    }
  }

  void set_boundary(TriMesh& tri) const {
    std::vector<Fan> fans;
    fans.reserve(boundary_.size());
    for (const std::uint32_t h : boundary_) fans.push_back(fan_from(h, tri));
    std::stable_sort(fans.begin(), fans.end(),
                     [](const Fan& f, const Fan& g) { return f.vertex < g.vertex; });
    for (auto first = fans.begin(); first != fans.end();) {
      const auto last =
          std::find_if(first, fans.end(), [&](const Fan& f) { return f.vertex != first->vertex; });
      if (last - first > 1) sort_by_direction(first, last);
      for (auto fan = first; fan != last; ++fan) {
        const auto before = fan == first ? last - 1 : fan - 1;
        tri.set_next_halfedge_handle(fan->arriving, before->leaving);
      }
      // OpenMesh knows a boundary vertex by its half-edge.
      tri.set_halfedge_handle(TriMesh::VertexHandle(static_cast<int>(first->vertex)),
                              first->leaving);
      first = last;
    }
  }

  /// The fan around the source of `first`, an edge without a triangle on its right.
  [[nodiscard]] Fan fan_from(std::uint32_t first, const TriMesh& tri) const {
    Fan fan{pairs_.source(first), pairs_.target(first),
            tri.opposite_halfedge_handle(half_edge_[first]), Halfedge()};
    std::uint32_t incoming = HalfEdges::previous(first);
    for (std::uint32_t out = pairs_.twin(incoming); out != HalfEdges::kAbsent && out != first;
         out = pairs_.twin(incoming)) {
      incoming = HalfEdges::previous(out);
    }
    fan.leaving = tri.opposite_halfedge_handle(half_edge_[incoming]);
    return fan;
  }

  /// Counter-clockwise around their common vertex, from straight up on.
  void sort_by_direction(std::vector<Fan>::iterator first, std::vector<Fan>::iterator last) const {
    const Point centre = all_.points[first->vertex];
    std::sort(first, last, [&](const Fan& f, const Fan& g) {
      const Point p = all_.points[f.towards], q = all_.points[g.towards];
      if ((p < centre) != (q < centre)) return p < centre;
      return orientation(centre, p, q) == Sign::positive;
    });
  }

  const Gathered& all_;
  HalfEdges pairs_;
  std::vector<Halfedge> half_edge_;      ///< OpenMesh's, by ours
  std::vector<std::uint32_t> boundary_;  ///< half-edges without a twin
};

void set_regions(const RegionTable& table, std::span<const RegionMesh> meshes, Mesh& mesh) {
  int face = 0;
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    for (std::size_t k = 0; k < meshes[r].triangles.size(); ++k, ++face) {
      mesh.set_region(TriMesh::FaceHandle(face), table.regions[r].id);
      mesh.set_material(TriMesh::FaceHandle(face), table.regions[r].material);
    }
  }
}

void set_segments(const Pslg& pslg, const RegionTable& table, const Gathered& all,
                  const Builder& builder, Mesh& mesh) {
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
    const std::uint32_t a = all.vertex_of[pslg.segments[s].a.index()];
    const std::uint32_t b = all.vertex_of[pslg.segments[s].b.index()];
    if (a == kNone || b == kNone) continue;
    const TriMesh::EdgeHandle edge = builder.edge_between(a, b);
    if (!edge.is_valid()) continue;
    mesh.set_interface(edge, table.sides[s].interface);
    mesh.set_marker(edge, pslg.segments[s].marker);
  }
}

}  // namespace

Mesh stitch(const Pslg& pslg, const RegionTable& table, std::span<const RegionBoundary> boundaries,
            std::span<const RegionMesh> meshes) {
  const Gathered all = gather(pslg, boundaries, meshes);
  Mesh mesh;
  Builder builder(all);
  builder.build(mesh);
  set_regions(table, meshes, mesh);
  set_segments(pslg, table, all, builder, mesh);
  return mesh;
}

}  // namespace cover
